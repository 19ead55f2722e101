#pragma once

#include <capnp/blob.h>

#include <bit>
#include <concepts>
#include <span>
#include <string>
#include <vector>

#include "replay/codec/byte_planes.h"
#include "replay/format/little_endian.h"
#include "src/base/check.h"
#include "tumble/sim/result.h"

/// Writes and reads columns of numbers in Data fields of Cap'n Proto. Included by codecs only.
namespace tumble::replay {

inline std::byte* bytes_of(capnp::Data::Builder data) { return reinterpret_cast<std::byte*>(data.begin()); }
inline const std::byte* bytes_of(capnp::Data::Reader data) { return reinterpret_cast<const std::byte*>(data.begin()); }

/// Errors (kDamaged): a column does not have exactly `count` elements of `size` bytes.
inline Status check_size(const char* column, capnp::Data::Reader data, std::size_t count, std::size_t size) {
  if (data.size() == count * size) return {};
  return damaged(std::string(column) + ": found " + std::to_string(data.size()) + " bytes, wanted " +
                 std::to_string(count) + " elements of " + std::to_string(size));
}

/// Writes elements one after the other.
template <std::unsigned_integral T>
void put_plain(std::span<const T> values, capnp::Data::Builder data) {
  SIM_CHECK(data.size() == values.size_bytes(), data.size(), values.size_bytes());
  for (std::size_t i = 0; i < values.size(); ++i) store(bytes_of(data) + i * sizeof(T), values[i]);
}

template <std::unsigned_integral T>
Status get_plain(const char* column, capnp::Data::Reader data, std::size_t count, std::vector<T>& values) {
  if (Status ok = check_size(column, data, count, sizeof(T)); !ok.ok()) return ok;
  values.resize(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = load<T>(bytes_of(data) + i * sizeof(T));
  return {};
}

template <std::unsigned_integral T>
void put_planes(std::span<const T> values, capnp::Data::Builder data) {
  SIM_CHECK(data.size() == values.size_bytes(), data.size(), values.size_bytes());
  split_planes(values, bytes_of(data));
}

template <std::unsigned_integral T>
Status get_planes(const char* column, capnp::Data::Reader data, std::size_t count, std::vector<T>& values) {
  if (Status ok = check_size(column, data, count, sizeof(T)); !ok.ok()) return ok;
  values.resize(count);
  join_planes(bytes_of(data), std::span<T>(values));
  return {};
}

/// Writes the difference of each element to the element before, in byte planes. Ascending columns become small numbers.
template <std::unsigned_integral T>
void put_differences(std::span<const T> values, capnp::Data::Builder data) {
  std::vector<T> differences(values.size());
  T before = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    differences[i] = static_cast<T>(values[i] - before);
    before = values[i];
  }
  put_planes(std::span<const T>(differences), data);
}

template <std::unsigned_integral T>
Status get_differences(const char* column, capnp::Data::Reader data, std::size_t count, std::vector<T>& values) {
  if (Status ok = get_planes(column, data, count, values); !ok.ok()) return ok;
  T before = 0;
  for (T& value : values) {
    value = static_cast<T>(value + before);
    before = value;
  }
  return {};
}

/// Copies doubles as bits, because some machines change a signalling NaN in a floating-point register.
inline std::vector<std::uint64_t> bits_of(std::span<const double> values) {
  std::vector<std::uint64_t> bits(values.size());
  if (!bits.empty()) std::memcpy(bits.data(), values.data(), values.size_bytes());
  return bits;
}

inline void doubles_of(std::span<const std::uint64_t> bits, std::vector<double>& values) {
  values.resize(bits.size());
  if (!bits.empty()) std::memcpy(values.data(), bits.data(), bits.size_bytes());
}

}  // namespace tumble::replay
