#include "replay/export/scene/mcap_file.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>

#include "replay/export/plan/little_bytes.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kChunkBytes = std::size_t{4} << 20U;
constexpr int kLevel = 1;

enum Opcode : std::uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannelRecord = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kStatistics = 11,
  kMetadata = 12,
  kMetadataIndex = 13,
  kSummaryOffset = 14,
  kDataEnd = 15
};

std::uint32_t crc_on(std::uint32_t crc, std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_text(std::string_view text, std::string& bytes) {
  append_little(text.size(), 4, bytes);
  bytes += text;
}

void append_map(const std::map<std::string, std::string>& map, std::string& bytes) {
  std::string content;
  for (const auto& [key, value] : map) {
    append_text(key, content);
    append_text(value, content);
  }
  append_text(content, bytes);
}

std::string record(Opcode opcode, std::string_view content) {
  std::string bytes(1, static_cast<char>(opcode));
  append_little(content.size(), 8, bytes);
  bytes += content;
  return bytes;
}

}  // namespace

Status McapFile::write(std::string_view bytes) {
  offset_ += bytes.size();
  data_crc_ = crc_on(data_crc_, bytes);
  return file_.write(bytes);
}

Status McapFile::begin(const std::string& library, const std::map<std::string, std::string>& facts) {
  std::string header;
  append_text("", header);  // no profile
  append_text(library, header);
  if (Status ok = write(std::string(kMagic) + record(kHeader, header)); !ok.ok()) return ok;
  std::string content;
  append_text("session", content);
  append_map(facts, content);
  const std::string bytes = record(kMetadata, content);
  facts_ = {"session", {offset_, bytes.size()}};
  return write(bytes);
}

std::uint16_t McapFile::add_schema(const std::string& name, std::string_view content) {
  const auto number = static_cast<std::uint16_t>(schemas_.size() + 1);
  std::string bytes;
  append_little(number, 2, bytes);
  append_text(name, bytes);
  append_text("protobuf", bytes);
  append_text(content, bytes);
  schemas_.push_back({record(kSchema, bytes), false});
  return number;
}

std::uint16_t McapFile::add_channel(std::uint16_t schema, const std::string& topic,
                                    const std::map<std::string, std::string>& metadata) {
  const auto number = static_cast<std::uint16_t>(channels_.size());
  std::string bytes;
  append_little(number, 2, bytes);
  append_little(schema, 2, bytes);
  append_text(topic, bytes);
  append_text("protobuf", bytes);
  append_map(metadata, bytes);
  channels_.emplace_back();
  channels_.back().record = record(kChannelRecord, bytes);
  channels_.back().schema = schema;
  return number;
}

Status McapFile::add_message(std::uint16_t channel, std::uint64_t time, std::string_view message) {
  ChannelState& state = channels_.at(channel);
  if (!state.in_file) {
    SchemaState& schema = schemas_.at(state.schema - 1U);
    if (!schema.in_file) chunk_ += schema.record;
    schema.in_file = true;
    chunk_ += state.record;
    state.in_file = true;
  }
  const bool is_first = std::ranges::all_of(channels_, [](const ChannelState& c) { return c.in_chunk.empty(); });
  first_time_ = is_first ? time : std::min(first_time_, time);
  last_time_ = is_first ? time : std::max(last_time_, time);
  state.in_chunk.emplace_back(time, chunk_.size());
  ++state.messages;
  chunk_ += static_cast<char>(kMessage);
  append_little(2 + 4 + 8 + 8 + message.size(), 8, chunk_);
  append_little(channel, 2, chunk_);
  append_little(state.sequence++, 4, chunk_);
  append_little(time, 8, chunk_);
  append_little(time, 8, chunk_);
  chunk_ += message;
  return chunk_.size() < kChunkBytes ? Status() : write_chunk();
}

Status McapFile::write_chunk() {
  if (chunk_.empty()) return {};
  packed_.resize(ZSTD_compressBound(chunk_.size()));
  const std::size_t packed = ZSTD_compress(packed_.data(), packed_.size(), chunk_.data(), chunk_.size(), kLevel);
  if (ZSTD_isError(packed) != 0) return cannot_finish(std::string("zstd: ") + ZSTD_getErrorName(packed));
  ChunkPlace place = {first_time_, last_time_, offset_, 0, 0, packed, chunk_.size(), {}};
  std::string head;
  append_little(first_time_, 8, head);
  append_little(last_time_, 8, head);
  append_little(chunk_.size(), 8, head);
  append_little(crc_on(0, chunk_), 4, head);
  append_text("zstd", head);
  append_little(packed, 8, head);
  std::string start(1, static_cast<char>(kChunk));
  append_little(head.size() + packed, 8, start);
  place.bytes = start.size() + head.size() + packed;
  if (Status ok = write(start + head); !ok.ok()) return ok;
  if (Status ok = write(std::string_view(packed_).substr(0, packed)); !ok.ok()) return ok;
  const std::uint64_t indexes = offset_;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ChannelState& channel = channels_[i];
    if (channel.in_chunk.empty()) continue;
    std::string content, entries;
    append_little(i, 2, content);
    for (const auto& [time, at] : channel.in_chunk) {
      append_little(time, 8, entries);
      append_little(at, 8, entries);
    }
    append_text(entries, content);
    place.indexes.emplace(static_cast<std::uint16_t>(i), offset_);
    if (Status ok = write(record(kMessageIndex, content)); !ok.ok()) return ok;
    channel.in_chunk.clear();
  }
  place.index_bytes = offset_ - indexes;
  chunks_.push_back(std::move(place));
  chunk_.clear();
  return {};
}

std::string McapFile::statistics() const {
  std::string content, counts;
  std::uint64_t messages = 0;
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (!channels_[i].in_file) continue;
    ++used;
    messages += channels_[i].messages;
    append_little(i, 2, counts);
    append_little(channels_[i].messages, 8, counts);
  }
  const auto schemas = std::ranges::count_if(schemas_, [](const SchemaState& schema) { return schema.in_file; });
  append_little(messages, 8, content);
  append_little(static_cast<std::uint64_t>(schemas), 2, content);
  append_little(used, 4, content);
  append_little(0, 4, content);  // attachments
  append_little(1, 4, content);  // metadata
  append_little(chunks_.size(), 4, content);
  append_little(chunks_.empty() ? 0 : chunks_.front().first_time, 8, content);
  append_little(chunks_.empty() ? 0 : chunks_.back().last_time, 8, content);
  append_text(counts, content);
  return record(kStatistics, content);
}

/// The groups of the summary, then their places.
std::string McapFile::summary() const {
  std::vector<std::pair<Opcode, std::string>> groups(5);
  groups[0].first = kSchema;
  for (const SchemaState& schema : schemas_) groups[0].second += schema.in_file ? schema.record : "";
  groups[1].first = kChannelRecord;
  for (const ChannelState& channel : channels_) groups[1].second += channel.in_file ? channel.record : "";
  groups[2] = {kStatistics, statistics()};
  groups[3].first = kChunkIndex;
  for (const ChunkPlace& place : chunks_) {
    std::string content, indexes;
    for (const std::uint64_t number : {place.first_time, place.last_time, place.offset, place.bytes}) {
      append_little(number, 8, content);
    }
    for (const auto& [channel, offset] : place.indexes) {
      append_little(channel, 2, indexes);
      append_little(offset, 8, indexes);
    }
    append_text(indexes, content);
    append_little(place.index_bytes, 8, content);
    append_text("zstd", content);
    append_little(place.packed, 8, content);
    append_little(place.size, 8, content);
    groups[3].second += record(kChunkIndex, content);
  }
  std::string facts;
  append_little(facts_.second.first, 8, facts);
  append_little(facts_.second.second, 8, facts);
  append_text(facts_.first, facts);
  groups[4] = {kMetadataIndex, record(kMetadataIndex, facts)};
  std::string bytes, offsets;
  for (const auto& [opcode, group] : groups) {
    if (group.empty()) continue;
    std::string content(1, static_cast<char>(opcode));
    append_little(offset_ + bytes.size(), 8, content);
    append_little(group.size(), 8, content);
    offsets += record(kSummaryOffset, content);
    bytes += group;
  }
  const std::uint64_t offsets_at = offset_ + bytes.size();
  bytes += offsets;
  std::string footer(1, static_cast<char>(kFooter));
  append_little(8 + 8 + 4, 8, footer);
  append_little(offset_, 8, footer);
  append_little(offsets_at, 8, footer);
  bytes += footer;
  append_little(crc_on(0, bytes), 4, bytes);
  return bytes;
}

Status McapFile::finish() {
  if (Status ok = write_chunk(); !ok.ok()) return ok;
  std::string crc;
  append_little(data_crc_, 4, crc);
  if (Status ok = write(record(kDataEnd, crc)); !ok.ok()) return ok;
  return write(summary() + std::string(kMagic));
}

}  // namespace tumble::replay
