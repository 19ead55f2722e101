#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "replay/stream/stream_step.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The bodies of a stream in SI units, z up, as logs hold them.
namespace tumble::replay {

/// Converts bodies, states and inputs, and keeps the last state of each body, which records of kind "same" refer to.
class StreamBodies {
 public:
  explicit StreamBodies(const EngineAxes& axes) : axes_(axes) {}

  /// A body that begins or appears. A shape becomes the box around it; an edge beyond the limits of a log is cut to
  /// them, and a static body without a mass has 1 kg: notes() tells.
  sim::BoxDef add(const StreamBody& body);

  /// An input for a log; none for one that only the engine understands. Bodies are added and removed here too.
  std::optional<sim::Command> command(const StreamInput& input);

  /// The name and the shape of a body for a log; none for a box without a name. A hull and a mesh are known by a hash
  /// alone, so they have no shape there.
  struct Description {
    BodyInfo info;
    std::optional<Shape> shape;
  };
  [[nodiscard]] std::optional<Description> describe(const StreamBody& body) const;

  /// The state that a record tells. Errors (kBadInput): "same" of a body that had no state.
  Result<EngineState> state(const StreamState& state);

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const EngineAxes& axes() const { return axes_; }

 private:
  [[nodiscard]] EngineState converted(const StreamNumbers& numbers, bool asleep) const;
  double edge(std::uint64_t id, double length);

  EngineAxes axes_;
  std::map<std::uint64_t, EngineState> last_;
  std::vector<std::string> notes_;
};

}  // namespace tumble::replay
