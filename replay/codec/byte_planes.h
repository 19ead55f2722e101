#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "replay/format/little_endian.h"

/// Columns as byte planes: byte 0 of all elements, then byte 1, and so on. The high bytes of small numbers become one
/// long run, which zstd compresses well.
namespace tumble::replay {

/// out: has values.size() · sizeof(T) bytes.
template <std::unsigned_integral T>
void split_planes(std::span<const T> values, std::byte* out) {
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t p = 0; p < sizeof(T); ++p) out[p * n + i] = static_cast<std::byte>(values[i] >> (8 * p));
  }
}

template <std::unsigned_integral T>
void join_planes(const std::byte* in, std::span<T> values) {
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i) {
    T value = 0;
    for (std::size_t p = 0; p < sizeof(T); ++p) {
      value = static_cast<T>(value | static_cast<T>(static_cast<T>(in[p * n + i]) << (8 * p)));
    }
    values[i] = value;
  }
}

/// Transposes the 8 × 8 matrix of bytes whose rows are the words. Applied twice, the matrix is unchanged.
inline void transpose(std::array<std::uint64_t, 8>& w) {
  const auto exchange = [&w](std::size_t i, std::size_t distance, unsigned shift, std::uint64_t low) {
    const std::uint64_t a = w[i];
    const std::uint64_t b = w[i + distance];
    w[i] = (a & low) | ((b & low) << shift);
    w[i + distance] = ((a >> shift) & low) | (b & ~low);
  };
  for (const std::size_t i : {0U, 1U, 2U, 3U}) exchange(i, 4, 32, 0x00000000FFFFFFFF);
  for (const std::size_t i : {0U, 1U, 4U, 5U}) exchange(i, 2, 16, 0x0000FFFF0000FFFF);
  for (const std::size_t i : {0U, 2U, 4U, 6U}) exchange(i, 1, 8, 0x00FF00FF00FF00FF);
}

/// Splits eight elements at a time, because all states of a chunk pass through here.
template <>
inline void split_planes<std::uint64_t>(std::span<const std::uint64_t> values, std::byte* out) {
  const std::size_t n = values.size();
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    std::array<std::uint64_t, 8> block;
    for (std::size_t k = 0; k < 8; ++k) block[k] = values[i + k];
    transpose(block);
    for (std::size_t p = 0; p < 8; ++p) store(out + p * n + i, block[p]);
  }
  for (; i < n; ++i) {
    for (std::size_t p = 0; p < 8; ++p) out[p * n + i] = static_cast<std::byte>(values[i] >> (8 * p));
  }
}

template <>
inline void join_planes<std::uint64_t>(const std::byte* in, std::span<std::uint64_t> values) {
  const std::size_t n = values.size();
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    std::array<std::uint64_t, 8> block;
    for (std::size_t p = 0; p < 8; ++p) block[p] = load<std::uint64_t>(in + p * n + i);
    transpose(block);
    for (std::size_t k = 0; k < 8; ++k) values[i + k] = block[k];
  }
  for (; i < n; ++i) {
    values[i] = 0;
    for (std::size_t p = 0; p < 8; ++p) values[i] |= static_cast<std::uint64_t>(in[p * n + i]) << (8 * p);
  }
}

}  // namespace tumble::replay
