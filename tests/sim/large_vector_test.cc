// Arrays of 1 MB and more lie in whole large pages, smaller ones where the heap puts them; both keep their values.
#include "src/base/large_vector.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>

namespace tumble {
namespace {

constexpr std::uintptr_t kLargePage = 1U << 21U;  // bytes

struct alignas(64) Row {
  double of[8] = {};
};

template <class T>
std::uintptr_t address_of(const LargeVector<T>& items) {
  return reinterpret_cast<std::uintptr_t>(items.data());
}

TEST(LargeVector, AnArrayOfAMegabyteBeginsWithALargePage) {
  const LargeVector<double> items((1U << 20U) / sizeof(double));
  EXPECT_EQ(address_of(items) % kLargePage, 0U);
}

TEST(LargeVector, SmallArraysAreAlignedAsTheirItemsAsk) {
  const LargeVector<Row> one(1), several(3);
  EXPECT_EQ(address_of(one) % alignof(Row), 0U);
  EXPECT_EQ(address_of(several) % alignof(Row), 0U);
}

// From the heap into large pages, and from there into more of them.
TEST(LargeVector, KeepsItsValuesWhileItGrows) {
  LargeVector<std::uint64_t> items;
  for (std::uint64_t k = 0; k < kLargePage; ++k) items.push_back(k * k);
  ASSERT_EQ(items.size(), kLargePage);
  std::uint64_t wrong = 0;
  for (std::uint64_t k = 0; k < kLargePage; ++k) wrong += items[k] != k * k ? 1U : 0U;
  EXPECT_EQ(wrong, 0U);
  const LargeVector<std::uint64_t> copy = items;
  EXPECT_EQ(copy, items);
}

// One worker would write them all, and each of the others its own part once more.
TEST(LargeVector, AResizeWritesNoItem) {
  LargeVector<std::uint64_t> items(3, 7);
  items.clear();
  items.resize(3);
  EXPECT_EQ(items[2], 7U);
}

TEST(LargeVector, ResizedAnewHasRoomForSomeMore) {
  LargeVector<std::uint64_t> items;
  for (const std::size_t size : {0U, 1U, 100U, 101U, 50U, 1U << 20U}) {
    resize_anew(items, size);
    EXPECT_EQ(items.size(), size);
  }
  resize_anew(items, items.capacity() + 1);
  EXPECT_GE(items.capacity(), items.size() + items.size() / 9);
  EXPECT_LE(items.capacity(), items.size() + items.size() / 8);
}

TEST(LargeVector, RefusesMoreThanAnAddressCanCount) {
  EXPECT_THROW(LargeAllocator<Row>().allocate(SIZE_MAX / sizeof(Row)), std::bad_array_new_length);
}

}  // namespace
}  // namespace tumble
