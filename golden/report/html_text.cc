#include "golden/report/html_text.h"

#include <cstdint>

#include "src/base/utf8.h"

namespace tumble::golden {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

}  // namespace

std::string clean_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, length] = utf8_at(text, at);
    const bool is_good = length > 0 && is_shown_as_read(code);
    out += is_good ? text.substr(at, length) : kReplacement;
    at += length > 0 ? length : 1;
  }
  return out;
}

Html text(std::string_view text) {
  Html out;
  for (const char c : clean_text(text)) {
    switch (c) {
      case '&':
        out.bytes_ += "&amp;";
        break;
      case '<':
        out.bytes_ += "&lt;";
        break;
      case '>':
        out.bytes_ += "&gt;";
        break;
      case '"':
        out.bytes_ += "&quot;";
        break;
      case '\'':
        out.bytes_ += "&#39;";
        break;
      default:
        out.bytes_ += c;
    }
  }
  return out;
}

Html path(std::string_view path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  Html out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (kPlain.find(c) != std::string_view::npos) {
      out.bytes_ += c;
    } else {
      out.bytes_ += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return out;
}

Html script_of_this_program(std::string_view script) {
  Html out;
  out.bytes_ = script;
  return out;
}

Html base64_text(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Html out;
  std::string& text = out.bytes_;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) : 0U;
    };
    const std::uint32_t word = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (const std::uint32_t shift : {18U, 12U, 6U, 0U}) text += kDigits[word >> shift & 63U];
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  text.replace(text.size() - missing, missing, missing, '=');
  return out;
}

Html json_text(std::string_view json) {
  Html out;
  for (const char c : json) {
    if (c == '<') {
      out.bytes_ += "\\u003c";
    } else {
      out.bytes_ += c;
    }
  }
  return out;
}

}  // namespace tumble::golden
