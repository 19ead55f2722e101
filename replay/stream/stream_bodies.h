#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "replay/import/motion_check.h"
#include "replay/log/told_values.h"
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
  StreamBodies(const EngineAxes& axes, const sim::Vec3& their_gravity) : axes_(axes) { (void)gravity(their_gravity); }

  /// Takes a surface for the bodies with its hash, before any of them. One that no log can keep is left out: notes()
  /// tells.
  void add(const StreamMesh& mesh);

  /// Cuts the sizes of the bodies of a step that no shape can have, before they are added. A negative one is taken
  /// without its sign. Of this and all else that is cut, notes() tells, and told_values() holds what was told.
  void keep_sizes(StreamStep& step);

  /// A gravity of the engine in m/s², cut to the limits of a log.
  sim::Vec3 gravity(const sim::Vec3& theirs);

  /// A body that begins or appears. A shape becomes the box around it; a value beyond the limits of a log is cut to
  /// them. A static body of no mass or an infinite one has 1 kg, which is cutting nothing: its mass means nothing.
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

  /// The state after `step` that a record tells. An orientation that is finite and no rotation is divided by its
  /// length, or none. Errors (kBadInput): "same" of a body that had no state.
  Result<EngineState> state(const StreamState& state, std::uint64_t step);

  /// Adds a record "same" of each body that appeared in a step with a motion that no scene can hold and has no state in
  /// it: that of a static body and of one that sleeps is as it was told.
  void add_untold(StreamStep& step);

  /// Keeps what was told of the orientations that are no rotations in the step whose states were told last.
  void tell_turns();

  /// A name as the log has it, of which a note tells where it is another. what: "body 9: the name".
  std::string kept_name(const std::string& what, const std::string& name);

  /// Notes the first state with a number that is none.
  void note_not_finite(const StreamState& state, std::uint64_t step);

  /// The state of a body after a step of dt, which then counts for what notes() says of the session as a whole.
  void look_at(sim::BodyId id, std::uint64_t step, double dt, const EngineState& state) {
    plausible_.add(id, step, dt, state, {}, edges_[id], axes_);
  }

  /// The values that were cut since the last call, but the motions of the start, which start_states() has.
  ToldValues take_told() { return std::exchange(told_, {}); }

  /// The values of a step that will be cut, to declare their channels before the log is begun.
  ToldValues cut(StreamStep& step);

  /// The bodies of the start whose motion no scene can hold, as it was told. Ends the start: what is cut from now on
  /// belongs to steps.
  std::vector<std::pair<sim::BodyId, EngineState>> end_start();

  [[nodiscard]] std::vector<std::string> notes() const;
  [[nodiscard]] const EngineAxes& axes() const { return axes_; }

 private:
  [[nodiscard]] EngineState converted(const StreamNumbers& numbers, bool asleep) const;
  [[nodiscard]] std::optional<Shape> shape_of(const StreamBody& body) const;
  struct Range {
    const char* what;
    const char* unit;
    const char* name;  // of its channel, without "told."; a vector's without its component
    double low, high, for_nan;
  };
  /// component: of a vector, behind the name; else empty.
  void tell(std::uint64_t id, const std::string& name, double value);
  void tell_turn(std::uint64_t id, const std::string& name, const sim::Quat& q);
  /// id 0: of the world.
  void note_cut(std::uint64_t id, const Range& range, const char* component, double value, double cut);
  /// The value, or the nearest that a log can hold, with a note.
  double within(std::uint64_t id, const Range& range, double value, const char* component = "");
  sim::Vec3 within(std::uint64_t id, const Range& range, const sim::Vec3& value);
  /// The same for a length in the engine's unit, which the range has in metres.
  double length_within(std::uint64_t id, const Range& range, double theirs, const char* component = "");
  void keep_within(sim::BoxDef& box);
  void keep_motion_within(sim::BoxDef& box);
  void keep_rotation(sim::BoxDef& box);
  /// An orientation that a log can hold, of one whose length is too far from 1. what: the body, and where it has it.
  sim::Quat kept_turn(const sim::Quat& q, const std::string& what, const char* channels);
  void wake(std::uint64_t id);
  void note(const char* kind, std::string text);
  /// Notes where another body has the name already.
  void call(std::uint64_t id, const std::string& name);

  EngineAxes axes_;
  std::map<std::uint64_t, EngineState> last_;
  std::set<std::uint64_t> thrown_beyond_;         // in the open step, with motions that were cut
  std::map<std::uint64_t, sim::Quat> odd_turns_;  // of the bodies in last_ that have another one there
  std::map<std::uint64_t, double> edges_;         // m, the longest of each body
  std::map<std::uint64_t, std::string> names_;    // of bodies that have one
  std::map<std::string, std::uint64_t> named_;    // the first body of each name
  std::map<std::uint64_t, StreamMesh> meshes_;    // by hash
  /// The first few notes of one kind, and the number of all.
  struct Notes {
    std::string kind;
    std::vector<std::string> texts;
    std::uint64_t count = 0;
  };
  std::vector<Notes> notes_;
  ToldValues told_;
  bool in_start_ = true;
  std::vector<std::pair<sim::BodyId, EngineState>> start_states_;
  MotionCheck plausible_;
  bool found_not_finite_ = false;
};

}  // namespace tumble::replay
