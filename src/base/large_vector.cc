#include "src/base/large_vector.h"

#include <algorithm>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace tumble {
namespace {

constexpr std::size_t kLarge = 1U << 20U;      // bytes
constexpr std::size_t kLargePage = 1U << 21U;  // bytes

// Size and alignment of the memory for an array: whole large pages from the size on that fills half of one.
std::pair<std::size_t, std::align_val_t> block_for(std::size_t bytes, std::size_t alignment) {
  if (bytes < kLarge) return {bytes, std::align_val_t{alignment}};
  return {(bytes + kLargePage - 1) / kLargePage * kLargePage, std::align_val_t{std::max(alignment, kLargePage)}};
}

}  // namespace

void* allocate_large(std::size_t bytes, std::size_t alignment) {
  const auto [size, aligned] = block_for(bytes, alignment);
  void* const memory = ::operator new(size, aligned);
#ifdef __linux__
  if (size >= kLargePage) madvise(memory, size, MADV_HUGEPAGE);  // a system that refuses gives small pages
#endif
  return memory;
}

void free_large(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  ::operator delete(memory, block_for(bytes, alignment).second);
}

}  // namespace tumble
