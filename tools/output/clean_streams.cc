#include "tools/output/clean_streams.h"

#include <algorithm>

#include "src/base/utf8.h"

namespace tumble::tools {
namespace {

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 0x20 && byte < 0x7F) || c == '\n' || c == '\t';
}

}  // namespace

bool CleanBuffer::put_text(std::string_view text) {
  const auto size = static_cast<std::streamsize>(text.size());
  return target_->sputn(text.data(), size) == size;
}

bool CleanBuffer::end_character() {
  if (held_size_ == 0) return true;
  held_size_ = 0;
  return put_text("?");
}

bool CleanBuffer::put(char c) {
  const bool goes_on = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
  if (!goes_on && !end_character()) return false;
  held_[held_size_++] = c;
  const std::string_view held(held_.data(), held_size_);
  if (held.size() < utf8_length(held.front())) return true;
  held_size_ = 0;
  const auto [code, length] = utf8_at(held, 0);
  return put_text(length > 0 && is_shown_as_read(code) ? held : "?");
}

CleanBuffer::int_type CleanBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  return put(traits_type::to_char_type(c)) ? c : traits_type::eof();
}

std::streamsize CleanBuffer::xsputn(const char* text, std::streamsize size) {
  const std::string_view all(text, static_cast<std::size_t>(size));
  std::size_t at = 0;
  while (at < all.size()) {
    // Nearly all text is plain and goes on in one piece.
    const std::string_view rest = all.substr(at);
    const std::size_t plain =
        held_size_ == 0 ? static_cast<std::size_t>(std::ranges::find_if_not(rest, is_plain) - rest.begin()) : 0;
    if (plain > 0 && !put_text(all.substr(at, plain))) break;
    at += plain;
    if (at < all.size() && !put(all[at++])) break;
  }
  return static_cast<std::streamsize>(at);
}

}  // namespace tumble::tools
