#include "replay/arrays/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>

#include "replay/arrays/little_numbers.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kDimensionsMax = 4;

/// The text behind 'key': in the header of an array, up to the comma that ends it.
std::string_view value_of(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  std::size_t begin = header.find(':', at);
  if (begin == std::string_view::npos) return {};
  begin = header.find_first_not_of(" :", begin);
  return begin == std::string_view::npos ? std::string_view() : header.substr(begin);
}

bool read_type(std::string_view text, Array& array) {
  if (text.size() < 4 || (text[0] != '\'' && text[0] != '"')) return false;
  const char order = text[1], kind = text[2];
  std::size_t bytes = 0;
  const auto [stop, error] = std::from_chars(text.data() + 3, text.data() + text.size(), bytes);
  if (error != std::errc() || stop == text.data() + text.size() || *stop != text[0]) return false;
  array.big_endian = order == '>';
  array.kind = static_cast<Array::Kind>(kind);
  array.item_bytes = kind == 'U' ? 4 * bytes : bytes;
  const bool sized = bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
  if (kind == 'f') return bytes == 4 || bytes == 8;
  if (kind == 'i' || kind == 'u') return sized;
  if (kind == 'b') return bytes == 1;
  return (kind == 'U' || kind == 'S') && bytes < 10000;
}

bool read_shape(std::string_view text, Array& array) {
  if (!text.starts_with('(')) return false;
  text.remove_prefix(1);
  while (!text.empty() && text.front() != ')') {
    if (text.front() == ' ' || text.front() == ',') {
      text.remove_prefix(1);
      continue;
    }
    std::size_t length = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), length);
    if (error != std::errc() || array.shape.size() == kDimensionsMax) return false;
    array.shape.push_back(length);
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  }
  return !text.empty();
}

void append_utf8(std::uint32_t code, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xc0U | code >> 6U);
    add(0x80U | (code & 0x3fU));
  } else if (code < 0x10000) {
    add(0xe0U | code >> 12U);
    add(0x80U | (code >> 6U & 0x3fU));
    add(0x80U | (code & 0x3fU));
  } else {
    add(0xf0U | (code >> 18U & 7U));
    add(0x80U | (code >> 12U & 0x3fU));
    add(0x80U | (code >> 6U & 0x3fU));
    add(0x80U | (code & 0x3fU));
  }
}

}  // namespace

std::size_t Array::size() const {
  std::size_t count = 1;
  for (const std::size_t length : shape) count *= length;
  return count;
}

std::string Array::cell(const std::vector<std::size_t>& index) const {
  std::size_t at = 0;
  for (std::size_t d = 0; d < shape.size(); ++d) {
    const std::size_t k = fortran_order ? shape.size() - 1 - d : d;
    at = at * shape[k] + index[k];
  }
  std::string item = data.substr(at * item_bytes, item_bytes);
  const std::size_t unit = kind == Kind::kUnicode ? 4 : (kind == Kind::kBytes ? 1 : item_bytes);
  for (std::size_t begin = 0; big_endian && begin < item.size(); begin += unit) {
    std::reverse(item.begin() + static_cast<std::ptrdiff_t>(begin),
                 item.begin() + static_cast<std::ptrdiff_t>(begin + unit));
  }
  if (kind == Kind::kUnicode || kind == Kind::kBytes) {
    item.resize((item.find_last_not_of('\0') + unit) / unit * unit);  // zeros at the end fill the item, as in numpy
    if (kind == Kind::kBytes) return item;
    std::string text;
    for (std::size_t i = 0; i < item.size(); i += 4)
      append_utf8(static_cast<std::uint32_t>(number_at(item, i, 4)), text);
    return text;
  }
  const std::uint64_t bits = number_at(item, 0, item.size());
  if (kind == Kind::kFloat && item.size() == 8) return exact_bits(std::bit_cast<double>(bits));
  if (kind == Kind::kFloat) {  // the double of the same value, so that its digits give the float's bits
    return exact_bits(static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits))));
  }
  const unsigned shift = static_cast<unsigned>(64 - 8 * item.size());
  if (kind == Kind::kSigned) return std::to_string(static_cast<std::int64_t>(bits << shift) >> shift);
  return std::to_string(bits);
}

Result<Array> read_npy(std::string_view bytes, const std::string& name) {
  Array array;
  array.name = name;
  constexpr std::string_view kMagic = "\x93NUMPY";
  if (!bytes.starts_with(kMagic) || bytes.size() < 10 || bytes[6] < 1 || bytes[6] > 3) {
    return bad_input("is no array (.npy) of version 1 to 3");
  }
  const std::size_t prefix = bytes[6] == 1 ? 10 : 12;
  if (bytes.size() < prefix) return bad_input("the array is cut in its header");
  const std::uint64_t length = number_at(bytes, 8, prefix - 8);
  if (!holds(bytes, prefix, length)) return bad_input("the array is cut in its header");
  const std::string_view header = bytes.substr(prefix, length);
  const std::string_view type = value_of(header, "descr");
  if (!read_type(type, array)) {
    return bad_input("found elements of type " + in_quotes(type.substr(0, type.find(',', 1))) +
                     ", wanted floats of 4 or 8 bytes, integers, booleans or text");
  }
  array.fortran_order = value_of(header, "fortran_order").starts_with("True");
  if (!read_shape(value_of(header, "shape"), array)) {
    return bad_input("found no shape of at most " + std::to_string(kDimensionsMax) + " dimensions");
  }
  std::uint64_t wanted = array.item_bytes;
  for (const std::size_t n : array.shape) {
    if (n > kArrayBytesMax || (n > 0 && wanted > kArrayBytesMax / n)) return bad_input("found a shape beyond 4 GiB");
    wanted *= n;
  }
  array.data = bytes.substr(prefix + length);
  if (array.data.size() == wanted) return array;
  return bad_input("found " + std::to_string(array.data.size()) + " bytes of elements, wanted " +
                   std::to_string(wanted));
}

}  // namespace tumble::replay
