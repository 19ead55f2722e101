#include "replay/recover/salvage.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "replay/codec/header_codec.h"
#include "replay/format/chain.h"
#include "replay/format/limits.h"
#include "replay/log/record_reader.h"
#include "replay/recover/salvage_frames.h"
#include "replay/recover/salvage_pieces.h"

namespace tumble::replay {
namespace {

/// Compares every state and the keyframe with their hashes, and fills in the hashes that link the chunk to others.
/// Errors (kDamaged): a state or the keyframe does not match, or cannot be decoded.
Status check_chunk(ChunkDecoder& decoder, const std::optional<SavedHeader>& header, SavedChunk& chunk) {
  const Keyframe& keyframe = decoder.keyframe();
  chunk.final_hash = chunk.keyframe_hash = sim::state_hash(keyframe.state.bodies);
  chunk.continuation_hash = keyframe.continuation_hash;
  const bool comparable = header && header->content.method_version == sim::method_version(keyframe.state.def.method);
  if (comparable && sim::continuation_hash(keyframe.state) != keyframe.continuation_hash) {
    return damaged("the keyframe does not match its continuation hash");
  }
  const std::size_t phases = header ? header->content.phases.size() : 0;
  for (std::size_t i = 0; i < decoder.step_count(); ++i) {
    const Result<const StepRecord*> step = decoder.step(i);
    if (!step.ok()) return step.error();
    const StepRecord& record = **step;
    const bool phases_fit = phases == 0 || record.phase_words.size() % phases == 0;
    if (!phases_fit || (record.has_states && state_hash(record.states) != record.state_hash)) {
      return damaged("the states of step " + std::to_string(record.step) + " do not match their hash");
    }
    chunk.final_hash = record.state_hash;
  }
  return {};
}

bool is_final(const Error& error) { return error.kind != ErrorKind::kDamaged; }

/// Searches in four stages, each on what the stage before left over.
///
/// 1. Intact records at any byte (salvage_pieces.h), so that inserted, moved and copied parts are found too.
/// 2. zstd frames between the records (salvage_frames.h). A frame has its own checksum, so a chunk survives the loss of
///    its prelude; what only the prelude held, the chain, is computed again from the chunk before.
/// 3. The header decides which session is saved: a file may hold parts of several. Chunks of a session name their
///    header by its tag. The header at the file's start wins if any chunk has its tag, else the one with the most
///    steps.
/// 4. choose_chunks() takes the set of candidates with the most steps that fits together.
class Salvager {
 public:
  explicit Salvager(const ByteSource& source) : source_(source) {}

  Result<Salvage> run() {
    if (Status ok = must_be_log(); !ok.ok()) return ok.error();
    pieces_ = find_pieces(source_);
    frames_ = find_frames(source_, pieces_.scraps);
    if (Status ok = find_header(); !ok.ok()) return ok.error();
    if (Status ok = collect_chunks(); !ok.ok()) return ok.error();
    choose();
    find_end();
    account();
    return std::move(result_);
  }

 private:
  [[nodiscard]] Status must_be_log() const {
    std::array<std::byte, kPreludeBytes> bytes = {};
    const auto start = std::span(bytes).first(std::min<std::uint64_t>(source_.size(), kPreludeBytes));
    if (Status ok = source_.read(0, start); !ok.ok()) return ok;
    if (start.size() < kPreludeBytes) return {};
    const Result<Prelude> prelude = decode_prelude(bytes);
    if (prelude.ok() || !is_final(prelude.error())) return {};
    return Error{prelude.error().kind, source_.name() + ": header at byte 0: " + prelude.error().message};
  }

  void note(std::uint64_t offset, std::string message) {
    result_.damages.push_back({RecordKind::kChunk, offset, std::move(message)});
  }

  /// Chooses the header that the file begins with, else the one whose session has the most steps. Without an intact
  /// header, chooses the tag with the most steps.
  Status find_header() {
    std::map<std::uint64_t, std::uint64_t> steps;  // by tag
    for (const Piece& piece : pieces_.records) {
      if (piece.prelude.kind == RecordKind::kChunk) steps[piece.prelude.log_tag] += piece.prelude.step_count + 1;
    }
    for (const LooseFrame& frame : frames_) {
      if (frame.offset != kPreludeBytes || !steps.contains(frame.stored_hash.low)) continue;
      if (Status ok = take_loose_header(frame); !ok.ok() || result_.header) return ok;
    }
    const Piece* best = nullptr;
    for (const Piece& piece : pieces_.records) {
      if (piece.prelude.kind != RecordKind::kHeader) continue;
      if (piece.offset == 0 && steps.contains(piece.prelude.log_tag)) return take_header(piece);
      if (best == nullptr || steps[piece.prelude.log_tag] > steps[best->prelude.log_tag]) best = &piece;
    }
    if (best != nullptr) return take_header(*best);
    const auto most = std::ranges::max_element(steps, {}, [](const auto& entry) { return entry.second; });
    if (most != steps.end()) tag_ = most->first;
    for (const LooseFrame& frame : frames_) {
      if (tag_ && frame.stored_hash.low != *tag_) continue;
      if (Status ok = take_loose_header(frame); !ok.ok() || result_.header) return ok;
    }
    return {};
  }

  Status take_header(const Piece& piece) {
    tag_ = piece.prelude.log_tag;
    const Result<MessageBytes> message = RecordReader(source_).read_payload(piece.offset, piece.prelude);
    if (!message.ok()) return is_final(message.error()) ? Status(message.error()) : Status();
    Result<LogHeader> header = decode_header(*message);
    if (!header.ok()) return is_final(header.error()) ? named(header.error(), piece.offset) : Status();
    if (header->goes_on) header->goes_on->chain = piece.prelude.chain_after;
    result_.header = {piece.prelude, piece.offset + kPreludeBytes, *std::move(header)};
    return {};
  }

  /// Takes a frame as the header. Only the tag of the chunks proves that a frame is the header.
  Status take_loose_header(const LooseFrame& frame) {
    if (frame.raw_bytes > header_bytes_max(frame.stored_bytes)) return {};
    const Result<MessageBytes> message = read_frame(source_, frame);
    if (!message.ok()) return is_final(message.error()) ? Status(message.error()) : Status();
    Result<LogHeader> header = decode_header(*message);
    if (!header.ok() || header->phases.empty()) return {};
    Prelude prelude;
    prelude.first_step = header->goes_on ? header->goes_on->step : 0;
    if (!header->declared.empty()) prelude.set_extras();
    prelude.raw_bytes = frame.raw_bytes;
    prelude.stored_bytes = frame.stored_bytes;
    prelude.stored_hash = frame.stored_hash;
    prelude.log_tag = frame.stored_hash.low;
    tag_ = prelude.log_tag;
    header_was_loose_ = true;
    result_.header = {prelude, frame.offset, *std::move(header)};
    note(frame.offset, "header: its prelude was damaged and is made anew");
    return {};
  }

  [[nodiscard]] Status named(const Error& error, std::uint64_t offset) const {
    return Error{error.kind, source_.name() + ": record at byte " + std::to_string(offset) + ": " + error.message};
  }

  Status collect_chunks() {
    for (const Piece& piece : pieces_.records) {
      if (piece.prelude.kind != RecordKind::kChunk) continue;
      if (Status ok = collect(piece); !ok.ok()) return ok;
    }
    for (const LooseFrame& frame : frames_) {
      if (result_.header && result_.header->payload == frame.offset) continue;
      if (Status ok = collect(frame); !ok.ok()) return ok;
    }
    const auto has_steps = [](const SavedChunk& chunk) { return chunk.prelude.step_count > 0; };
    if (std::ranges::any_of(candidates_, has_steps)) std::erase_if(candidates_, std::not_fn(has_steps));
    return {};
  }

  Status collect(const Piece& piece) {
    const Prelude& p = piece.prelude;
    const std::string record = "chunk at byte " + std::to_string(piece.offset) + ": ";
    if (p.log_tag != tag_) {
      note(piece.offset, record + "belongs to another log");
      return {};
    }
    if (!known_.insert({p.stored_hash.low, p.chain_before.low}).second) {
      note(piece.offset, record + "is there a second time");
      copies_ += kPreludeBytes + p.stored_bytes;
      return {};
    }
    const ChunkRules rules =
        result_.header ? rules_of(result_.header->prelude, result_.header->content) : ChunkRules{.log_tag = *tag_};
    Result<ChunkDecoder> decoder = RecordReader(source_).read_chunk(place_of(p, piece.offset), rules);
    SavedChunk chunk = {p, piece.offset + kPreludeBytes, true, {}, {}, {}};
    Status ok = decoder.ok() ? check_chunk(*decoder, result_.header, chunk) : Status(decoder.error());
    if (ok.ok()) {
      candidates_.push_back(chunk);
    } else if (is_final(ok.error())) {
      return ok;
    } else {
      note(piece.offset, record + ok.error().message);
    }
    return {};
  }

  Status collect(const LooseFrame& frame) {
    const Result<MessageBytes> message = read_frame(source_, frame);
    if (!message.ok()) return is_final(message.error()) ? Status(message.error()) : Status();
    Result<ChunkDecoder> decoder = ChunkDecoder::open(*message);
    if (!decoder.ok()) return {};
    SavedChunk chunk = {{}, frame.offset, false, {}, {}, {}};
    chunk.prelude.kind = RecordKind::kChunk;
    chunk.prelude.first_step = decoder->first_step();
    chunk.prelude.step_count = decoder->step_count();
    if (decoder->has_extras()) chunk.prelude.set_extras();
    chunk.prelude.raw_bytes = frame.raw_bytes;
    chunk.prelude.stored_bytes = frame.stored_bytes;
    chunk.prelude.stored_hash = frame.stored_hash;
    if (check_chunk(*decoder, result_.header, chunk).ok()) candidates_.push_back(chunk);
    return {};
  }

  void choose() {
    SessionStart start;
    if (result_.header) {
      start.first_step = result_.header->prelude.first_step + 1;
      start.extras = result_.header->content.declared.start;
      if (!header_was_loose_) start.chain = result_.header->prelude.chain_after;
      if (const auto& before = result_.header->content.goes_on) start.continuation = before->continuation_hash;
    }
    const ChainAfter chain_after = [this](const SavedChunk& chunk, Hash128 chain) -> std::optional<Hash128> {
      const Prelude& p = chunk.prelude;
      const Result<MessageBytes> message =
          read_frame(source_, {chunk.payload, p.stored_bytes, p.raw_bytes, p.stored_hash});
      if (!message.ok()) return std::nullopt;
      const Result<ChunkDecoder> decoder = ChunkDecoder::open(*message);
      if (!decoder.ok()) return std::nullopt;
      for (std::size_t i = 0; i < decoder->step_count(); ++i) chain = chain_next(chain, decoder->without_states(i));
      return chain;
    };
    result_.chunks = choose_chunks(candidates_, start, chain_after);
    if (header_was_loose_ && !result_.chunks.empty()) {
      Prelude& header = result_.header->prelude;
      header.chain_before = header.chain_after = result_.chunks.front().prelude.chain_before;
      if (result_.header->content.goes_on) result_.header->content.goes_on->chain = header.chain_after;
    }
  }

  /// The last step of the session, from index or footer.
  void find_end() {
    const auto look = [&](const Piece& piece) {
      const Prelude& p = piece.prelude;
      const bool tells = p.kind == RecordKind::kIndex || p.kind == RecordKind::kFooter;
      if (!tells || p.log_tag != tag_ || p.first_step == 0) return;
      const std::uint64_t last = p.first_step + p.step_count - 1;
      // One that ends before the chunks do is of another session with an equal header.
      const bool fits = result_.chunks.empty() || last + 1 >= result_.chunks.back().end_step();
      if (fits) result_.last_step = std::max(last, result_.last_step.value_or(0));
    };
    for (const Piece& piece : pieces_.records) look(piece);
    for (const Piece& piece : pieces_.footers) look(piece);
  }

  void account() {
    if (tag_) result_.others = parts_of_others(pieces_, *tag_);
    std::uint64_t kept = copies_;
    for (const Piece& piece : pieces_.footers) kept += piece.prelude.log_tag == tag_ ? kFooterBytes : 0;
    for (const Piece& piece : pieces_.records) {
      const bool own = piece.prelude.kind != RecordKind::kChunk && piece.prelude.log_tag == tag_;
      if (own) kept += kPreludeBytes + piece.prelude.stored_bytes;
    }
    if (header_was_loose_) kept += kPreludeBytes + result_.header->prelude.stored_bytes;
    std::set<std::uint64_t> payloads;
    for (const SavedChunk& chunk : result_.chunks) {
      payloads.insert(chunk.payload);
      kept += kPreludeBytes + chunk.prelude.stored_bytes;
      if (!chunk.chain_known) {
        note(chunk.payload, to_string(MissingSteps{chunk.first_step(), chunk.prelude.step_count}) +
                                ": the chunk's prelude was damaged and is made anew");
      }
    }
    for (const SavedChunk& chunk : candidates_) {
      if (payloads.contains(chunk.payload)) continue;
      const std::string steps = to_string(MissingSteps{chunk.first_step(), chunk.prelude.step_count});
      const auto same = [&](const SavedChunk& saved) { return saved.prelude.stored_hash == chunk.prelude.stored_hash; };
      if (std::ranges::any_of(result_.chunks, same)) {
        note(chunk.payload, steps + ": is there a second time");
        continue;
      }
      note(chunk.payload, steps + ": a whole chunk that does not fit the others");
      ++result_.others.unfit_chunks;
      result_.others.unfit_steps += chunk.prelude.step_count;
    }
    for (const Scrap& scrap : pieces_.scraps) note(scrap.begin, scrap_text(source_, scrap));
    result_.lost_bytes = source_.size() - std::min(kept, source_.size());
    std::ranges::stable_sort(result_.damages, {}, &Damage::offset);
  }

  const ByteSource& source_;
  Pieces pieces_;
  std::vector<LooseFrame> frames_;
  std::optional<std::uint64_t> tag_;
  bool header_was_loose_ = false;
  std::vector<SavedChunk> candidates_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> known_;  // chunks by stored hash and chain
  std::uint64_t copies_ = 0;                                 // bytes of second copies
  Salvage result_;
};

}  // namespace

Result<Salvage> salvage(const ByteSource& source) { return Salvager(source).run(); }

}  // namespace tumble::replay
