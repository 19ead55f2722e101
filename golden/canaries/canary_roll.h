#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/golden/suite.h"
#include "tumble/golden/suite_result.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// How canaries are asked: in the shard that they fall to, and of values with a slip each.
namespace tumble::golden {

/// The canaries of a check by name, and the results of those that fall to one shard of it, both in one order. A canary
/// is named whether it is asked or not, so that each shard knows those of all; asking is left to the shard whose name
/// it is, by the rule that assigns cases.
class CanaryRoll {
 public:
  CanaryRoll(std::size_t shard, std::size_t shards) : shard_(shard), shards_(shards) {}

  /// Names the next canary; true if it falls to this shard: then add() its result before the roll ends.
  bool falls_here(const std::string& name) {
    names_.push_back(name);
    return shard_of_name(name, shards_) == shard_;
  }
  void add(CanaryResult result) { results_.push_back(std::move(result)); }

  /// A canary that judges itself. ask: gives its result, under any name; called if it falls here.
  template <class Ask>
  void ask(const std::string& name, Ask&& ask_it) {
    if (!falls_here(name)) return;
    CanaryResult result = ask_it();
    result.name = name;
    add(std::move(result));
  }

  /// A canary whose answer is known. find: gives the answer as a text; called if it falls here.
  template <class Find>
  void known(const std::string& name, Find&& find, std::string_view wanted = "as known") {
    ask(name, [&] {
      const std::string found = find();
      return CanaryResult{name, found == wanted, found == wanted ? "as known" : found};
    });
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const std::vector<CanaryResult>& results() const { return results_; }

 private:
  std::size_t shard_, shards_;
  std::vector<std::string> names_;
  std::vector<CanaryResult> results_;
};

/// A canary that this machine has not what it takes to ask.
inline CanaryResult not_asked(std::string why) { return {"", false, std::move(why), "suite", false}; }

/// A value spoilt in one place, and what who takes it is told: "taken", or the whole message.
template <class Value>
struct WrongValue {
  const char* name;
  std::function<void(Value&)> spoil;
  const char* message;
};

inline std::string status_text(const Status& status) { return status.ok() ? "taken" : status.error().message; }

template <class Value>
Status status_of(const Result<Value>& result) {
  return result.ok() ? Status() : Status(result.error());
}

/// Asks for everything that is wrong; the first answer that is not the known one, "as known" if all are.
template <class Value, class Take>
std::string ask_all(const std::vector<WrongValue<Value>>& all, const Value& good, Take take) {
  for (const WrongValue<Value>& one : all) {
    Value value = good;
    one.spoil(value);
    const std::string found = status_text(take(value));
    if (found != one.message) return std::string(one.name) + ": " + found;
  }
  return "as known";
}

/// A crate on the ground, one on it, a static box: enough for contacts, pairs and contact objects.
inline sim::SceneDef three_crates(sim::Method method) {
  sim::SceneDef scene;
  scene.world.method = method;
  scene.world.substeps = 2;
  for (std::uint64_t id = 1; id <= 3; ++id) {
    sim::BoxDef& box = scene.boxes.emplace_back();
    box.id = id;
    box.position = {id == 3 ? 1.5 : 0.0, 0, id == 2 ? 1.5 : 0.5};
    box.is_static = id == 3;
  }
  scene.boxes[0].frozen = true;
  return scene;
}

}  // namespace tumble::golden
