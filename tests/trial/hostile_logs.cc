#include "tests/trial/hostile_logs.h"

#include <algorithm>
#include <limits>
#include <span>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/header_codec.h"
#include "replay/codec/index_codec.h"
#include "replay/format/chain.h"
#include "replay/format/limits.h"
#include "tumble/replay/prelude.h"
#include "tumble/replay/recorder.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::trial {
namespace {

using fuzz::Bytes;
using replay::MessageBytes;
using replay::RecordKind;

sim::SceneDef scene_of(std::uint64_t boxes) {
  sim::SceneDef scene;
  for (std::uint64_t i = 0; i < boxes; ++i) {
    sim::BoxDef box;
    const std::uint64_t row = i / 100;
    box.id = i + 1;
    box.position = {2 * static_cast<double>(i % 100), 2 * static_cast<double>(row), 0.5};
    scene.boxes.push_back(box);
  }
  return scene;
}

/// A log under construction, its messages laid open.
class HostileLog {
 public:
  explicit HostileLog(const sim::SceneDef& scene) : HostileLog(replay::header_for(scene)) {}
  explicit HostileLog(replay::LogHeader header) : header_(std::move(header)) {
    const Result<sim::World> world = sim::create_world(header_.scene);
    if (world.ok()) keyframe_.state = world->state();
  }

  HostileLog& chunk(const std::vector<replay::StepRecord>& steps = {}) {
    keyframe_.continuation_hash = sim::continuation_hash(keyframe_.state);
    return record(RecordKind::kChunk, steps.size(), *replay::ChunkEncoder().encode(keyframe_, steps));
  }
  /// A chunk of the one step that the keyframe leads to; goes on from there.
  HostileLog& stepped_chunk() {
    Result<sim::World> world = sim::World::restore(keyframe_.state);
    if (!world.ok() || !sim::step(*world).ok()) return *this;
    replay::StepRecord record;
    record.step = world->state().step;
    record.dt = keyframe_.state.def.dt;
    record.state_hash = sim::state_hash(world->bodies());
    chunk({record});
    keyframe_.state = world->state();
    return *this;
  }
  HostileLog& record(RecordKind kind, std::uint64_t steps, const MessageBytes& message) {
    return record(kind, steps, Bytes(message.bytes().begin(), message.bytes().end()));
  }
  HostileLog& record(RecordKind kind, std::uint64_t steps, const Bytes& message) {
    replay::Prelude prelude;
    prelude.kind = kind;
    prelude.sequence = sequence_++;
    prelude.first_step = kind == RecordKind::kHeader ? keyframe_.state.step : keyframe_.state.step + 1;
    prelude.step_count = steps;
    prelude.raw_bytes = message.size();
    prelude.chain_before = replay::chain_start(sim::state_hash(keyframe_.state.bodies), {});
    const auto encoded = encode(prelude);
    open_.insert(open_.end(), encoded.begin(), encoded.end());
    open_.insert(open_.end(), message.begin(), message.end());
    return *this;
  }
  /// The header as it is now; called first.
  HostileLog& header() { return record(RecordKind::kHeader, 0, *replay::encode_header(header_)); }
  replay::Keyframe& keyframe() { return keyframe_; }
  replay::LogHeader& of_header() { return header_; }
  [[nodiscard]] Bytes bytes() const { return fuzz::mended(open_); }

 private:
  replay::LogHeader header_;
  replay::Keyframe keyframe_;
  Bytes open_;
  std::uint64_t sequence_ = 0;
};

replay::StepRecord step_record(std::uint64_t step) {
  replay::StepRecord record;
  record.step = step;
  record.dt = 1.0 / 64;
  return record;
}

/// Bodies that take the least from a message: all alike but for id and place.
void fill_bodies(sim::Bodies& bodies, std::size_t count) {
  const Result<sim::World> one = sim::create_world(scene_of(1));
  bodies = one->bodies();
  const auto spread = [count](auto& column) { column.resize(count, column.front()); };
  for (auto* column : {&bodies.position, &bodies.velocity, &bodies.spin, &bodies.half_extent, &bodies.inertia,
                       &bodies.inverse_inertia}) {
    spread(column->x), spread(column->y), spread(column->z);
  }
  spread(bodies.orientation.w), spread(bodies.orientation.x), spread(bodies.orientation.y);
  spread(bodies.orientation.z);
  for (auto* column : {&bodies.low_energy_time, &bodies.mass, &bodies.inverse_mass, &bodies.friction,
                       &bodies.friction_dynamic, &bodies.restitution}) {
    spread(*column);
  }
  spread(bodies.frozen), spread(bodies.is_static);
  bodies.id.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i / 8192;
    bodies.id.push_back(i + 1);
    bodies.position.x[i] = 2 * static_cast<double>(i % 8192);  // in one place, each would meet each
    bodies.position.y[i] = 2 * static_cast<double>(row);
  }
}

// Sizes of messages: a little below what the reader lets pass of few bytes.
constexpr std::size_t kHeaderBytes = replay::header_bytes_max(0) - (1 << 16);
constexpr std::size_t kChunkBytes = replay::message_bytes_max(0) - (1 << 16);
constexpr std::size_t kBoxBytes = 248;   // of a header
constexpr std::size_t kBodyBytes = 234;  // of a keyframe
constexpr std::size_t kInputBytes = 48;  // of an input without numbers
constexpr std::size_t kPairBytes = 10;   // of a pair of bodies
constexpr std::size_t kIndexRowBytes = 64;

Bytes bomb(RecordKind kind, std::size_t size) {
  HostileLog log(scene_of(1));
  if (kind != RecordKind::kHeader) log.header();
  if (kind == RecordKind::kIndex) log.chunk();
  return log.record(kind, 1, Bytes(size)).bytes();
}

Bytes header_texts(bool one_long) {
  HostileLog log(scene_of(1));
  if (one_long) log.of_header().scene_text.assign(kHeaderBytes, 'a');
  if (!one_long) log.of_header().overrides.resize(kHeaderBytes / 16);
  return log.header().chunk().bytes();
}

Bytes header_boxes() { return HostileLog(scene_of(kHeaderBytes / kBoxBytes)).header().chunk().bytes(); }

Bytes header_inputs() {
  sim::SceneDef scene = scene_of(1);
  scene.inputs.resize(kHeaderBytes / (2 * kInputBytes), {1, sim::Wake{1}});
  return HostileLog(scene).header().chunk().bytes();
}

/// Two chunks of more bodies than the header has, each of a step as it would be computed, where replay starts from
/// them.
Bytes chunk_bodies(std::uint64_t boxes, bool with_header) {
  replay::LogHeader header = replay::header_for(scene_of(boxes));
  header.goes_on = replay::GoesOn{5, "before.tumble", {}, {}};
  HostileLog log(std::move(header));
  log.keyframe().state.step = 5;
  fill_bodies(log.keyframe().state.bodies, kChunkBytes / kBodyBytes);
  log.of_header().goes_on->continuation_hash = sim::continuation_hash(log.keyframe().state);
  if (with_header) log.header();
  return log.stepped_chunk().stepped_chunk().bytes();
}

Bytes chunk_inputs() {
  HostileLog log(scene_of(1));
  replay::StepRecord step = step_record(1);
  step.inputs.resize(kChunkBytes / (kInputBytes + 8), sim::Wake{1});
  return log.header().chunk({step}).bytes();
}

Bytes chunk_words() {
  HostileLog log(scene_of(1));
  std::vector<replay::StepRecord> steps;
  const std::size_t each = replay::kPhaseWordsMax / log.of_header().phases.size() * log.of_header().phases.size();
  for (std::uint64_t k = 1; k * each * 8 < kChunkBytes; ++k) {
    steps.push_back(step_record(k));
    steps.back().phase_words.resize(each);
  }
  return log.header().chunk(steps).bytes();
}

/// As many steps as a chunk may have, or as many states as it may decode to, of bodies that lie still.
Bytes chunk_steps(std::size_t bodies, std::uint64_t count) {
  HostileLog log(scene_of(bodies));
  log.header();
  std::vector<replay::StepRecord> steps;
  for (std::uint64_t k = 1; k <= count; ++k) {
    steps.push_back(step_record(k));
    steps.back().has_states = true;
    copy_visible(log.keyframe().state.bodies, steps.back().states);
    steps.back().state_hash = sim::state_hash(log.keyframe().state.bodies);
  }
  return log.chunk(steps).bytes();
}

Bytes chunk_pairs() {
  HostileLog log(scene_of(2));
  sim::PairTable& pairs = log.keyframe().state.pairs;
  pairs.a.assign(kChunkBytes / kPairBytes, 0);
  pairs.b.assign(pairs.a.size(), 1);
  pairs.planes.assign(pairs.a.size(), 0);
  return log.header().chunk({step_record(1)}).bytes();
}

Bytes index_rows() {
  HostileLog log(scene_of(1));
  const std::vector<replay::ChunkPlace> rows(kChunkBytes / kIndexRowBytes);
  return log.header().chunk().record(RecordKind::kIndex, 0, *replay::encode_index(rows)).bytes();
}

/// Frames between the records, each as large as recovery reads.
Bytes loose_frames() {
  Bytes bytes = HostileLog(scene_of(1)).header().chunk().bytes();
  Bytes frame;
  replay::Compressor compressor;
  (void)compressor.compress(Bytes(kChunkBytes), frame).ok();
  for (int i = 0; i < 8; ++i) bytes.insert(bytes.end(), frame.begin(), frame.end());
  return bytes;
}

/// A prelude that says of its payload what no file can hold.
Bytes claims(std::uint64_t stored, std::uint64_t raw) {
  replay::Prelude prelude;
  prelude.stored_bytes = stored;
  prelude.raw_bytes = raw;
  const auto encoded = encode(prelude);
  Bytes bytes(encoded.begin(), encoded.end());
  bytes.resize(4096);
  return bytes;
}

}  // namespace

std::vector<std::pair<std::string, fuzz::Bytes>> make_hostile_logs() {
  return {
      {"claims_file.tumble", claims(std::numeric_limits<std::uint64_t>::max() - 64, 8)},
      {"claims_message.tumble", claims(3000, std::uint64_t{1} << 62)},
      {"bomb_header.tumble", bomb(RecordKind::kHeader, kHeaderBytes)},
      {"bomb_header_larger.tumble", bomb(RecordKind::kHeader, std::size_t{200} << 20)},
      {"bomb_chunk.tumble", bomb(RecordKind::kChunk, kChunkBytes)},
      {"bomb_chunk_larger.tumble", bomb(RecordKind::kChunk, std::size_t{200} << 20)},
      {"bomb_index.tumble", bomb(RecordKind::kIndex, kChunkBytes)},
      {"header_text.tumble", header_texts(true)},
      {"header_many_texts.tumble", header_texts(false)},
      {"header_boxes.tumble", header_boxes()},
      {"header_inputs.tumble", header_inputs()},
      {"chunk_bodies.tumble", chunk_bodies(1, true)},
      {"chunk_bodies_no_header.tumble", chunk_bodies(1, false)},
      {"all_room.tumble", chunk_bodies(kHeaderBytes / kBoxBytes, true)},
      {"chunk_inputs.tumble", chunk_inputs()},
      {"chunk_phase_words.tumble", chunk_words()},
      {"chunk_steps.tumble", chunk_steps(1, replay::kStepsPerChunkRead)},
      {"chunk_states.tumble", chunk_steps(500, replay::kBodyStepsRead / 500)},
      {"chunk_pairs.tumble", chunk_pairs()},
      {"index_rows.tumble", index_rows()},
      {"loose_frames.tumble", loose_frames()},
  };
}

}  // namespace tumble::trial
