#include "replay/stream/stream_reader.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "replay/format/little_endian.h"
#include "replay/stream/stream_cursor.h"
#include "replay/stream/stream_names.h"
#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

using Head = std::array<std::byte, kStreamFrameHeadBytes>;

/// The hash of kind, length and number, then of the payload.
std::uint64_t frame_hash(const Head& head, std::span<const std::byte> payload, std::uint64_t tag) {
  return XXH64(payload.data(), payload.size(), XXH64(head.data(), 16, tag));
}

bool is_zero(std::span<const std::byte> bytes) {
  return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0}; });
}

Result<StreamHeader> decode_header(std::span<const std::byte> payload, const std::string& name) {
  StreamCursor in(payload);
  StreamHeader header;
  header.engine.precision_bits = in.number<std::uint32_t>();
  const auto up = static_cast<char>(in.number<std::uint8_t>());
  header.axes.up = up - 'x';
  header.axes.left_handed = in.flag();
  header.ground = in.flag();
  header.hashes_only = in.flag();
  header.ring = in.flag();
  header.axes.metres = in.float64();
  for (int k = 0; k < 3; ++k) header.gravity[k] = in.float64();
  header.engine.name = in.text();
  header.engine.version = in.text();
  header.scene = in.text();
  const std::size_t phases = in.number<std::uint16_t>();
  for (std::size_t k = 0; k < phases && in.ok(); ++k) header.phases.push_back(in.text());
  if (!in.ok())
    return bad_input(name + ": found a header of " + std::to_string(payload.size()) + " bytes, wanted more");
  if (up < 'x' || up > 'z') return bad_input(name + ": header: up: found another letter than x, y or z");
  return header;
}

}  // namespace

bool StreamReader::is_stream(std::span<const std::byte> first_bytes) {
  return first_bytes.size() >= kStreamMagic.size() &&
         std::memcmp(first_bytes.data(), kStreamMagic.data(), kStreamMagic.size()) == 0;
}

Result<StreamReader> StreamReader::open(std::unique_ptr<ByteSource> source) {
  StreamReader reader(std::move(source));
  if (Status ok = reader.read_prelude(); !ok.ok()) return ok.error();
  if (Status ok = reader.read_frames(); !ok.ok()) return ok.error();
  return reader;
}

Status StreamReader::read_prelude() {
  std::array<std::byte, kStreamPreludeBytes> prelude{};
  if (source_->size() < prelude.size()) return bad_input(name() + ": found fewer than 24 bytes, wanted a stream");
  if (Status ok = source_->read(0, prelude); !ok.ok()) return ok;
  if (!is_stream(prelude)) return bad_input(name() + ": found no stream of tumble_recorder");
  const auto major = load<std::uint32_t>(prelude.data() + kStreamMagic.size());
  if (major == kStreamMajor) return {};
  return bad_input(name() + ": found stream format " + std::to_string(major) + ", wanted " +
                   std::to_string(kStreamMajor) + "; use a newer tumble");
}

bool StreamReader::damage(std::uint64_t at, const std::string& what) {
  condition_.damage = name() + ": byte " + std::to_string(at) + ": " + what;
  return false;
}

/// False at the end of what can be read.
Result<bool> StreamReader::read_frame(std::uint64_t& at, std::uint64_t number) {
  const std::uint64_t left = source_->size() - at;
  Head head{};
  condition_.good_bytes = at;
  if (left < head.size()) {
    condition_.torn = left > 0;
    return false;
  }
  if (Status ok = source_->read(at, head); !ok.ok()) return ok.error();
  StreamFrame frame;
  frame.kind = static_cast<StreamFrameKind>(load<std::uint32_t>(head.data()));
  frame.size = load<std::uint32_t>(head.data() + 4);
  frame.offset = at + head.size();
  const auto found = load<std::uint64_t>(head.data() + 8);
  if (is_zero(head)) {  // a file system kept the length of what was not written
    condition_.torn = true;
    return false;
  }
  if (frame.size > kStreamFrameBytesMax) return damage(at, "found a frame of " + bytes_text(frame.size));
  if (frame.size > left - head.size()) {
    condition_.torn = true;
    return false;
  }
  const Result<std::vector<std::byte>> payload = read(frame);
  if (!payload.ok()) return payload.error();
  const bool is_header = frame.kind == StreamFrameKind::kHeader;
  if (is_header != (number == 0)) return damage(at, "found no header first, or a second one");
  if (frame_hash(head, *payload, is_header ? 0 : tag_) != load<std::uint64_t>(head.data() + 16)) {
    return damage(at, "found a frame whose hash is wrong");
  }
  // The ring forgot the frames before its first part.
  if (header_.ring && number == 1) next_number_ = found;
  if (found != next_number_) {
    return damage(at, "found frame " + std::to_string(found) + ", wanted frame " + std::to_string(next_number_));
  }
  if (is_header) tag_ = load<std::uint64_t>(head.data() + 16);
  if (Status ok = take(frame, *payload); !ok.ok()) return ok.error();
  at = frame.offset + frame.size;
  condition_.good_bytes = at;
  return !condition_.finished && !condition_.damage;
}

Status StreamReader::read_frames() {
  std::uint64_t at = kStreamPreludeBytes;
  for (std::uint64_t number = 0; number < kStreamFramesMax; ++number, ++next_number_) {
    const Result<bool> more = read_frame(at, number);
    if (!more.ok()) return more.error();
    if (*more) continue;
    if (number == 0) return damaged(condition_.damage.value_or(name() + ": ends within its header"));
    if (condition_.finished && at != source_->size()) (void)damage(at, "found bytes after the last frame");
    return {};
  }
  return bad_input(name() + ": found too many frames");
}

Status StreamReader::take(const StreamFrame& frame, std::span<const std::byte> payload) {
  if (frame.kind == StreamFrameKind::kHeader) {
    Result<StreamHeader> header = decode_header(payload, name());
    if (!header.ok()) return header.error();
    header_ = *std::move(header);
    return {};
  }
  StreamFrame kept = frame;
  StreamCursor in(payload);
  kept.step = in.number<std::uint64_t>();
  const std::string place = name() + ": byte " + std::to_string(frame.offset) + ": ";
  if (!in.ok()) return bad_input(place + "found a frame of " + std::to_string(frame.size) + " bytes, wanted more");
  switch (frame.kind) {
    case StreamFrameKind::kStart:
    case StreamFrameKind::kStep:
    case StreamFrameKind::kHashes:
      return take_step(kept);
    case StreamFrameKind::kRewind:
      return take_rewind(kept.step);
    case StreamFrameKind::kSnapshot:
      take_snapshot(kept, in);
      return {};
    case StreamFrameKind::kEnd:
      condition_.finished = true;
      condition_.dumped = in.flag();
      return {};
    default:
      return bad_input(place + "found a frame of kind " + std::to_string(static_cast<std::uint32_t>(frame.kind)) +
                       ", which this tumble does not know; use a newer one");
  }
}

/// A start that is not the first begins a further part of a ring, of the state that is known already.
Status StreamReader::take_step(const StreamFrame& frame) {
  const std::string place = name() + ": byte " + std::to_string(frame.offset) + ": ";
  if (frame.step >= sim::kStepsMax) {
    return bad_input(place + "found step " + std::to_string(frame.step) + ", wanted one below " +
                     std::to_string(sim::kStepsMax) + ", as many as a log holds");
  }
  const bool first = steps_.empty();
  const bool is_start = frame.kind == StreamFrameKind::kStart || (frame.kind == StreamFrameKind::kHashes && first);
  if (first != is_start && !(is_start && header_.ring)) return bad_input(place + "found a step before the start");
  if (first) {
    steps_.push_back(frame);
    return {};
  }
  const std::uint64_t wanted = steps_.back().step + (is_start ? 0 : 1);
  if (frame.step != wanted) {
    return bad_input(place + "found step " + std::to_string(frame.step) + ", wanted step " + std::to_string(wanted));
  }
  if (is_start) return {};
  if (!taken_back_.empty()) {
    superseded_.push_back({taken_back_.back(), frame});
    taken_back_.pop_back();
  }
  steps_.push_back(frame);
  return {};
}

Status StreamReader::take_rewind(std::uint64_t step) {
  if (steps_.empty() || step < steps_.front().step || step > steps_.back().step) {
    return bad_input(name() + ": found a rewind to step " + std::to_string(step) + ", wanted a step that was recorded");
  }
  ++rewinds_;
  taken_back_.clear();
  while (steps_.back().step > step) {
    taken_back_.push_back(steps_.back());
    rewound_.push_back(steps_.back());
    steps_.pop_back();
  }
  std::erase_if(snapshots_, [&](const StreamFrame& frame) { return frame.step > step; });
  return {};
}

/// in: behind the number of the step.
void StreamReader::take_snapshot(const StreamFrame& frame, StreamCursor in) {
  if (in.text() != kStreamRefusedName) {
    snapshots_.push_back(frame);
    return;
  }
  condition_.refusal = name_for_log(in.text(std::min(in.left(), kStreamRefusalBytesMax)), kStreamRefusalBytesMax);
}

Result<std::vector<std::byte>> StreamReader::read(const StreamFrame& frame) const {
  std::vector<std::byte> payload(frame.size);
  if (Status ok = source_->read(frame.offset, payload); !ok.ok()) return ok.error();
  return payload;
}

}  // namespace tumble::replay
