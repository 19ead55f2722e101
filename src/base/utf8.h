#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Characters of UTF-8 text that anybody may have written.
namespace tumble {

/// A character, and its length in bytes.
struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< 0: no valid character
};

/// Bytes of the character that begins with `first`; 0 if none does.
std::size_t utf8_length(char first);

/// The character that begins at text[at]. Longer forms than needed and surrogates are not valid.
Character utf8_at(std::string_view text, std::size_t at);

/// The text with U+FFFD in the place of each byte that belongs to no character.
std::string valid_text(std::string_view text);

/// Whether a reader sees what the character is: false for control characters but newline and tab, for characters that
/// turn the direction of writing, and for U+FFFE and U+FFFF, which are none.
bool is_shown_as_read(std::uint32_t code);

}  // namespace tumble
