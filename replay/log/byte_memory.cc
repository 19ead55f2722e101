#include "replay/log/byte_memory.h"

#include <cstring>
#include <new>

namespace tumble::replay {

Result<std::size_t> MemoryByteSink::write_some(std::span<const std::byte> bytes) {
  try {
    file_->insert(file_->end(), bytes.begin(), bytes.end());
  } catch (const std::bad_alloc&) {
    return cannot_finish("out of memory");
  }
  return bytes.size();
}

void MemoryByteSink::truncate(std::uint64_t size) {
  if (size < file_->size()) file_->resize(size);
}

Status MemoryByteSource::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (offset > file_->size() || bytes.size() > file_->size() - offset) {
    return damaged(name_ + ": it ends at byte " + std::to_string(file_->size()) + ", before the " +
                   std::to_string(bytes.size()) + " bytes wanted at byte " + std::to_string(offset));
  }
  if (!bytes.empty()) std::memcpy(bytes.data(), file_->data() + offset, bytes.size());
  return {};
}

}  // namespace tumble::replay
