#include "tumble/replay/log_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "replay/codec/chunk_codec.h"
#include "replay/format/chain.h"
#include "replay/format/limits.h"
#include "replay/log/chunk_ahead.h"
#include "replay/log/record_reader.h"
#include "replay/log/scan.h"

namespace tumble::replay {
namespace {

/// The chunks that the index of a finished log lists. Errors (kDamaged): footer or index is missing or damaged, or the
/// rows do not cover all bytes between header and index.
///
/// The rows are trusted only if they cover the file without a hole, so that a log that opens by its index holds the
/// same chunks as one that is scanned.
Result<std::vector<ChunkPlace>> chunks_of_index(const ByteSource& source, const Prelude& header,
                                                const std::vector<MissingSteps>& missing) {
  const std::uint64_t begin = kPreludeBytes + header.stored_bytes;
  if (source.size() < begin + kFooterBytes) return damaged("no footer");
  const RecordReader records(source);
  const auto bytes = records.read_bytes<kFooterBytes>(source.size() - kFooterBytes);
  if (!bytes.ok()) return bytes.error();
  const Result<Footer> footer = decode_footer(*bytes);
  if (!footer.ok()) return footer.error();
  if (footer->file_bytes != source.size() || footer->prelude.log_tag != header.log_tag ||
      footer->index_offset < begin || footer->index_offset > source.size() - kFooterBytes - kPreludeBytes) {
    return damaged("the footer is another file's");
  }
  Result<std::vector<ChunkPlace>> places = records.read_index(footer->index_offset, header.log_tag);
  if (!places.ok()) return places.error();
  std::uint64_t offset = begin;
  std::uint64_t step = header.first_step + 1;
  for (const ChunkPlace& place : *places) {
    step = step_after(step, missing);
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

struct LogReader::State {
  explicit State(std::unique_ptr<ByteSource> from) : source(std::move(from)) {}

  void find_chunks();
  [[nodiscard]] std::uint64_t last_step() const;
  [[nodiscard]] ChunkRules rules() const { return rules_of(header.prelude, header.content); }
  [[nodiscard]] const MissingSteps* lost_at(std::uint64_t k) const;
  [[nodiscard]] Error no_such(const char* what, std::uint64_t k) const;
  [[nodiscard]] const ChunkPlace* chunk_at(std::uint64_t k) const;
  [[nodiscard]] Result<std::size_t> chunk_of(std::uint64_t k) const;
  Result<ChunkDecoder*> load(std::size_t chunk);
  Result<const StepRecord*> read(std::uint64_t k, bool with_states);
  Result<const Keyframe*> keyframe_at_or_before(std::uint64_t k);
  Result<Hash128> chain_at(std::uint64_t k);

  const BodyTable& body_table();

  std::unique_ptr<ByteSource> source;
  HeaderRecord header;
  std::optional<BodyTable> bodies;
  LogCondition condition;
  std::vector<ChunkPlace> chunks;
  std::optional<std::size_t> loaded;  // the chunk that decoder holds
  std::optional<ChunkDecoder> decoder;
  std::uint64_t opened = 0;
  StepRecord start;
  std::unique_ptr<ChunkAhead> ahead;  // last: its thread reads from source until it is destroyed
};

std::uint64_t LogReader::State::last_step() const {
  return chunks.empty() ? header.prelude.first_step : chunks.back().end_step() - 1;
}

/// Reads the index, or follows the preludes where the index is missing or wrong.
void LogReader::State::find_chunks() {
  Result<std::vector<ChunkPlace>> index = chunks_of_index(*source, header.prelude, header.content.missing());
  if (index.ok()) {
    chunks = *std::move(index);
    condition.finished = true;
    condition.missing = header.content.missing();
    return;
  }
  Scan scan = scan_records(*source, header.prelude, header.content.missing());
  chunks = std::move(scan.chunks);
  condition = std::move(scan.condition);
  if (condition.finished && condition.damages.empty()) {
    const std::uint64_t where = scan.index ? scan.index->offset : scan.footer_offset;
    condition.damages.push_back({RecordKind::kIndex, where, index.error().message});
  }
}

Error LogReader::State::no_such(const char* what, std::uint64_t k) const {
  const std::string found = source->name() + ": found no " + what + " " + std::to_string(k) + ", the log has ";
  if (chunks.empty()) return damaged(found + "not one complete chunk");
  return bad_input(found + "steps " + std::to_string(header.prelude.first_step) + " to " + std::to_string(last_step()));
}

const ChunkPlace* LogReader::State::chunk_at(std::uint64_t k) const {
  const auto after = std::ranges::upper_bound(chunks, k, {}, &ChunkPlace::first_step);
  return after != chunks.begin() && k < std::prev(after)->end_step() ? &*std::prev(after) : nullptr;
}

Result<std::size_t> LogReader::State::chunk_of(std::uint64_t k) const {
  const auto after = std::upper_bound(chunks.begin(), chunks.end(), k, [](std::uint64_t step, const ChunkPlace& place) {
    return step < place.first_step;
  });
  if (k <= header.prelude.first_step || k > last_step()) {
    return no_such("step", k);
  }
  if (after == chunks.begin() || k >= std::prev(after)->end_step()) {
    const char* why = lost_at(k) != nullptr ? " was lost before this log was recovered from a damaged one"
                                            : " was in a record that is damaged";
    return damaged(source->name() + ": step " + std::to_string(k) + why + "; steps from " +
                   std::to_string(after == chunks.end() ? last_step() : after->first_step) + " on can be read");
  }
  return static_cast<std::size_t>(after - chunks.begin()) - 1;
}

const MissingSteps* LogReader::State::lost_at(std::uint64_t k) const {
  const std::vector<MissingSteps>& missing = header.content.missing();
  const auto after = std::ranges::upper_bound(missing, k, {}, &MissingSteps::first_step);
  return after != missing.begin() && k < std::prev(after)->end_step() ? &*std::prev(after) : nullptr;
}

Result<ChunkDecoder*> LogReader::State::load(std::size_t chunk) {
  if (loaded != chunk) {
    loaded.reset();
    decoder.reset();  // first: a chunk of many bodies takes much memory
    std::optional<Result<ChunkDecoder>> next = ahead ? ahead->take(chunk) : std::nullopt;
    if (!next) next = RecordReader(*source).read_chunk(chunks[chunk], rules());
    if (!next->ok()) return next->error();
    decoder = **std::move(next);
    loaded = chunk;
    ++opened;
    if (ahead && chunk + 1 < chunks.size()) ahead->begin(chunk + 1, chunks[chunk + 1]);
  }
  return &*decoder;
}

Result<const StepRecord*> LogReader::State::read(std::uint64_t k, bool with_states) {
  if (k == header.prelude.first_step) {
    Result<const Keyframe*> first = keyframe_at_or_before(k);
    if (!first.ok()) return first.error();
    start = {};
    start.step = k;
    copy_visible((*first)->state.bodies, start.states);
    start.has_states = true;
    start.dt = (*first)->state.def.dt;
    start.state_hash = sim::state_hash((*first)->state.bodies);
    start.extras = header.content.declared.start;
    return &start;
  }
  Result<std::size_t> chunk = chunk_of(k);
  if (!chunk.ok()) return chunk.error();
  Result<ChunkDecoder*> loaded_chunk = load(*chunk);
  if (!loaded_chunk.ok()) return loaded_chunk.error();
  const std::size_t index = k - (*loaded_chunk)->first_step();
  if (!with_states) return &(*loaded_chunk)->without_states(index);
  Result<const StepRecord*> step = (*loaded_chunk)->step(index);
  if (!step.ok()) return error_at(*source, "chunk", chunks[*chunk].offset, step.error());
  return step;
}

Result<const Keyframe*> LogReader::State::keyframe_at_or_before(std::uint64_t k) {
  // State k stands before step k + 1; the chunk that begins there has it, the chunk of step k otherwise.
  const auto after =
      std::upper_bound(chunks.begin(), chunks.end(), k + 1,
                       [](std::uint64_t step, const ChunkPlace& place) { return step < place.first_step; });
  if (k < header.prelude.first_step || k > last_step() || after == chunks.begin()) {
    return no_such("state", k);
  }
  Result<ChunkDecoder*> loaded_chunk = load(static_cast<std::size_t>(after - chunks.begin()) - 1);
  if (!loaded_chunk.ok()) return loaded_chunk.error();
  return &(*loaded_chunk)->keyframe();
}

Result<Hash128> LogReader::State::chain_at(std::uint64_t k) {
  if (k == header.prelude.first_step) return header.prelude.chain_after;
  Result<std::size_t> chunk = chunk_of(k);
  if (!chunk.ok()) return chunk.error();
  const ChunkPlace& place = chunks[*chunk];
  if (k + 1 == place.end_step()) return place.chain_after;
  const Result<Prelude> prelude = RecordReader(*source).read_prelude(place.offset);
  if (!prelude.ok()) return prelude.error();
  Result<ChunkDecoder*> loaded_chunk = load(*chunk);
  if (!loaded_chunk.ok()) return loaded_chunk.error();
  Hash128 chain = prelude->chain_before;
  for (std::uint64_t step = place.first_step; step <= k; ++step) {
    chain = chain_next(chain, (*loaded_chunk)->without_states(step - place.first_step));
  }
  return chain;
}

const BodyTable& LogReader::State::body_table() {
  if (bodies) return *bodies;
  bodies.emplace();
  bodies->add(header.content.declared.bodies, header.content.declared.shapes);
  const RecordReader records(*source);
  if (!header.content.engine) return *bodies;
  for (const ChunkPlace& place : chunks) records.add_bodies(place, rules(), *bodies);
  return *bodies;
}

LogReader::LogReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
LogReader::LogReader(LogReader&&) noexcept = default;
LogReader& LogReader::operator=(LogReader&&) noexcept = default;
LogReader::~LogReader() = default;

Result<LogReader> LogReader::open(const std::string& path) {
  Result<std::unique_ptr<ByteSource>> source = open_file_source(path);
  if (!source.ok()) return source.error();
  return open(*std::move(source));
}

Result<LogReader> LogReader::open(std::unique_ptr<ByteSource> source) {
  auto state = std::make_unique<State>(std::move(source));
  Result<HeaderRecord> header = RecordReader(*state->source).read_header();
  if (!header.ok()) return header.error();
  state->header = *std::move(header);
  state->find_chunks();
  return LogReader(std::move(state));
}

const LogHeader& LogReader::header() const { return state_->header.content; }
std::string LogReader::name() const { return state_->source->name(); }
std::uint64_t LogReader::file_bytes() const { return state_->source->size(); }
const LogCondition& LogReader::condition() const { return state_->condition; }
std::uint64_t LogReader::first_state() const { return state_->header.prelude.first_step; }
std::uint64_t LogReader::last_step() const { return state_->last_step(); }
const MissingSteps* LogReader::lost_at(std::uint64_t k) const { return state_->lost_at(k); }
bool LogReader::holds(std::uint64_t k) const { return k == first_state() || state_->chunk_at(k) != nullptr; }
const std::vector<ChunkPlace>& LogReader::chunks() const { return state_->chunks; }
std::uint64_t LogReader::chunks_opened() const { return state_->opened; }
const ByteSource& LogReader::source() const { return *state_->source; }
const Prelude& LogReader::header_prelude() const { return state_->header.prelude; }

Result<const StepRecord*> LogReader::read_step(std::uint64_t k) { return state_->read(k, true); }
Result<const StepRecord*> LogReader::read_hashes(std::uint64_t k) { return state_->read(k, false); }
Result<const Keyframe*> LogReader::keyframe_at_or_before(std::uint64_t k) { return state_->keyframe_at_or_before(k); }
const BodyTable& LogReader::bodies() { return state_->body_table(); }
Result<Hash128> LogReader::chain_at(std::uint64_t k) { return state_->chain_at(k); }

void LogReader::read_ahead(bool on) {
  State& state = *state_;
  state.ahead = on ? std::make_unique<ChunkAhead>(RecordReader(*state.source), state.rules()) : nullptr;
}

}  // namespace tumble::replay
