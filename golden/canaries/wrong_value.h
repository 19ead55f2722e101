#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::golden {

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
