#include "tumble/sim/hash.h"

#include <algorithm>
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

XXH3_state_t* as_state(void* state) { return static_cast<XXH3_state_t*>(state); }

void update_plain(void* state, const void* bytes, std::size_t count) {
  XXH3_128bits_update(as_state(state), bytes, count);
}

HashUpdate fastest_update() {
#if defined(__x86_64__) || defined(__i386__)
  if (__builtin_cpu_supports("avx2") != 0 && hash_update_avx2() != nullptr) return hash_update_avx2();
#endif
  return update_plain;
}

void update(void* state, const void* bytes, std::size_t count) {
  static const HashUpdate kUpdate = fastest_update();
  kUpdate(state, bytes, count);
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

Hasher::Hasher() : state_(XXH3_createState()) { reset(); }
Hasher::~Hasher() { XXH3_freeState(as_state(state_)); }

void Hasher::reset() { XXH3_128bits_reset(as_state(state_)); }

template <class T>
void Hasher::add_column(std::span<const T> column) {
  if constexpr (std::endian::native == std::endian::little) {
    update(state_, column.data(), column.size_bytes());
  } else {
    for (const T& value : column) {
      std::array<std::byte, sizeof(T)> bytes;
      std::memcpy(bytes.data(), &value, sizeof(T));
      std::reverse(bytes.begin(), bytes.end());
      update(state_, bytes.data(), bytes.size());
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

Hash128 Hasher::digest() const { return from_xxh(XXH3_128bits_digest(as_state(state_))); }

Hash128 hash_bytes(std::span<const std::byte> bytes) { return from_xxh(XXH3_128bits(bytes.data(), bytes.size())); }

}  // namespace tumble
