#include "tests/support/allocations.h"

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> blocks;
std::atomic<std::int64_t> held;

void* taken(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  held += static_cast<std::int64_t>(malloc_usable_size(block));
  return block;
}

void give_back(void* block) {
  held -= static_cast<std::int64_t>(malloc_usable_size(block));
  std::free(block);
}

}  // namespace

namespace tumble::test {

std::uint64_t allocations() { return blocks; }
std::int64_t bytes_held() { return held; }

}  // namespace tumble::test

// The linker's --wrap gives these names to the calls and to what they would have called; the labels keep them out of
// our code.
extern "C" {
void* real_malloc(std::size_t size) __asm__("__real_malloc");
void* real_calloc(std::size_t count, std::size_t size) __asm__("__real_calloc");
void* real_realloc(void* block, std::size_t size) __asm__("__real_realloc");
void* real_aligned_alloc(std::size_t alignment, std::size_t size) __asm__("__real_aligned_alloc");

void* counted_malloc(std::size_t size) __asm__("__wrap_malloc");
void* counted_calloc(std::size_t count, std::size_t size) __asm__("__wrap_calloc");
void* counted_realloc(void* block, std::size_t size) __asm__("__wrap_realloc");
void* counted_aligned_alloc(std::size_t alignment, std::size_t size) __asm__("__wrap_aligned_alloc");

void* counted_malloc(std::size_t size) {
  ++blocks;
  return real_malloc(size);
}

void* counted_calloc(std::size_t count, std::size_t size) {
  ++blocks;
  return real_calloc(count, size);
}

void* counted_realloc(void* block, std::size_t size) {
  ++blocks;
  return real_realloc(block, size);
}

void* counted_aligned_alloc(std::size_t alignment, std::size_t size) {
  ++blocks;
  return real_aligned_alloc(alignment, size);
}
}

// The other forms of new and delete call these.
void* operator new(std::size_t size) { return taken(counted_malloc(size)); }

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return taken(counted_aligned_alloc(step, (size + step - 1) / step * step));
}

void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept { give_back(block); }
void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept { give_back(block); }
