#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

namespace tumble {

/// Memory for `bytes` bytes, at least as aligned as asked. From 1 MB on it is whole pages of 2 MB, where the system has
/// them: a step walks through some MB of contacts in every phase, and the processor remembers the places of few pages.
/// Nothing but time depends on it. Throws std::bad_alloc like operator new.
void* allocate_large(std::size_t bytes, std::size_t alignment);
/// Gives back what allocate_large has given for these arguments.
void free_large(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

/// The allocator of LargeVector.
template <class T>
struct LargeAllocator {
  using value_type = T;

  LargeAllocator() = default;
  template <class Other>
  LargeAllocator(const LargeAllocator<Other>& /*other*/) {}  // NOLINT(google-explicit-constructor): vectors want it

  T* allocate(std::size_t n) {
    if (n > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_large(n * sizeof(T), alignof(T)));
  }
  void deallocate(T* memory, std::size_t n) noexcept { free_large(memory, n * sizeof(T), alignof(T)); }
  /// What a resize adds is left as the memory has it: else one worker would fill what all are about to write.
  template <class Item>
  void construct(Item* /*item*/) noexcept {
    static_assert(std::is_trivially_destructible_v<Item>, "is written without having been made");
  }

  friend bool operator==(const LargeAllocator& /*a*/, const LargeAllocator& /*b*/) { return true; }
};

/// A vector for what grows with the number of bodies or contacts and is walked through often. Whoever resizes it writes
/// the new items before anything reads them; emplace_back() wants a value.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

/// Gives a vector room for n items, none of which it keeps where it grows: it copies nothing then, gives its memory
/// back first, and gets an eighth more than asked for.
template <class T>
void reserve_anew(LargeVector<T>& items, std::size_t n) {
  if (n <= items.capacity()) return;
  items = LargeVector<T>();
  items.reserve(n + n / 8);
}

/// Likewise gives it n items, which will all be written.
template <class T>
void resize_anew(LargeVector<T>& items, std::size_t n) {
  reserve_anew(items, n);
  items.resize(n);
}

}  // namespace tumble
