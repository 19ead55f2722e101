#include "replay/log/record_reader.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "replay/codec/header_codec.h"
#include "replay/codec/index_codec.h"
#include "replay/format/chain.h"
#include "src/base/check.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {

Error error_at(const ByteSource& source, const std::string& record, std::uint64_t offset, const Error& error) {
  return {error.kind, source.name() + ": " + record + " at byte " + std::to_string(offset) + ": " + error.message};
}

ChunkRules rules_of(const Prelude& prelude, const LogHeader& header) {
  return {prelude.log_tag, header.phases.size(), header.hashes, &header.declared.channels};
}

ChunkPlace place_of(const Prelude& prelude, std::uint64_t offset) {
  return {offset,
          kPreludeBytes + prelude.stored_bytes,
          prelude.first_step,
          prelude.step_count,
          prelude.chain_after,
          prelude.stored_hash};
}

Result<Prelude> RecordReader::read_prelude(std::uint64_t offset) const {
  const auto bytes = read_bytes<kPreludeBytes>(offset);
  if (!bytes.ok()) return bytes.error();
  Result<Prelude> prelude = decode_prelude(*bytes);
  if (!prelude.ok()) return error_at(source_, "record", offset, prelude.error());
  return prelude;
}

Result<MessageBytes> RecordReader::read_payload(std::uint64_t offset, const Prelude& prelude) const {
  const std::string record = name_of(prelude.kind);
  if (prelude.stored_bytes > source_.size() || offset + kPreludeBytes > source_.size() - prelude.stored_bytes) {
    return error_at(source_, record, offset,
                    damaged("the file ends at byte " + std::to_string(source_.size()) + ", inside the record"));
  }
  std::vector<std::byte> stored(prelude.stored_bytes);
  if (Status ok = source_.read(offset + kPreludeBytes, stored); !ok.ok()) return ok.error();
  const Hash128 found = hash_bytes(stored);
  if (found != prelude.stored_hash) {
    return error_at(source_, record, offset,
                    damaged("the stored bytes are not those that were written: found hash " + to_string(found) +
                            ", wanted " + to_string(prelude.stored_hash)));
  }
  Result<MessageBytes> message = decompress(stored, prelude.raw_bytes, raw_bytes_max(prelude, offset));
  if (!message.ok()) return error_at(source_, record, offset, message.error());
  return message;
}

namespace {

Status check_types(const ChunkDecoder& chunk, const std::vector<Channel>& channels) {
  for (const auto& [index, type] : chunk.channels()) {
    if (index < channels.size() && channels[index].type == type) continue;
    return damaged("found values of channel " + std::to_string(index) + " of kind " + name_of(type.kind) +
                   " and scope " + name_of(type.scope) + ", which the header does not declare so");
  }
  return {};
}

/// What `import` reads begins so: a stream, an archive of arrays, a table with or without lines before its names.
bool is_for_import(std::span<const std::byte> start) {
  const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
  const std::string_view line = text.substr(0, text.find('\n'));
  if (line.starts_with("# ") && line.find(": ") != std::string_view::npos) return true;
  return std::ranges::any_of(std::array<std::string_view, 4>{"\x89tumblestream", "PK\x03\x04", "step,", "time,"},
                             [&](std::string_view head) { return text.starts_with(head); });
}

/// What a file is that is no log, and what to do with it.
std::string no_log(std::string_view name, std::span<const std::byte> start) {
  if (is_for_import(start)) {
    return ": is no log yet: 'tumble import FILE' makes one of a recorder's stream, a table or an archive of arrays";
  }
  if (name.ends_with(".toml"))
    return ": is not a log: it has the name of a scene, of which 'tumble record FILE' makes one";
  return ": is not a log: it does not begin as one; was another file meant?";
}

}  // namespace

/// The prelude at byte 0. A file that is no log, a damaged log and a torn one get errors of their own.
Result<Prelude> RecordReader::read_header_prelude() const {
  const std::uint64_t size = source_.size();
  if (size == 0) return damaged(source_.name() + ": the file is empty; nothing of a log can be read");
  std::array<std::byte, kPreludeBytes> bytes = {};
  const auto start = std::span(bytes).first(std::min<std::uint64_t>(size, kPreludeBytes));
  if (Status ok = source_.read(0, start); !ok.ok()) return ok.error();
  if (!starts_like_log(start) && nearly_starts_like_log(start)) {
    return damaged(source_.name() + ": header at byte 0: the bytes that every log begins with are damaged");
  }
  if (!starts_like_log(start)) return bad_input(source_.name() + no_log(source_.name(), start));
  if (size < kPreludeBytes) {
    return damaged(source_.name() + ": torn at byte " + std::to_string(size) +
                   ", inside the header; nothing can be saved");
  }
  Result<Prelude> prelude = decode_prelude(bytes);
  if (!prelude.ok()) return error_at(source_, "header", 0, prelude.error());
  if (prelude->kind != RecordKind::kHeader || prelude->sequence != 0) {
    return damaged(source_.name() + ": begins with a " + name_of(prelude->kind) +
                   ", wanted the header; the start is missing");
  }
  if (prelude->stored_bytes > size - kPreludeBytes) {
    return damaged(source_.name() + ": torn at byte " + std::to_string(size) +
                   ", inside the header, which ends at byte " + std::to_string(kPreludeBytes + prelude->stored_bytes) +
                   "; nothing can be saved");
  }
  return prelude;
}

Result<HeaderRecord> RecordReader::read_header() const {
  const Result<Prelude> prelude = read_header_prelude();
  if (!prelude.ok()) return prelude.error();
  const Result<MessageBytes> message = read_payload(0, *prelude);
  if (!message.ok()) return message.error();
  Result<LogHeader> header = decode_header(*message);
  if (!header.ok()) return error_at(source_, "header", 0, header.error());
  header->format_major = prelude->major;
  header->format_minor = prelude->minor;
  if (prelude->stored_hash.low != prelude->log_tag) {
    return damaged(source_.name() + ": header at byte 0: its tag is not its own hash");
  }
  if (header->goes_on) header->goes_on->chain = prelude->chain_after;
  const std::uint64_t wanted = header->goes_on ? header->goes_on->step : 0;
  if (prelude->first_step == wanted && wanted < sim::kStepsMax) return HeaderRecord{*prelude, *std::move(header)};
  return damaged(source_.name() + ": header at byte 0: found a log that begins with state " +
                 std::to_string(prelude->first_step) + ", wanted " + std::to_string(wanted));
}

// The stored hash proves that the bytes are those that were written. The chain proves more: that inputs, phase words,
// hashes and counters belong to this session and this place in it. States are not part of this check, because decoding
// them is the expensive part; verify() compares states with their hashes.
Result<ChunkDecoder> RecordReader::read_chunk(const ChunkPlace& place, const ChunkRules& rules) const {
  const Result<Prelude> prelude = read_prelude(place.offset);
  if (!prelude.ok()) return prelude.error();
  const auto wrong = [&](const Error& error) { return error_at(source_, "chunk", place.offset, error); };
  if (place_of(*prelude, place.offset) != place || prelude->kind != RecordKind::kChunk ||
      prelude->log_tag != rules.log_tag) {
    return wrong(damaged("the index tells of another record here than the file has"));
  }
  Result<MessageBytes> message = read_payload(place.offset, *prelude);
  if (!message.ok()) return message.error();
  Result<ChunkDecoder> decoder = ChunkDecoder::open(*message);
  if (!decoder.ok()) return wrong(decoder.error());
  if (decoder->first_step() != place.first_step || decoder->step_count() != place.step_count) {
    return wrong(damaged("the steps inside are not those that the record tells of"));
  }
  if (rules.channels != nullptr) {
    if (Status ok = check_types(*decoder, *rules.channels); !ok.ok()) return wrong(ok.error());
  }
  Hash128 chain = prelude->chain_before;
  for (std::size_t i = 0; i < decoder->step_count(); ++i) {
    const StepRecord& step = decoder->without_states(i);
    chain = chain_next(chain, step);
    if (!rules.hashes.holds(step.step) && !step.phase_words.empty()) {
      return wrong(damaged("step " + std::to_string(step.step) + " has " + std::to_string(step.phase_words.size()) +
                           " phase words, wanted none: the header's hashes are of " + to_string(rules.hashes)));
    }
    if (rules.phase_count > 0 && step.phase_words.size() % rules.phase_count != 0) {
      return wrong(damaged("step " + std::to_string(step.step) + " has " + std::to_string(step.phase_words.size()) +
                           " phase words, wanted a multiple of the " + std::to_string(rules.phase_count) + " phases"));
    }
  }
  if (chain != prelude->chain_after) {
    return wrong(
        damaged("found chain " + to_string(chain) + " after the last step, wanted " + to_string(prelude->chain_after)));
  }
  SIM_CHECK(decoder->keyframe().state.step + 1 == place.first_step, decoder->keyframe().state.step, place.first_step);
  return decoder;
}

void RecordReader::add_bodies(const ChunkPlace& place, const ChunkRules& rules, BodyTable& bodies) const {
  const Result<Prelude> prelude = read_prelude(place.offset);
  if (!prelude.ok() || prelude->major < kExtrasMajor) return;  // without extras
  const Result<ChunkDecoder> chunk = read_chunk(place, rules);
  if (!chunk.ok()) return;
  for (std::size_t k = 0; k < chunk->step_count(); ++k) {
    const Extras& extras = chunk->without_states(k).extras;
    bodies.add(extras.bodies, extras.shapes);
  }
}

Result<std::vector<ChunkPlace>> RecordReader::read_index(std::uint64_t offset, std::uint64_t log_tag) const {
  const Result<Prelude> prelude = read_prelude(offset);
  if (!prelude.ok()) return prelude.error();
  if (prelude->kind != RecordKind::kIndex || prelude->log_tag != log_tag) return damaged("no index");
  const Result<MessageBytes> message = read_payload(offset, *prelude);
  if (!message.ok()) return message.error();
  return decode_index(*message);
}

}  // namespace tumble::replay
