#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

/// Reads an array as numpy.save() writes it.
/// Format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
namespace tumble::replay {

/// An array with a name: numbers, or texts of one length.
struct Array {
  enum class Kind : char { kFloat = 'f', kSigned = 'i', kUnsigned = 'u', kBool = 'b', kUnicode = 'U', kBytes = 'S' };
  std::string name;  ///< without ".npy"
  Kind kind = Kind::kFloat;
  std::size_t item_bytes = 8;
  std::vector<std::size_t> shape;
  bool fortran_order = false;
  bool big_endian = false;
  std::string data;

  [[nodiscard]] std::size_t size() const;  ///< the product of the shape; 1 for a scalar
  [[nodiscard]] bool is_number() const { return kind != Kind::kUnicode && kind != Kind::kBytes; }

  /// An element as a cell of a table, to the bit: "0.1", "-7", "nan(0x…)", a text. index: one number a dimension.
  [[nodiscard]] std::string cell(const std::vector<std::size_t>& index) const;
};

inline constexpr std::uint64_t kArrayBytesMax = std::uint64_t{1} << 32U;  ///< of all arrays of an archive

/// Reads one array. name: Array::name. Errors (kBadInput): another format, an array of objects or structs, bytes that
/// do not fit the shape.
Result<Array> read_npy(std::string_view bytes, const std::string& name);

}  // namespace tumble::replay
