#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/channel.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/vec.h"

/// What a log can hold of a step beyond the states: the values of channels, contacts of another engine, notes, and so
/// on. Values and contacts are part of the chain of hashes; the rest is in no hash of a session, and no comparison
/// looks at it.
namespace tumble::replay {

/// A contact point of another engine. SI units, z up.
struct EngineContact {
  sim::BodyId a = 0;               ///< a body
  sim::BodyId b = 0;               ///< another body; 0: the ground
  sim::Vec3 position = {0, 0, 0};  ///< m, world
  sim::Vec3 normal = {0, 0, 1};    ///< from a to b
  double depth = 0;                ///< m; above 0: the bodies overlap
  double impulse = 0;              ///< N s along the normal, in this step
  friend bool operator==(const EngineContact&, const EngineContact&) = default;
};

/// The numbers of a contact in the order in which logs keep them.
inline constexpr std::array<const char*, 8> kContactNumbers = {"position.x", "position.y", "position.z", "normal.x",
                                                               "normal.y",   "normal.z",   "depth",      "impulse"};
inline std::array<double, kContactNumbers.size()> numbers_of(const EngineContact& c) {
  return {c.position.x(), c.position.y(), c.position.z(), c.normal.x(), c.normal.y(), c.normal.z(), c.depth, c.impulse};
}

/// The engine's own state after a step, in its own bytes.
struct EngineSnapshot {
  std::string name = {};  ///< at most 200 bytes of text; empty: none
  std::string bytes = {};
  friend bool operator==(const EngineSnapshot&, const EngineSnapshot&) = default;
};

/// What was shown at one moment of a live session.
struct View {
  double part = 1;       ///< 0 … 1: of the way from the state before the step to the state after it
  double wall_time = 0;  ///< s since the session began, on the clock of the user
  sim::Camera camera;
  std::string effects = {};  ///< a list that render::parse_effects() reads; empty: the default
  sim::BodyId follow = 0;    ///< the body that the camera follows; 0: none
  friend bool operator==(const View&, const View&) = default;
};

/// A step that was recorded before, taken back by a rollback, and recorded again. The log holds the last record.
struct Superseded {
  bool same_inputs = false;     ///< both had equal inputs and began with equal states
  std::string difference = {};  ///< the first difference between both, for people; empty: none
  friend bool operator==(const Superseded&, const Superseded&) = default;
};

/// Of one step.
struct Extras {
  std::vector<ChannelValues> channels;  ///< by index of the channel; channels behind the last one have no value
  std::vector<EngineContact> contacts;  ///< ascending (a, b); points of a pair as the engine orders them
  std::vector<std::string> notes;       ///< text for people
  std::vector<EngineSnapshot> snapshots;
  std::vector<View> views;             ///< ascending wall_time
  std::vector<Superseded> superseded;  ///< one for each earlier record of the step
  std::vector<BodyInfo> bodies;        ///< names and shapes of bodies that appear in this step
  std::vector<Shape> shapes;           ///< first used in this step

  [[nodiscard]] bool empty() const;
  /// Whether the chain covers any of it: a value or a contact.
  [[nodiscard]] bool in_chain() const;
  void clear();
  /// The values of a channel; no rows where the step has none.
  [[nodiscard]] const ChannelValues& values(std::size_t channel) const;
  friend bool operator==(const Extras&, const Extras&) = default;
};

/// The hash that the chain covers: all values and contacts, to the bit.
Hash128 hash_of(const Extras& extras);

/// The memory that a chunk needs for it, in bytes; about the size of its message.
std::uint64_t bytes_of(const Extras& extras);

/// Errors (kBadInput): a name or bytes that no log can keep.
Status check_snapshot(const EngineSnapshot& snapshot);

/// Errors (kBadInput): contacts out of order, a view that is none, a name, a shape or a text that no log can keep.
/// Values of channels are checked where they are added.
Status check_extras(const Extras& extras);

/// What an engine declares for a whole log.
struct Declared {
  std::vector<Channel> channels;  ///< ascending names
  std::vector<Shape> shapes;
  std::vector<BodyInfo> bodies;   ///< of the bodies that the log begins with; ascending id
  Extras start;                   ///< values and contacts of the state that the log begins with
  bool velocity_derived = false;  ///< from positions by the import: left out of exact comparisons
  bool spin_derived = false;      ///< likewise from orientations
  std::string cut_short;  ///< for people: the reason why the session may have had more steps; empty: it was closed
  [[nodiscard]] bool empty() const;
  /// The index of a channel; channels.size() if there is none of this name.
  [[nodiscard]] std::size_t find(const std::string& name) const;
  friend bool operator==(const Declared&, const Declared&) = default;
};

/// Errors (kBadInput): as check_channels(), check_shape(), check_body_info(); lists out of order; a body with a shape
/// that is not declared.
Status check_declared(const Declared& declared);

}  // namespace tumble::replay
