#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/byte_io.h"

namespace tumble::replay {

using MemoryFile = std::shared_ptr<std::vector<std::byte>>;

/// Writes a log to memory instead of a file, for sessions that are judged and discarded.
class MemoryByteSink : public ByteSink {
 public:
  /// name: for messages.
  MemoryByteSink(MemoryFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  Result<std::size_t> write_some(std::span<const std::byte> bytes) override;
  void truncate(std::uint64_t size) override;
  Status sync() override { return {}; }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  MemoryFile file_;
  std::string name_;
};

/// Reads a log from memory.
class MemoryByteSource : public ByteSource {
 public:
  MemoryByteSource(MemoryFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  [[nodiscard]] std::uint64_t size() const override { return file_->size(); }
  Status read(std::uint64_t offset, std::span<std::byte> bytes) const override;
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  MemoryFile file_;
  std::string name_;
};

}  // namespace tumble::replay
