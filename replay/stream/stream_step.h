#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "replay/stream/stream_format.h"
#include "tumble/sim/result.h"
#include "tumble/sim/vec.h"

/// What one frame of a stream holds, in the engine's axes and units.
namespace tumble::replay {

/// position x y z, orientation w x y z, velocity x y z, spin x y z.
using StreamNumbers = std::array<double, 13>;

inline constexpr std::array<const char*, 13> kStreamNumberNames = {
    "position.x", "position.y", "position.z", "orientation.w", "orientation.x", "orientation.y", "orientation.z",
    "velocity.x", "velocity.y", "velocity.z", "spin.x",        "spin.y",        "spin.z"};

struct StreamState {
  std::uint64_t id = 0;
  bool same = false;  ///< as the body's last state; numbers and asleep are not set
  bool asleep = false;
  StreamNumbers numbers = {};
};

/// TumbleRecBody of tumble_recorder.h.
struct StreamBody {
  std::uint64_t id = 0;
  bool is_static = false;
  bool asleep = false;
  StreamNumbers numbers = {};
  std::uint8_t shape = 0;  ///< TumbleRecShape
  sim::Vec3 size = {1, 1, 1};
  std::uint64_t mesh_hash = 0;
  double mass = 1;
  double friction = 0;
  double restitution = 0;
  std::string name;
};

struct StreamRemove {
  std::uint64_t id = 0;
};
struct StreamPush {
  std::uint64_t id = 0;
  sim::Vec3 impulse = {0, 0, 0};
};
struct StreamSetVelocity {
  std::uint64_t id = 0;
  sim::Vec3 velocity = {0, 0, 0};
  sim::Vec3 spin = {0, 0, 0};
};
struct StreamSetGravity {
  sim::Vec3 gravity = {0, 0, 0};
};
/// An input by its name, in the engine's own bytes.
struct StreamNamedInput {
  std::uint64_t body = 0;
  std::string name;
  std::string bytes;
};
using StreamInput =
    std::variant<StreamBody, StreamRemove, StreamPush, StreamSetVelocity, StreamSetGravity, StreamNamedInput>;

struct StreamPoint {
  sim::Vec3 position = {0, 0, 0};
  double depth = 0;
  double impulse = 0;
};
struct StreamContact {
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint32_t part = 0;
  sim::Vec3 normal = {0, 0, 0};
  std::vector<StreamPoint> points;
};

struct StreamPhase {
  std::uint32_t phase = 0;
  std::uint32_t row = 0;
  std::uint64_t word = 0;
};

struct StreamChannel {
  std::uint32_t number = 0;
  std::uint8_t scope = 0;  ///< TumbleRecScope
  std::uint8_t type = 0;   ///< TumbleRecType
  std::string name;
};

struct StreamValue {
  std::uint32_t channel = 0;
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint8_t type = 0;  ///< TumbleRecType
  std::uint32_t count = 0;
  std::string bytes;  ///< the numbers, little-endian, or the bytes
};

/// The surface of the bodies with its hash.
struct StreamMesh {
  std::uint64_t hash = 0;
  std::vector<sim::Vec3> points;
  std::vector<std::uint32_t> corners;  ///< three a triangle; none of a hull
};

struct StreamStep {
  std::uint64_t step = 0;
  double dt = 0;  ///< s; 0 at the start
  std::vector<StreamInput> inputs;
  std::vector<StreamState> states;
  std::vector<StreamContact> contacts;
  std::vector<StreamPhase> phases;
  std::vector<std::string> notes;
  std::vector<StreamChannel> channels;  ///< declared in this frame
  std::vector<StreamValue> values;
  std::vector<StreamMesh> meshes;
  std::vector<std::uint64_t> hashes;  ///< of a frame of hashes: one for each of kStreamClasses
};

/// Reads the payload of a start, a step or a frame of hashes. place: "file: byte 812", for messages. Errors
/// (kBadInput): a record that is none, or longer than its frame.
Result<StreamStep> decode_stream_step(StreamFrameKind kind, std::span<const std::byte> payload,
                                      const std::string& place);

}  // namespace tumble::replay
