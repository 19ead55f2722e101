#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/files/output_file.h"
#include "tumble/sim/result.h"

/// Writes an MCAP file from its start to its end: messages in chunks, each compressed by zstd, and an index.
/// Format: https://mcap.dev/spec
namespace tumble::replay {

class McapFile {
 public:
  explicit McapFile(files::OutputFile& file) : file_(file) {}

  /// Call first. library: the program that writes.
  Status begin(const std::string& library, const std::map<std::string, std::string>& facts);

  /// Returns the number of the schema. content: a serialised google.protobuf.FileDescriptorSet.
  std::uint16_t add_schema(const std::string& name, std::string_view content);

  /// Returns the number of the channel. At most 65,535; the caller checks.
  std::uint16_t add_channel(std::uint16_t schema, const std::string& topic,
                            const std::map<std::string, std::string>& metadata = {});

  /// time: ns. Errors: the disk.
  Status add_message(std::uint16_t channel, std::uint64_t time, std::string_view message);

  /// Writes the last chunk, the index and the end.
  Status finish();

 private:
  struct ChannelState {
    std::string record;
    std::uint32_t sequence = 0;
    std::uint64_t messages = 0;
    bool in_file = false;  // its record and its schema's are in a chunk
    std::uint16_t schema = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> in_chunk;  // time, place of each message
  };
  struct SchemaState {
    std::string record;
    bool in_file = false;
  };
  struct ChunkPlace {
    std::uint64_t first_time = 0, last_time = 0;
    std::uint64_t offset = 0, bytes = 0, index_bytes = 0, packed = 0, size = 0;
    std::map<std::uint16_t, std::uint64_t> indexes;  // channel, offset
  };
  Status write(std::string_view bytes);
  Status write_chunk();
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] std::string statistics() const;

  files::OutputFile& file_;
  std::uint64_t offset_ = 0;
  std::uint32_t data_crc_ = 0;
  std::string chunk_;  // records, not compressed yet
  std::uint64_t first_time_ = 0, last_time_ = 0;
  std::vector<SchemaState> schemas_;    // number − 1
  std::vector<ChannelState> channels_;  // number
  std::vector<ChunkPlace> chunks_;
  std::pair<std::string, std::pair<std::uint64_t, std::uint64_t>> facts_;  // record's name; offset, bytes
  std::string packed_;
};

}  // namespace tumble::replay
