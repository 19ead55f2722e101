#include "replay/log/log_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "replay/codec/header_codec.h"
#include "replay/format/limits.h"
#include "replay/log/chunk_ahead.h"
#include "src/model/limits.h"

namespace tumble::replay {
namespace {

Error at(const ByteSource& source, const std::string& record, std::uint64_t offset, const Error& error) {
  return {error.kind, source.name() + ": " + record + " at byte " + std::to_string(offset) + ": " + error.message};
}

Status read_prelude(const ByteSource& source, std::uint64_t offset, Prelude& prelude) {
  std::array<std::byte, kPreludeBytes> bytes;
  if (Status ok = source.read(offset, bytes); !ok.ok()) return ok;
  Result<Prelude> decoded = decode_prelude(bytes);
  if (!decoded.ok()) return at(source, "record", offset, decoded.error());
  prelude = *decoded;
  return {};
}

/// The index of a finished log, if footer and index are there, whole and tell of the whole file. Errors say what is
/// not.
Result<std::vector<ChunkPlace>> read_index(const ByteSource& source, const Prelude& header,
                                           const std::vector<Gap>& gaps) {
  const std::uint64_t begin = kPreludeBytes + header.stored_bytes;
  if (source.size() < begin + kFooterBytes) return damaged("no footer");
  std::array<std::byte, kFooterBytes> bytes;
  if (Status ok = source.read(source.size() - kFooterBytes, bytes); !ok.ok()) return ok.error();
  Result<Footer> footer = decode_footer(bytes);
  if (!footer.ok()) return footer.error();
  if (footer->file_bytes != source.size() || footer->prelude.log_tag != header.log_tag ||
      footer->index_offset < begin || footer->index_offset > source.size() - kFooterBytes - kPreludeBytes) {
    return damaged("the footer is another file's");
  }
  Prelude prelude;
  if (Status ok = read_prelude(source, footer->index_offset, prelude); !ok.ok()) return ok.error();
  if (prelude.kind != RecordKind::kIndex || prelude.log_tag != header.log_tag) return damaged("no index");
  Result<MessageBytes> message = read_payload(source, footer->index_offset, prelude);
  if (!message.ok()) return message.error();
  Result<std::vector<ChunkPlace>> places = decode_index(*message);
  if (!places.ok()) return places.error();
  std::uint64_t offset = begin;
  std::uint64_t step = header.first_step + 1;
  for (const ChunkPlace& place : *places) {
    step = step_after(step, gaps);
    const bool fits = place.offset == offset && place.length > kPreludeBytes &&
                      place.length <= footer->index_offset - offset && place.first_step == step &&
                      place.step_count <= kStepsPerChunkRead;
    if (!fits) return damaged("index: the row of step " + std::to_string(place.first_step) + " cannot be");
    offset += place.length;
    step += place.step_count;
  }
  if (places->empty() || offset != footer->index_offset || step != header.first_step + footer->prelude.step_count + 1 ||
      places->back().chain_after != footer->prelude.chain_after) {
    return damaged("index: it does not tell of all chunks before it");
  }
  return places;
}

}  // namespace

Result<MessageBytes> read_payload(const ByteSource& source, std::uint64_t offset, const Prelude& prelude) {
  const std::string record = name_of(prelude.kind);
  if (prelude.stored_bytes > source.size() || offset + kPreludeBytes > source.size() - prelude.stored_bytes) {
    return damaged(source.name() + ": " + record + " at byte " + std::to_string(offset) + ": the file ends at byte " +
                   std::to_string(source.size()) + ", inside the record");
  }
  std::vector<std::byte> stored(prelude.stored_bytes);
  if (Status ok = source.read(offset + kPreludeBytes, stored); !ok.ok()) return ok.error();
  const Hash128 found = hash_bytes(stored);
  if (found != prelude.stored_hash) {
    return at(source, record, offset,
              damaged("the stored bytes are not those that were written: found hash " + to_string(found) + ", wanted " +
                      to_string(prelude.stored_hash)));
  }
  Result<MessageBytes> message = decompress(stored, prelude.raw_bytes, raw_bytes_max(prelude, offset));
  if (!message.ok()) return at(source, record, offset, message.error());
  return message;
}

Result<ChunkDecoder> read_chunk(const ByteSource& source, const ChunkPlace& place, const Prelude& header,
                                const LogHeader& log) {
  Prelude prelude;
  if (Status ok = read_prelude(source, place.offset, prelude); !ok.ok()) return ok.error();
  const ChunkPlace found = {place.offset,        kPreludeBytes + prelude.stored_bytes,
                            prelude.first_step,  prelude.step_count,
                            prelude.chain_after, prelude.stored_hash};
  const auto wrong = [&](const Error& error) { return at(source, "chunk", place.offset, error); };
  if (found != place || prelude.kind != RecordKind::kChunk || prelude.log_tag != header.log_tag) {
    return wrong(damaged("the index tells of another record here than the file has"));
  }
  Result<MessageBytes> message = read_payload(source, place.offset, prelude);
  if (!message.ok()) return message.error();
  Result<ChunkDecoder> decoder = ChunkDecoder::open(*message);
  if (!decoder.ok()) return wrong(decoder.error());
  if (decoder->first_step() != place.first_step || decoder->step_count() != place.step_count) {
    return wrong(damaged("the steps inside are not those that the record tells of"));
  }
  Hash128 chain = prelude.chain_before;
  for (std::size_t i = 0; i < decoder->step_count(); ++i) {
    const StepRecord& step = decoder->without_states(i);
    chain = chain_next(chain, step);
    if (!log.phases.empty() && step.phase_words.size() % log.phases.size() != 0) {
      return wrong(damaged("step " + std::to_string(step.step) + " has " + std::to_string(step.phase_words.size()) +
                           " phase words, wanted a multiple of the " + std::to_string(log.phases.size()) + " phases"));
    }
  }
  if (chain != prelude.chain_after) {
    return wrong(
        damaged("found chain " + to_string(chain) + " after the last step, wanted " + to_string(prelude.chain_after)));
  }
  return decoder;
}

Result<LogReader> LogReader::open(const std::string& path) {
  Result<std::unique_ptr<ByteSource>> source = open_file_source(path);
  if (!source.ok()) return source.error();
  return open(*std::move(source));
}

Result<LogReader> LogReader::open(std::unique_ptr<ByteSource> source) {
  LogReader reader(std::move(source));
  if (Status ok = reader.read_header(); !ok.ok()) return ok.error();
  reader.find_chunks();
  return reader;
}

Status LogReader::read_header() {
  const std::uint64_t size = source_->size();
  if (size == 0) return damaged(name() + ": the file is empty; nothing of a log can be read");
  std::array<std::byte, kPreludeBytes> bytes = {};
  const auto start = std::span(bytes).first(std::min<std::uint64_t>(size, kPreludeBytes));
  if (Status ok = source_->read(0, start); !ok.ok()) return ok;
  if (!starts_like_log(start) && nearly_starts_like_log(start)) {
    return damaged(name() + ": header at byte 0: the bytes that every log begins with are damaged");
  }
  if (!starts_like_log(start))
    return bad_input(name() + ": is not a log: it does not begin as one; was another file meant?");
  if (size < kPreludeBytes) {
    return damaged(name() + ": torn at byte " + std::to_string(size) + ", inside the header; nothing can be saved");
  }
  Result<Prelude> prelude = decode_prelude(bytes);
  if (!prelude.ok()) return at(*source_, "header", 0, prelude.error());
  header_prelude_ = *prelude;
  if (prelude->kind != RecordKind::kHeader || prelude->sequence != 0) {
    return damaged(name() + ": begins with a " + name_of(prelude->kind) + ", wanted the header; the start is missing");
  }
  if (prelude->stored_bytes > size - kPreludeBytes) {
    return damaged(name() + ": torn at byte " + std::to_string(size) + ", inside the header, which ends at byte " +
                   std::to_string(kPreludeBytes + prelude->stored_bytes) + "; nothing can be saved");
  }
  Result<MessageBytes> message = read_payload(*source_, 0, *prelude);
  if (!message.ok()) return message.error();
  Result<LogHeader> header = decode_header(*message);
  if (!header.ok()) return at(*source_, "header", 0, header.error());
  header_ = *std::move(header);
  header_.format_major = prelude->major;
  header_.format_minor = prelude->minor;
  if (prelude->stored_hash.low != prelude->log_tag) {
    return damaged(name() + ": header at byte 0: its tag is not its own hash");
  }
  if (header_.goes_on) header_.goes_on->chain = prelude->chain_after;
  const std::uint64_t wanted = header_.goes_on ? header_.goes_on->step : 0;
  if (prelude->first_step == wanted && wanted < sim::kStepsMax) return {};
  return damaged(name() + ": header at byte 0: found a log that begins with state " +
                 std::to_string(prelude->first_step) + ", wanted " + std::to_string(wanted));
}

/// By the index if it is there and right, else by a walk over the preludes.
void LogReader::find_chunks() {
  Result<std::vector<ChunkPlace>> index = read_index(*source_, header_prelude_, header_.gaps());
  if (index.ok()) {
    chunks_ = *std::move(index);
    condition_.finished = true;
    condition_.gaps = header_.gaps();
    return;
  }
  Scan scan = scan_records(*source_, header_prelude_, header_.gaps());
  chunks_ = std::move(scan.chunks);
  condition_ = std::move(scan.condition);
  if (condition_.finished && condition_.damages.empty()) {
    const std::uint64_t where = scan.index ? scan.index->offset : scan.footer_offset;
    condition_.damages.push_back({RecordKind::kIndex, where, index.error().message});
  }
}

Error LogReader::no_such(const char* what, std::uint64_t k) const {
  const std::string found = name() + ": found no " + what + " " + std::to_string(k) + ", the log has ";
  if (chunks_.empty()) return damaged(found + "not one complete chunk");
  return bad_input(found + "steps " + std::to_string(first_state()) + " to " + std::to_string(last_step()));
}

Result<std::size_t> LogReader::chunk_of(std::uint64_t k) const {
  const auto after =
      std::upper_bound(chunks_.begin(), chunks_.end(), k,
                       [](std::uint64_t step, const ChunkPlace& place) { return step < place.first_step; });
  if (k <= first_state() || k > last_step()) {
    return no_such("step", k);
  }
  if (after == chunks_.begin() || k >= std::prev(after)->end_step()) {
    const char* why = lost_at(k) != nullptr ? " was lost before this log was recovered from a damaged one"
                                            : " was in a record that is damaged";
    return damaged(name() + ": step " + std::to_string(k) + why + "; steps from " +
                   std::to_string(after == chunks_.end() ? last_step() : after->first_step) + " on can be read");
  }
  return static_cast<std::size_t>(after - chunks_.begin()) - 1;
}

const Gap* LogReader::lost_at(std::uint64_t k) const {
  const std::vector<Gap>& gaps = header_.gaps();
  const auto after = std::ranges::upper_bound(gaps, k, {}, &Gap::first_step);
  return after != gaps.begin() && k < std::prev(after)->end_step() ? &*std::prev(after) : nullptr;
}

void LogReader::read_ahead(bool on) {
  ahead_ = on ? std::make_shared<ChunkAhead>(*source_, header_prelude_, header_) : nullptr;
}

Result<ChunkDecoder*> LogReader::load(std::size_t chunk) {
  if (loaded_ != chunk) {
    loaded_.reset();
    decoder_.reset();  // first: a chunk of many bodies takes much
    std::optional<Result<ChunkDecoder>> decoder = ahead_ ? ahead_->take(chunk) : std::nullopt;
    if (!decoder) decoder = read_chunk(*source_, chunks_[chunk], header_prelude_, header_);
    if (!decoder->ok()) return decoder->error();
    decoder_ = **std::move(decoder);
    loaded_ = chunk;
    ++chunks_opened_;
    if (ahead_ && chunk + 1 < chunks_.size()) ahead_->begin(chunk + 1, chunks_[chunk + 1]);
  }
  return &*decoder_;
}

Result<const StepRecord*> LogReader::read(std::uint64_t k, bool with_states) {
  if (k == first_state()) {
    Result<const Keyframe*> start = keyframe_at_or_before(k);
    if (!start.ok()) return start.error();
    start_ = {};
    start_.step = k;
    copy_visible((*start)->state.bodies, start_.states);
    start_.has_states = true;
    start_.dt = (*start)->state.def.dt;
    start_.state_hash = sim::state_hash((*start)->state.bodies);
    return &start_;
  }
  Result<std::size_t> chunk = chunk_of(k);
  if (!chunk.ok()) return chunk.error();
  Result<ChunkDecoder*> decoder = load(*chunk);
  if (!decoder.ok()) return decoder.error();
  const std::size_t index = k - (*decoder)->first_step();
  if (!with_states) return &(*decoder)->without_states(index);
  Result<const StepRecord*> step = (*decoder)->step(index);
  if (!step.ok()) return at(*source_, "chunk", chunks_[*chunk].offset, step.error());
  return step;
}

Result<const StepRecord*> LogReader::read_step(std::uint64_t k) { return read(k, true); }
Result<const StepRecord*> LogReader::read_hashes(std::uint64_t k) { return read(k, false); }

Result<const Keyframe*> LogReader::keyframe_at_or_before(std::uint64_t k) {
  // State k stands before step k + 1; the chunk that begins there has it, the chunk of step k otherwise.
  const auto after =
      std::upper_bound(chunks_.begin(), chunks_.end(), k + 1,
                       [](std::uint64_t step, const ChunkPlace& place) { return step < place.first_step; });
  if (k < first_state() || k > last_step() || after == chunks_.begin()) {
    return no_such("state", k);
  }
  Result<ChunkDecoder*> decoder = load(static_cast<std::size_t>(after - chunks_.begin()) - 1);
  if (!decoder.ok()) return decoder.error();
  return &(*decoder)->keyframe();
}

Result<Hash128> LogReader::chain_at(std::uint64_t k) {
  if (k == first_state()) return header_prelude_.chain_after;
  Result<std::size_t> chunk = chunk_of(k);
  if (!chunk.ok()) return chunk.error();
  const ChunkPlace& place = chunks_[*chunk];
  if (k + 1 == place.end_step()) return place.chain_after;
  Prelude prelude;
  if (Status ok = read_prelude(*source_, place.offset, prelude); !ok.ok()) return ok.error();
  Result<ChunkDecoder*> decoder = load(*chunk);
  if (!decoder.ok()) return decoder.error();
  Hash128 chain = prelude.chain_before;
  for (std::uint64_t step = place.first_step; step <= k; ++step) {
    chain = chain_next(chain, (*decoder)->without_states(step - place.first_step));
  }
  return chain;
}

}  // namespace tumble::replay
