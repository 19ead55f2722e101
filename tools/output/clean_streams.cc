#include "tools/output/clean_streams.h"

#include <algorithm>

namespace tumble::tools {
namespace {

constexpr unsigned char kC1Lead = 0xC2;         // of U+0080 to U+00BF
constexpr unsigned char kDirectionLead = 0xE2;  // of U+2000 to U+2FFF

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 0x20 && byte < 0x7F) || c == '\n' || c == '\t';
}

bool is_continuation(unsigned char c) { return c >= 0x80 && c <= 0xBF; }

/// Whether the last byte of a held character makes a control character or one that turns the direction of writing.
bool is_harmful(std::string_view held, unsigned char last) {
  if (held.size() == 1) return static_cast<unsigned char>(held[0]) == kC1Lead && last <= 0x9F;
  const auto middle = static_cast<unsigned char>(held[1]);
  if (middle == 0x80) return last == 0x8E || last == 0x8F || (last >= 0xAA && last <= 0xAE);
  return last >= 0xA6 && last <= 0xA9;
}

}  // namespace

bool CleanBuffer::put(char c) { return target_->sputc(c) != traits_type::eof(); }

bool CleanBuffer::put_text(std::string_view text) {
  const auto size = static_cast<std::streamsize>(text.size());
  return target_->sputn(text.data(), size) == size;
}

bool CleanBuffer::release() {
  const std::size_t size = held_size_;
  held_size_ = 0;
  return size == 0 || put_text({held_.data(), size});
}

bool CleanBuffer::put_character(unsigned char c) {
  if (is_continuation(c) && rest_ > 0) {
    --rest_;
    if (held_size_ == 0) return put(static_cast<char>(c));
    if (rest_ > 0) {  // the middle of three bytes
      if (c == 0x80 || c == 0x81) {
        held_[held_size_++] = static_cast<char>(c);
        return true;
      }
      return release() && put(static_cast<char>(c));
    }
    if (!is_harmful({held_.data(), held_size_}, c)) return release() && put(static_cast<char>(c));
    held_size_ = 0;
    return put('?');
  }
  rest_ = 0;
  if (!release()) return false;
  if (is_plain(static_cast<char>(c))) return put(static_cast<char>(c));
  if (c < 0xC2 || c > 0xF4) return put('?');
  rest_ = c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : 1;
  if (c != kC1Lead && c != kDirectionLead) return put(static_cast<char>(c));
  held_[held_size_++] = static_cast<char>(c);
  return true;
}

CleanBuffer::int_type CleanBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  return put_character(static_cast<unsigned char>(traits_type::to_char_type(c))) ? c : traits_type::eof();
}

std::streamsize CleanBuffer::xsputn(const char* text, std::streamsize size) {
  const std::string_view all(text, static_cast<std::size_t>(size));
  std::size_t at = 0;
  while (at < all.size()) {
    // Nearly all text is plain and goes on in one piece.
    const bool is_between = held_size_ == 0 && rest_ == 0;
    const std::string_view rest = all.substr(at);
    const std::size_t plain =
        is_between ? static_cast<std::size_t>(std::ranges::find_if_not(rest, is_plain) - rest.begin()) : 0;
    if (plain > 0 && !put_text(all.substr(at, plain))) break;
    at += plain;
    if (at < all.size() && !put_character(static_cast<unsigned char>(all[at++]))) break;
  }
  return static_cast<std::streamsize>(at);
}

}  // namespace tumble::tools
