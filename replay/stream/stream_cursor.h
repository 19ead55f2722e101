#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "replay/format/little_endian.h"

namespace tumble::replay {

/// Reads numbers and texts from a payload. A read beyond the end gives 0 and "", and ok() is false from then on.
class StreamCursor {
 public:
  explicit StreamCursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t at() const { return at_; }

  template <std::unsigned_integral T>
  T number() {
    const std::span<const std::byte> bytes = take(sizeof(T));
    return bytes.empty() ? T{0} : load<T>(bytes.data());
  }
  bool flag() { return number<std::uint8_t>() != 0; }
  double float64() { return double_of(number<std::uint64_t>()); }
  double float32() { return static_cast<double>(std::bit_cast<float>(number<std::uint32_t>())); }

  std::span<const std::byte> take(std::size_t size) {
    if (size > left()) {
      ok_ = false;
      at_ = bytes_.size();
      return {};
    }
    at_ += size;
    return bytes_.subspan(at_ - size, size);
  }
  std::string text(std::size_t size) {
    const std::span<const std::byte> bytes = take(size);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::string text() { return text(number<std::uint16_t>()); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace tumble::replay
