#include "replay/recover/recover.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "replay/codec/chunk_codec.h"
#include "replay/format/chain.h"
#include "replay/format/limits.h"
#include "replay/log/record_reader.h"
#include "replay/log/record_writer.h"
#include "replay/recover/salvage.h"
#include "replay/session/boxes_at.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

// The format version that added the version of phase hashes to the header. Older logs have version 1.
constexpr std::uint16_t kMinorOfPhaseHashVersion = 3;

class Recovery {
 public:
  Recovery(const ByteSource& source, std::unique_ptr<ByteSink> sink, Salvage left)
      : source_(source), writer_(std::move(sink)), left_(std::move(left)) {}

  Result<RecoverReport> run() {
    report_.header_lost = !left_.header;
    report_.end_known = left_.last_step.has_value();
    report_.damages = left_.damages;
    report_.lost_bytes = left_.lost_bytes;
    report_.others = left_.others;
    report_.first_state = left_.chunks.front().first_step() - 1;
    report_.last_step = left_.chunks.back().end_step() - 1;
    find_missing();
    if (Status ok = write_header(); !ok.ok()) return ok.error();
    for (const SavedChunk& chunk : left_.chunks) {
      const Result<std::vector<std::byte>> stored = bytes_of(chunk.payload, chunk.prelude);
      if (!stored.ok()) return stored.error();
      if (Status ok = writer_.copy_chunk(chunk.prelude, *stored, chunk.final_hash); !ok.ok()) return ok.error();
      report_.steps += chunk.prelude.step_count;
    }
    if (Status ok = writer_.finish(); !ok.ok()) return ok.error();
    report_.chunks = writer_.chunks();
    report_.bytes = writer_.bytes();
    return std::move(report_);
  }

 private:
  void find_missing() {
    const std::uint64_t begin = left_.header ? left_.header->prelude.first_step : 0;
    if (begin < report_.first_state) report_.lost.push_back({begin + 1, report_.first_state - begin});
    std::uint64_t end = report_.first_state + 1;
    for (const SavedChunk& chunk : left_.chunks) {
      if (chunk.first_step() > end) missing_.push_back({end, chunk.first_step() - end});
      end = chunk.end_step();
    }
    report_.lost.insert(report_.lost.end(), missing_.begin(), missing_.end());
    if (left_.last_step && *left_.last_step >= end) report_.lost.push_back({end, *left_.last_step + 1 - end});
  }

  [[nodiscard]] Result<std::vector<std::byte>> bytes_of(std::uint64_t payload, const Prelude& prelude) const {
    std::vector<std::byte> stored(prelude.stored_bytes);
    if (Status ok = source_.read(payload, stored); !ok.ok()) return ok.error();
    return stored;
  }

  /// For later readers of the new log, which see a whole file; empty where its last step is that of the session.
  [[nodiscard]] std::string end_lost() const {
    const std::string last = std::to_string(report_.last_step);
    if (!left_.last_step) return "recovered up to step " + last + ", and its end was lost";
    if (*left_.last_step <= report_.last_step) return "";
    return "recovered up to step " + last + " of " + std::to_string(*left_.last_step);
  }

  Status write_header() {
    const bool begins_as_it_did = left_.header && left_.header->prelude.first_step == report_.first_state;
    const std::string cut_short = end_lost();
    const bool as_it_was = begins_as_it_did && left_.header->content.missing() == missing_ && cut_short.empty();
    if (as_it_was) {
      const Result<std::vector<std::byte>> stored = bytes_of(left_.header->payload, left_.header->prelude);
      return stored.ok() ? writer_.copy_header(left_.header->prelude, *stored) : Status(stored.error());
    }
    Result<ChunkDecoder> first = decode(left_.chunks.front());
    if (!first.ok()) return first.error();
    Result<LogHeader> header = left_.header ? left_.header->content : made_header(*first);
    if (!header.ok()) return header.error();
    header->recovered = {source_.name(), report_.header_lost, missing_};
    if (!cut_short.empty()) header->declared.cut_short = cut_short;
    const Keyframe& keyframe = first->keyframe();
    const Hash128 chain = left_.chunks.front().prelude.chain_before;
    const bool is_begin = report_.first_state == 0 &&
                          chain == chain_start(sim::state_hash(keyframe.state.bodies), header->declared.start);
    if (!begins_as_it_did && !is_begin) begin_with(keyframe, chain, *header);
    return writer_.write_header(*header, keyframe.state);
  }

  [[nodiscard]] Result<ChunkDecoder> decode(const SavedChunk& chunk) const {
    const Result<std::vector<std::byte>> stored = bytes_of(chunk.payload, chunk.prelude);
    if (!stored.ok()) return stored.error();
    const Result<MessageBytes> message = decompress(*stored, chunk.prelude.raw_bytes, kChunkBytesMax);
    if (!message.ok()) return message.error();
    return ChunkDecoder::open(*message);
  }

  /// Makes the new log continue the session from the first saved state.
  void begin_with(const Keyframe& keyframe, const Hash128& chain, LogHeader& header) const {
    header.scene.boxes = boxes_at(keyframe.state.bodies, std::move(header.scene.boxes));
    header.scene.world = keyframe.state.def;
    header.declared.start.clear();  // values of a state that the new log does not begin with
    std::erase_if(header.scene.inputs,
                  [&](const sim::TimedCommand& input) { return input.step <= keyframe.state.step; });
    header.goes_on = {keyframe.state.step, source_.name(), keyframe.continuation_hash, chain};
  }

  /// Adds the channels of a chunk, without names: these were in the header alone.
  static void add_channels(const ChunkDecoder& chunk, Declared& declared) {
    for (const auto& [index, type] : chunk.channels()) {
      if (declared.channels.size() <= index) declared.channels.resize(index + 1);
      declared.channels[index].type = type;
    }
  }

  /// Names channels by their numbers, all with as many digits as the last one needs, four at least: a header has its
  /// channels by ascending names.
  static void name_channels(Declared& declared) {
    constexpr std::size_t kDigitsMin = 4;
    const std::size_t digits = std::max(kDigitsMin, std::to_string(declared.channels.size() - 1).size());
    for (std::size_t i = 0; i < declared.channels.size(); ++i) {
      const std::string number = std::to_string(i);
      declared.channels[i].name = "channel " + std::string(digits - number.size(), '0') + number;
    }
  }

  /// Rebuilds a lost header from the chunks: bodies, method and inputs. Phase names are in the header alone, so they
  /// are taken from this build where its continuation hashes equal those of the log: the hash covers the method
  /// version, and so the phases.
  [[nodiscard]] Result<LogHeader> made_header(const ChunkDecoder& first) const {
    const Keyframe& keyframe = first.keyframe();
    sim::SceneDef scene;
    scene.name = "recovered";
    scene.world = keyframe.state.def;
    scene.steps = report_.last_step;
    scene.boxes = boxes_at(keyframe.state.bodies, {});
    std::uint64_t with_states = 0;  // the greatest common divisor of the steps with states
    std::uint64_t with_words = 0;   // and of those with phase words
    bool phases_fit = true;
    LogHeader header = header_for(scene);
    for (const SavedChunk& chunk : left_.chunks) {
      const Result<ChunkDecoder> decoder = decode(chunk);
      if (!decoder.ok()) return decoder.error();
      const Keyframe& begin = decoder->keyframe();
      phases_fit = phases_fit && sim::continuation_hash(begin.state) == begin.continuation_hash;
      add_channels(*decoder, header.declared);
      if (chunk.prelude.major == kFormatMajor && chunk.prelude.minor < kMinorOfPhaseHashVersion)
        header.phase_hash_version = 1;
      for (std::size_t i = 0; i < decoder->step_count(); ++i) {
        const StepRecord& step = decoder->without_states(i);
        if (step.has_states) with_states = std::gcd(with_states, step.step);
        if (!step.phase_words.empty()) with_words = std::gcd(with_words, step.step);
        phases_fit = phases_fit && step.phase_words.size() % header.phases.size() == 0;
        for (const sim::Command& command : step.inputs) header.scene.inputs.push_back({step.step, command});
      }
    }
    if (!header.declared.channels.empty()) name_channels(header.declared);
    header.states.every = with_states <= sim::kStepsMax ? static_cast<std::uint32_t>(with_states) : 0;
    header.hashes.every = with_words <= sim::kStepsMax ? static_cast<std::uint32_t>(with_words) : 0;
    if (phases_fit) return header;
    header.phases.clear();
    header.method_version = 0;
    return header;
  }

  const ByteSource& source_;
  RecordWriter writer_;
  Salvage left_;
  std::vector<MissingSteps> missing_;  // that the new log has
  RecoverReport report_;
};

/// The reason why nothing can be saved: the file was never a log, or no chunk is left.
Error nothing_left(const ByteSource& source, const Salvage& left) {
  std::array<std::byte, kMagicEnd> bytes = {};
  const auto start = std::span(bytes).first(std::min<std::uint64_t>(source.size(), kMagicEnd));
  const bool was_log = left.header || source.size() == 0 || !source.read(0, start).ok() || starts_like_log(start) ||
                       nearly_starts_like_log(start);
  if (!was_log) {  // which reading it says
    const Result<HeaderRecord> header = RecordReader(source).read_header();
    return header.ok() ? bad_input(source.name() + ": is not a log") : header.error();
  }
  return damaged(source.name() + ": nothing of the session can be saved: found not one whole chunk in " +
                 std::to_string(source.size()) + " bytes");
}

}  // namespace

Result<RecoverReport> recover_log(const ByteSource& damaged, std::unique_ptr<ByteSink> sink) {
  Result<Salvage> left = salvage(damaged);
  if (!left.ok()) return left.error();
  if (left->chunks.empty()) return nothing_left(damaged, *left);
  return Recovery(damaged, std::move(sink), *std::move(left)).run();
}

}  // namespace tumble::replay
