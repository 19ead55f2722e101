#include "replay/stream/stream_step.h"

#include <bit>
#include <utility>

#include "replay/stream/stream_cursor.h"

namespace tumble::replay {
namespace {

using Kind = StreamRecordKind;

// TumbleRecShape and TumbleRecType have values below these.
constexpr std::uint8_t kShapes = 6;
constexpr std::uint8_t kTypes = 8;
constexpr std::uint8_t kScopes = 3;
constexpr std::array<std::size_t, kTypes> kTypeBytes = {4, 8, 4, 8, 4, 8, 1, 1};

sim::Vec3 vector_of(StreamCursor& in) {
  sim::Vec3 v = {0, 0, 0};
  for (int k = 0; k < 3; ++k) v[k] = in.float64();
  return v;
}

/// One record: its bytes, and how many were read of them.
class Record {
 public:
  Record(Kind kind, std::span<const std::byte> bytes, StreamStep& step) : kind_(kind), in_(bytes), step_(step) {}

  /// False: the record is not as its kind has it.
  bool read() {
    switch (kind_) {
      case Kind::kBody:
        return body();
      case Kind::kRemove:
      case Kind::kPush:
      case Kind::kSetVelocity:
      case Kind::kSetGravity:
      case Kind::kInput:
        return input();
      case Kind::kStates32:
      case Kind::kStates64:
      case Kind::kSame:
        while (in_.ok() && in_.left() > 0) state();
        return in_.ok();
      case Kind::kContact:
      case Kind::kContact32:
        return contact();
      case Kind::kPhase:
        step_.phases.push_back({in_.number<std::uint32_t>(), in_.number<std::uint32_t>(), in_.number<std::uint64_t>()});
        return done();
      case Kind::kNote:
        step_.notes.push_back(in_.text(in_.left()));
        return true;
      case Kind::kChannel:
        return channel();
      case Kind::kValue:
        return value();
      case Kind::kMesh:
        return mesh();
      default:
        return false;
    }
  }

 private:
  [[nodiscard]] bool done() const { return in_.ok() && in_.left() == 0; }

  bool body() {
    StreamBody body;
    body.id = in_.number<std::uint64_t>();
    const auto flags = in_.number<std::uint8_t>();
    body.is_static = (flags & 1U) != 0;
    body.asleep = (flags & 2U) != 0;
    for (double& number : body.numbers) number = in_.float64();
    body.shape = in_.number<std::uint8_t>();
    body.size = vector_of(in_);
    body.mesh_hash = in_.number<std::uint64_t>();
    body.mass = in_.float64();
    body.friction = in_.float64();
    body.restitution = in_.float64();
    body.name = in_.text();
    const bool good = done() && body.shape < kShapes && body.name.size() <= kStreamNameBytesMax;
    step_.inputs.emplace_back(std::move(body));
    return good;
  }

  bool input() {
    const std::uint64_t id = kind_ == Kind::kSetGravity ? 0 : in_.number<std::uint64_t>();
    if (kind_ == Kind::kRemove) step_.inputs.emplace_back(StreamRemove{id});
    if (kind_ == Kind::kPush) step_.inputs.emplace_back(StreamPush{id, vector_of(in_)});
    if (kind_ == Kind::kSetGravity) step_.inputs.emplace_back(StreamSetGravity{vector_of(in_)});
    if (kind_ == Kind::kSetVelocity) {
      const sim::Vec3 velocity = vector_of(in_);
      step_.inputs.emplace_back(StreamSetVelocity{id, velocity, vector_of(in_)});
    }
    if (kind_ == Kind::kInput) {
      std::string name = in_.text();
      step_.inputs.emplace_back(StreamNamedInput{id, std::move(name), in_.text(in_.left())});
    }
    return done();
  }

  void state() {
    StreamState state;
    state.id = in_.number<std::uint64_t>();
    state.same = kind_ == Kind::kSame;
    if (!state.same) {
      state.asleep = (in_.number<std::uint8_t>() & 1U) != 0;
      for (double& number : state.numbers) number = kind_ == Kind::kStates32 ? in_.float32() : in_.float64();
    }
    step_.states.push_back(state);
  }

  /// A number of a contact.
  double real() { return kind_ == Kind::kContact32 ? in_.float32() : in_.float64(); }

  bool contact() {
    StreamContact contact;
    contact.a = in_.number<std::uint64_t>();
    contact.b = in_.number<std::uint64_t>();
    contact.part = in_.number<std::uint32_t>();
    for (int k = 0; k < 3; ++k) contact.normal[k] = real();
    const auto count = in_.number<std::uint32_t>();
    for (std::uint32_t k = 0; k < count && in_.ok(); ++k) {
      StreamPoint point;
      for (int i = 0; i < 3; ++i) point.position[i] = real();
      point.depth = real();
      point.impulse = real();
      contact.points.push_back(point);
    }
    step_.contacts.push_back(std::move(contact));
    return done();
  }

  bool channel() {
    StreamChannel channel;
    channel.number = in_.number<std::uint32_t>();
    channel.scope = in_.number<std::uint8_t>();
    channel.type = in_.number<std::uint8_t>();
    channel.name = in_.text();
    const bool good = done() && channel.number < kStreamChannelsMax && channel.scope < kScopes &&
                      channel.type < kTypes && !channel.name.empty() && channel.name.size() <= kStreamNameBytesMax;
    step_.channels.push_back(std::move(channel));
    return good;
  }

  bool value() {
    StreamValue value;
    value.channel = in_.number<std::uint32_t>();
    value.a = in_.number<std::uint64_t>();
    value.b = in_.number<std::uint64_t>();
    value.type = in_.number<std::uint8_t>();
    value.count = in_.number<std::uint32_t>();
    if (!in_.ok() || value.type >= kTypes || in_.left() != kTypeBytes[value.type] * value.count) return false;
    value.bytes = in_.text(in_.left());
    step_.values.push_back(std::move(value));
    return true;
  }

  bool mesh() {
    StreamMesh mesh;
    mesh.hash = in_.number<std::uint64_t>();
    const std::uint64_t points = in_.number<std::uint32_t>(), corners = in_.number<std::uint32_t>();
    if (!in_.ok() || in_.left() != 24 * points + 4 * corners) return false;
    for (std::uint64_t k = 0; k < points; ++k) mesh.points.push_back(vector_of(in_));
    for (std::uint64_t k = 0; k < corners; ++k) mesh.corners.push_back(in_.number<std::uint32_t>());
    step_.meshes.push_back(std::move(mesh));
    return done();
  }

  Kind kind_;
  StreamCursor in_;
  StreamStep& step_;
};

}  // namespace

Result<StreamStep> decode_stream_step(StreamFrameKind kind, std::span<const std::byte> payload,
                                      const std::string& place) {
  StreamCursor in(payload);
  StreamStep step;
  step.step = in.number<std::uint64_t>();
  step.dt = in.float64();
  if (kind == StreamFrameKind::kHashes) {
    for (std::size_t k = 0; k < kStreamClasses.size(); ++k) step.hashes.push_back(in.number<std::uint64_t>());
    if (in.ok() && in.left() == 0) return step;
    return bad_input(place + ": found a frame of " + std::to_string(payload.size()) + " bytes, wanted 56");
  }
  while (in.ok() && in.left() > 0) {
    const std::size_t at = in.at();
    const auto head = in.number<std::uint32_t>();
    const std::span<const std::byte> bytes = in.take(head >> 8);
    if (in.ok() && Record(static_cast<Kind>(head & 255U), bytes, step).read()) continue;
    return bad_input(place + ": record at byte " + std::to_string(at) + ": found kind " + std::to_string(head & 255U) +
                     " with " + std::to_string(head >> 8) +
                     " bytes, wanted a record as docs/recorder_stream.md has it");
  }
  if (!in.ok())
    return bad_input(place + ": found a frame of " + std::to_string(payload.size()) + " bytes, wanted more");
  return step;
}

}  // namespace tumble::replay
