#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tumble::golden {

/// Text that HTML and XML can hold and that shows as it is read: bytes that are no UTF-8, control characters but
/// newline and tab, and characters that turn the direction of writing become U+FFFD.
std::string clean_text(std::string_view text);

/// A piece of HTML. Markup comes from literals of this program alone; every other text goes through text(), the one
/// place where text becomes HTML. A std::string does not convert, so that no text of a case can become markup.
class Html {
 public:
  /// A string literal, known when this program is compiled.
  class Markup {
   public:
    template <std::size_t N>
    consteval Markup(const char (&literal)[N]) : literal_(literal, N - 1) {}
    [[nodiscard]] std::string_view view() const { return literal_; }

   private:
    std::string_view literal_;
  };

  Html() = default;
  Html(Markup markup) : bytes_(markup.view()) {}

  Html& operator<<(Markup markup) {
    bytes_ += markup.view();
    return *this;
  }
  Html& operator<<(const Html& part) {
    bytes_ += part.bytes_;
    return *this;
  }

  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  friend Html text(std::string_view text);
  friend Html path(std::string_view path);
  friend Html script_of_this_program(std::string_view script);
  friend Html base64_text(std::string_view bytes);
  friend Html json_text(std::string_view json);

  std::string bytes_;
};

/// Text, for the inside of an element or of an attribute in double quotes.
Html text(std::string_view text);

/// A relative path, for href and src: every byte but letters, digits and "-_./" as %XX.
Html path(std::string_view path);

/// The page's own script or style sheet, which the build puts into this program.
Html script_of_this_program(std::string_view script);

/// Bytes in base 64: no character of it is special.
Html base64_text(std::string_view bytes);

/// JSON for the inside of <script type="application/json">: every '<' is escaped as JSON does, so that the element
/// cannot be ended from within.
Html json_text(std::string_view json);

}  // namespace tumble::golden
