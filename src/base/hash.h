#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// 128 bits of XXH3, compared as a value.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  friend bool operator==(const Hash128&, const Hash128&) = default;
};

/// 32 lower-case hexadecimal digits, most significant first.
std::string to_string(const Hash128& hash);

/// XXH3-128 over a sequence of typed fields. Each field is hashed as its little-endian bytes, so a digest is the same
/// on every machine. Structs with padding are never hashed, since padding has no defined value. Doubles must be free of
/// −0.0, which the stepper turns into +0.0: mirrored states would otherwise compare equal and hash differently.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  /// Forgets everything added so far.
  void reset();

  void add(std::uint64_t value);
  void add(double value);
  void add(std::initializer_list<double> values);
  void add(std::span<const double> column);
  void add(std::span<const std::uint64_t> column);
  void add(std::span<const std::uint32_t> column);
  void add(std::span<const std::uint16_t> column);
  void add(std::span<const std::uint8_t> column);

  /// Adds rows of numbers without padding as the bytes in memory. A big-endian machine calls add_fields(row, *this)
  /// instead, which must add every field of the row in order.
  template <class Row, class AddFields>
  void add_rows(std::span<const Row> rows, AddFields add_fields) {
    if constexpr (std::endian::native == std::endian::little) {
      add(std::span(reinterpret_cast<const std::uint8_t*>(rows.data()), rows.size_bytes()));
    } else {
      for (const Row& row : rows) add_fields(row, *this);
    }
  }

  [[nodiscard]] Hash128 digest() const;

 private:
  template <class T>
  void add_column(std::span<const T> column);

  void* state_;  // XXH3_state_t, kept out of this header
};

/// A view of rows that consist of doubles alone, as one sequence of doubles.
template <class Row, class Allocator>
std::span<const double> doubles_of(const std::vector<Row, Allocator>& rows) {
  static_assert(sizeof(Row) % sizeof(double) == 0);
  return {reinterpret_cast<const double*>(rows.data()), rows.size() * (sizeof(Row) / sizeof(double))};
}

/// Of rows [begin, end) alone.
template <class Row, class Allocator>
std::span<const double> doubles_of(const std::vector<Row, Allocator>& rows, std::size_t begin, std::size_t end) {
  constexpr std::size_t kOfRow = sizeof(Row) / sizeof(double);
  return doubles_of(rows).subspan(begin * kOfRow, (end - begin) * kOfRow);
}

/// XXH3-128 of bytes as a file stores them. Never pass the memory of a struct, which may have padding.
Hash128 hash_bytes(std::span<const std::byte> bytes);

}  // namespace tumble
