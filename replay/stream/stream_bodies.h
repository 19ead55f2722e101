#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "replay/import/table_notes.h"
#include "replay/stream/stream_step.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The bodies of a stream in SI units, z up, as logs hold them.
namespace tumble::replay {

/// A name as a log keeps it: without control characters, of at most 200 bytes, or fewer.
std::string name_for_log(const std::string& name, std::size_t bytes_max = kStreamNameBytesMax);

/// Converts bodies, states and inputs, and keeps the last state of each body, which records of kind "same" refer to.
class StreamBodies {
 public:
  explicit StreamBodies(const EngineAxes& axes) : axes_(axes) {}

  /// Takes a surface for the bodies with its hash, before any of them. One that no log can keep is left out: notes()
  /// tells.
  void add(const StreamMesh& mesh);

  /// Mends the sizes of the bodies of a step that no shape can have, before they are added: notes() tells. A negative
  /// one is taken without its sign.
  void keep_sizes(StreamStep& step);

  /// A gravity of the engine in m/s², cut to the limits of a log: notes() tells.
  sim::Vec3 gravity(const sim::Vec3& theirs);

  /// A body that begins or appears. A shape becomes the box around it; an edge beyond the limits of a log is cut to
  /// them, and a static body without a mass has 1 kg: notes() tells.
  sim::BoxDef add(const StreamBody& body);

  /// An input for a log; none for one that only the engine understands. Bodies are added and removed here too.
  std::optional<sim::Command> command(const StreamInput& input);

  /// The name and the shape of a body for a log; none for a box without a name. A hull and a mesh whose
  /// surface was not told have no shape there.
  struct Description {
    BodyInfo info;
    std::optional<Shape> shape;
  };
  [[nodiscard]] std::optional<Description> describe(const StreamBody& body) const;

  /// The state that a record tells. Errors (kBadInput): "same" of a body that had no state.
  Result<EngineState> state(const StreamState& state);

  /// Notes the first state with a number that is none.
  void note_not_finite(const StreamState& state, std::uint64_t step);

  /// The state of a body after a step of dt, which then counts for what notes() says of the session as a whole.
  void look_at(sim::BodyId id, std::uint64_t step, double dt, const EngineState& state) {
    plausible_.add(id, step, dt, state, {}, axes_);
  }

  [[nodiscard]] std::vector<std::string> notes() const;
  [[nodiscard]] const EngineAxes& axes() const { return axes_; }

 private:
  [[nodiscard]] EngineState converted(const StreamNumbers& numbers, bool asleep) const;
  [[nodiscard]] std::optional<Shape> shape_of(const StreamBody& body) const;
  struct Range {
    const char* what;
    const char* unit;
    double low, high, for_nan;
  };
  /// id 0: of the world.
  void note_cut(std::uint64_t id, const Range& range, double value, double cut);
  /// The value, or the nearest that a log can hold, with a note.
  double within(std::uint64_t id, const Range& range, double value);
  sim::Vec3 within(std::uint64_t id, const Range& range, const sim::Vec3& value);
  /// The same for a length in the engine's unit, which the range has in metres.
  double length_within(std::uint64_t id, const Range& range, double theirs);
  void keep_within(sim::BoxDef& box);

  EngineAxes axes_;
  std::map<std::uint64_t, EngineState> last_;
  std::map<std::uint64_t, StreamMesh> meshes_;  // by hash
  std::vector<std::string> notes_;
  MotionCheck plausible_;
  bool found_not_finite_ = false;
};

}  // namespace tumble::replay
