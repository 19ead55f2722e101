#include "replay/export/table/npz_texts.h"

#include <algorithm>
#include <cstdint>

#include "replay/export/plan/little_bytes.h"

namespace tumble::replay {
namespace {

constexpr std::uint32_t kReplacement = 0xfffd;  // for bytes that are no UTF-8

/// The character that begins at `at`, which moves behind it.
std::uint32_t next_character(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(at++);
  if (first < 0x80) return first;
  const std::size_t more = first >= 0xf0 ? 3 : (first >= 0xe0 ? 2 : (first >= 0xc0 ? 1 : 0));
  if (more == 0 || at + more > text.size()) return kReplacement;
  std::uint32_t code = first & (0x3fU >> more);
  for (std::size_t i = 0; i < more; ++i) {
    if ((byte(at + i) & 0xc0U) != 0x80) return kReplacement;
    code = code << 6U | (byte(at + i) & 0x3fU);
  }
  at += more;
  return code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) ? code : kReplacement;
}

}  // namespace

Texts::Texts(const std::vector<std::string>& utf8) {
  std::vector<std::vector<std::uint32_t>> all;
  for (const std::string& text : utf8) {
    std::vector<std::uint32_t>& codes = all.emplace_back();
    for (std::size_t at = 0; at < text.size();) codes.push_back(next_character(text, at));
    length_ = std::max(length_, codes.size());
  }
  for (std::vector<std::uint32_t>& codes : all) {
    codes.resize(length_, 0);
    for (const std::uint32_t code : codes) append_little(code, 4, bytes_);
  }
}

}  // namespace tumble::replay
