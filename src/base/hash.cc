#include "tumble/sim/hash.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

#include "src/base/hash_update.h"

// What GCC 12's own AVX-512 header leaves undefined on purpose is no mistake (its bug 105593; seen with -march=native).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tumble {
namespace {

constexpr std::size_t kWord = sizeof(std::uint64_t);

/// XXH3 takes 256 bytes at a time and is slow with fields of 8, which some phases have thousands of. These are gathered
/// first.
struct State {
  static constexpr std::size_t kSmall = 256;  // longer parts are passed on as they are

  XXH3_state_t xxh;
  std::size_t gathered = 0;
  std::array<std::byte, 16 * kSmall> bytes;
};

State& as_state(void* state) { return *static_cast<State*>(state); }

void update_plain(void* state, const void* bytes, std::size_t count) {
  XXH3_128bits_update(static_cast<XXH3_state_t*>(state), bytes, count);
}

HashUpdate fastest_update() {
#if defined(__x86_64__) || defined(__i386__)
  if (__builtin_cpu_supports("avx512f") != 0 && hash_update_avx512() != nullptr) return hash_update_avx512();
  if (__builtin_cpu_supports("avx2") != 0 && hash_update_avx2() != nullptr) return hash_update_avx2();
#endif
  return update_plain;
}

void pass_on(State& state, const void* bytes, std::size_t count) {
  static const HashUpdate kUpdate = fastest_update();
  kUpdate(&state.xxh, bytes, count);
}

void pass_on_gathered(State& state) {
  if (state.gathered > 0) pass_on(state, state.bytes.data(), state.gathered);
  state.gathered = 0;
}

void update(State& state, const void* bytes, std::size_t count) {
  if (count > State::kSmall) {
    pass_on_gathered(state);
    pass_on(state, bytes, count);
    return;
  }
  if (count == 0) return;
  if (state.gathered + count > state.bytes.size()) pass_on_gathered(state);
  std::byte* to = state.bytes.data() + state.gathered;
  state.gathered += count;
  if (count % kWord != 0 || count > 4 * kWord) {
    std::memcpy(to, bytes, count);
    return;
  }
  const auto* from = static_cast<const std::byte*>(bytes);
  for (std::size_t at = 0; at < count; at += kWord) std::memcpy(to + at, from + at, kWord);  // without a call
}

Hash128 from_xxh(XXH128_hash_t hash) { return {hash.high64, hash.low64}; }

}  // namespace

std::string to_string(const Hash128& hash) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text(32, '0');
  for (unsigned i = 0; i < 16; ++i) {
    text[15 - i] = kDigits[(hash.high >> (4 * i)) & 15];
    text[31 - i] = kDigits[(hash.low >> (4 * i)) & 15];
  }
  return text;
}

Hasher::Hasher() : state_(new State) {
  XXH3_INITSTATE(&as_state(state_).xxh);
  reset();
}
Hasher::~Hasher() { delete &as_state(state_); }

void Hasher::reset() {
  as_state(state_).gathered = 0;
  XXH3_128bits_reset(&as_state(state_).xxh);
}

template <class T>
void Hasher::add_column(std::span<const T> column) {
  if constexpr (std::endian::native == std::endian::little) {
    update(as_state(state_), column.data(), column.size_bytes());
  } else {
    for (const T& value : column) {
      std::array<std::byte, sizeof(T)> bytes;
      std::memcpy(bytes.data(), &value, sizeof(T));
      std::reverse(bytes.begin(), bytes.end());
      update(as_state(state_), bytes.data(), bytes.size());
    }
  }
}

void Hasher::add(std::uint64_t value) { add_column(std::span<const std::uint64_t>(&value, 1)); }
void Hasher::add(double value) { add_column(std::span<const double>(&value, 1)); }
void Hasher::add(std::initializer_list<double> values) { add_column(std::span(values.begin(), values.size())); }
void Hasher::add(std::span<const double> column) { add_column(column); }
void Hasher::add(std::span<const std::uint64_t> column) { add_column(column); }
void Hasher::add(std::span<const std::uint32_t> column) { add_column(column); }
void Hasher::add(std::span<const std::uint16_t> column) { add_column(column); }
void Hasher::add(std::span<const std::uint8_t> column) { add_column(column); }

Hash128 Hasher::digest() const {
  pass_on_gathered(as_state(state_));
  return from_xxh(XXH3_128bits_digest(&as_state(state_).xxh));
}

Hash128 hash_bytes(std::span<const std::byte> bytes) { return from_xxh(XXH3_128bits(bytes.data(), bytes.size())); }

}  // namespace tumble
