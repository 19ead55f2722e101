#pragma once

#include <bit>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "replay/export/table/npz_archive.h"

namespace tumble::replay {

/// The eight little-endian bytes of a number.
inline void put_little(std::uint64_t value, char* to) {
  if constexpr (std::endian::native == std::endian::big) value = __builtin_bswap64(value);
  std::memcpy(to, &value, sizeof(value));
}

/// Texts as numpy holds them: of one length, four bytes a character, filled up with zeros.
class Texts {
 public:
  explicit Texts(const std::vector<std::string>& utf8);
  [[nodiscard]] ItemType type() const { return {"<U" + std::to_string(length_), 4 * length_}; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::size_t length_ = 1;  // characters; numpy has no text of length 0 that others read
  std::string bytes_;
};

}  // namespace tumble::replay
