#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Text of messages and results: the only place where a number becomes text. Independent of the locale.
namespace tumble {

/// The shortest decimal that reads back to the same double, with an exponent where that is shorter: "1e-07".
std::string exact(double value);

/// As exact(), for a number that is finite; else a text with all 64 bits, for formats that have no such number:
/// "nan(0x7ff8000000000000)", "-inf(0xfff0000000000000)". parse_exact() reads both.
std::string exact_bits(double value);

/// A number as a table may write it: as std::from_chars reads it, with "+" before it or not, or as exact_bits() writes
/// it. None for any other text.
std::optional<double> parse_exact(std::string_view text);

/// As exact(), but without an exponent from 1e-5 to 1e9, as a person writes numbers: "0.00001".
std::string number_text(double value);

/// `digits` decimals: fixed(2.5, 3) is "2.500".
std::string fixed(double value, int digits);

/// `digits` significant digits, as printf's %g writes them; "0" for 0 of either sign.
std::string significant(double value, int digits);

/// Four significant digits with the unit: "1.234e-07 m", "45.3 J".
std::string rounded(double value, std::string_view unit);

/// Two lower-case hexadecimal digits for each byte.
std::string hex_digits(std::string_view bytes);

std::string bytes_text(std::uint64_t bytes);               ///< "812 bytes", "4.2 MB"
std::string count_text(std::uint64_t n, const char* one);  ///< "1 body", "222 bodies", "12 steps"
std::string seconds_text(double seconds);                  ///< "5.00 s", "12.0 ms", "30.0 µs"

/// "found X, wanted Y", a part of every error message about a value.
std::string found_wanted(std::string_view found, std::string_view wanted);

/// '?' for each control character, each byte that is no part of a character, and each character that turns the
/// direction of writing: text from a file must not drive the terminal.
std::string printable(std::string_view text);

/// printable() of at most the first 60 bytes, in whole characters, with "…" where there are more.
std::string shortened(std::string_view text);

/// shortened() in double quotes.
std::string in_quotes(std::string_view text);

/// A word for a command line that a person may copy: in single quotes where the shell needs them.
std::string shell_quoted(std::string_view word);

/// "a, b or c".
std::string list_text(const std::vector<std::string_view>& words);

/// The words with `between` between them: joined({"a", "b"}, ", ") is "a, b".
std::string joined(const std::vector<std::string>& words, std::string_view between);

/// The text with `with` in every place of `what`, which is not empty.
std::string replaced(std::string text, std::string_view what, std::string_view with);

/// The candidate that `word` is most likely a slip for; empty if none is near.
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& candidates);

/// Whether a name stands before another one in a list for people: runs of digits count as numbers, so that "qpos[2]"
/// stands before "qpos[10]". A strict order of all texts: names that are equal but for leading zeros keep that of
/// bytes.
bool natural_less(std::string_view a, std::string_view b);

/// The places of a list's entries in the order of natural_less() of their names. name: of an entry, a member or a
/// function.
template <class List, class Name>
std::vector<std::size_t> natural_order(const List& list, Name name) {
  std::vector<std::size_t> order(list.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, natural_less, [&](std::size_t i) -> std::string_view { return std::invoke(name, list[i]); });
  return order;
}

/// Columns that UTF-8 text takes on a terminal.
std::size_t columns(std::string_view text);

/// With spaces to at least `width` columns, on the right or, for numbers, on the left.
std::string padded(std::string_view text, std::size_t width);
std::string padded_left(std::string_view text, std::size_t width);

}  // namespace tumble
