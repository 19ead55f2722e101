#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/replay/step_record.h"
#include "tumble/sim/ids.h"

/// Values of another engine that the scene of a log cannot hold. The scene holds the nearest that it can; what was told
/// stands in channels of these names, so that two sessions that were told different values differ.
namespace tumble::replay {

/// "told.mass", "told.position.x", …: the names that such channels have. A second value of a body in one step is
/// "told.push.x#2".
inline constexpr std::string_view kToldPrefix = "told.";

/// Whether a recorder's stream keeps told values under this name, which no channel of an engine gets there.
bool is_told_name(std::string_view name);

/// Every such name.
std::vector<std::string> told_names();

/// How ToldWatch::note() begins.
inline constexpr std::string_view kToldNote = "the scene of the log is cut to what a scene can hold";

/// How ToldWatch::impossible() begins.
inline constexpr std::string_view kToldImpossible = "told what cannot be";

/// The values that one step was told and its log had to cut, by channel and body (0: of the world).
using ToldValues = std::map<std::pair<std::string, sim::BodyId>, double>;

/// Watches the steps of a log for told values.
class ToldWatch {
 public:
  explicit ToldWatch(const LogHeader& header);

  /// The values of the start, or of a step, in order.
  void add(std::uint64_t step, const Extras& extras);
  void add(const StepRecord& record) { add(record.step, record.extras); }

  /// "told what cannot be: body 1 was told mass -5 at step 0 (channel told.mass)", and the number of further such
  /// values; empty without one. Not finite, a negative mass, size or friction, an orientation that is no rotation.
  [[nodiscard]] std::string impossible() const;

  /// "the scene of the log is cut to what a scene can hold: body 1 …", of all values, possible or not.
  [[nodiscard]] std::string note() const;

 private:
  struct Found {
    std::string text;
    std::uint64_t count = 0;
  };
  std::vector<std::pair<std::size_t, std::string>> channels_;  // index in the log, name without the prefix
  Found all_;
  Found impossible_;
};

}  // namespace tumble::replay
