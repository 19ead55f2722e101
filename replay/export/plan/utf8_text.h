#pragma once

#include <cstddef>
#include <string_view>

#include "src/base/utf8.h"

namespace tumble::replay {

/// Whether a text is UTF-8: an engine may log any bytes as a text, and most formats hold no others.
inline bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_at(text, at).length;
    if (length == 0) return false;
    at += length;
  }
  return true;
}

}  // namespace tumble::replay
