// A digest depends on the bytes alone: not on the parts in which they come, nor on the instructions of the processor.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "src/base/hash_update.h"
#include "tumble/sim/hash.h"

namespace tumble {
namespace {

std::vector<std::uint64_t> random_words(std::size_t count) {
  std::mt19937_64 random(11);
  std::vector<std::uint64_t> words(count);
  for (std::uint64_t& word : words) word = random();
  return words;
}

/// Adds the words in parts of at most `longest` of them.
Hash128 digest_of_parts(std::span<const std::uint64_t> words, std::size_t longest, Hasher& hasher) {
  std::mt19937_64 random(longest);
  hasher.add(std::uint64_t{5});
  hasher.reset();  // forgets it
  while (!words.empty()) {
    const std::size_t count = std::min<std::size_t>(1 + random() % longest, words.size());
    if (count == 1) {
      hasher.add(words[0]);
    } else {
      hasher.add(words.first(count));
    }
    words = words.subspan(count);
  }
  return hasher.digest();
}

TEST(Hasher, PartsOfAnyLengthGiveTheDigestOfTheWhole) {
  const std::vector<std::uint64_t> words = random_words(6000);
  Hasher hasher;
  for (const std::size_t count : {0U, 1U, 3U, 31U, 32U, 33U, 511U, 512U, 513U, 1100U, 6000U}) {
    const std::span<const std::uint64_t> some = std::span(words).first(count);
    const Hash128 whole = hash_bytes(std::as_bytes(some));
    for (const std::size_t longest : {1U, 4U, 5U, 31U, 32U, 33U, 64U, 700U}) {
      EXPECT_EQ(digest_of_parts(some, longest, hasher), whole) << count << " words in parts of up to " << longest;
    }
    EXPECT_EQ(hasher.digest(), whole) << "a second time";
  }
}

TEST(Hasher, BytesThatFillNoWordCountToo) {
  const std::vector<std::uint8_t> bytes = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  Hasher hasher;
  hasher.add(std::span(bytes).first(3));
  hasher.add(std::span(bytes).subspan(3));
  EXPECT_EQ(hasher.digest(), hash_bytes(std::as_bytes(std::span(bytes))));
}

/// Through a null pointer, or on a processor without the instructions, there is nothing to test.
void expect_same_digests(HashUpdate update, bool supported) {
  if (update == nullptr || !supported) GTEST_SKIP() << "this machine or build lacks the instructions";
  const std::vector<std::uint64_t> words = random_words(4000);
  for (const std::size_t count : {1U, 33U, 600U, 4000U}) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(words).first(count));
    alignas(64) XXH3_state_t state;
    XXH3_INITSTATE(&state);
    XXH3_128bits_reset(&state);
    update(&state, bytes.data(), bytes.size());
    const XXH128_hash_t found = XXH3_128bits_digest(&state);
    EXPECT_EQ((Hash128{found.high64, found.low64}), hash_bytes(bytes)) << count;
  }
}

#if defined(__x86_64__) || defined(__i386__)
TEST(HashUpdate, Avx2GivesTheSameDigests) {
  expect_same_digests(hash_update_avx2(), __builtin_cpu_supports("avx2") != 0);
}

TEST(HashUpdate, Avx512GivesTheSameDigests) {
  expect_same_digests(hash_update_avx512(), __builtin_cpu_supports("avx512f") != 0);
}
#endif

}  // namespace
}  // namespace tumble
