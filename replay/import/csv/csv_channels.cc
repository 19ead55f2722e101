#include "replay/import/csv/csv_channels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "replay/arrays/pair_cell.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr const char* kWholeOfFloat =
    "a whole number that a float64 holds, as the column is one of floats; '# kinds: text' keeps every digit";

template <class Number>
bool is_whole(std::string_view cell) {
  Number value{};
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && stop == cell.data() + cell.size() && !cell.empty();
}

/// "-0", which no whole number holds.
bool is_minus_zero(std::string_view cell) {
  return cell.size() > 1 && cell.front() == '-' && cell.find_first_not_of('0', 1) == std::string_view::npos;
}

/// "knee (rad)" is a channel knee in rad.
void take_unit(std::string& name, std::string& unit) {
  const std::size_t at = name.rfind(" (");
  if (!name.ends_with(')') || at == std::string::npos || at == 0) return;
  unit = name.substr(at + 2, name.size() - at - 3);
  name.resize(at);
}

template <class Number>
std::optional<ChannelValue> number_in(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional<ChannelValue>(value) : std::nullopt;
}

/// A number without an exponent, from its digits and its exponent of ten as in "1.25e+19".
std::string padded(std::string_view shortest) {
  const std::size_t exponent = shortest.find('e');
  std::string digits(shortest.substr(0, exponent));
  std::erase(digits, '.');
  const std::size_t places =
      exponent == std::string_view::npos ? 0 : std::stoul(std::string(shortest.substr(exponent + 1)));
  if (digits.size() <= places) digits.append(places + 1 - digits.size(), '0');
  return digits;
}

/// Whether a cell that is written as a whole number has lost no digit as a float64: it has all digits of the float64,
/// or the shortest that name it, padded with zeros, as many languages write it.
bool keeps_digits(std::string_view cell, double value) {
  if (cell.starts_with('-')) cell.remove_prefix(1);
  if (cell.find_first_not_of("0123456789") != std::string_view::npos) return true;
  while (cell.size() > 1 && cell.front() == '0') cell.remove_prefix(1);
  std::array<char, 400> digits = {};
  char* const last = digits.data() + digits.size();
  const char* end = std::to_chars(digits.data(), last, std::fabs(value), std::chars_format::fixed, 0).ptr;
  if (std::string_view(digits.data(), end) == cell) return true;
  end = std::to_chars(digits.data(), last, std::fabs(value), std::chars_format::scientific).ptr;
  return padded({digits.data(), end}) == cell;
}

/// A value of a pair; none where the text is none of that kind.
std::optional<ChannelValue> value_in(std::string_view text, ChannelKind kind) {
  if (kind == ChannelKind::kText) return ChannelValue(unescaped_cell(text));
  if (kind == ChannelKind::kInt64) return number_in<std::int64_t>(text);
  if (kind == ChannelKind::kUint64) return number_in<std::uint64_t>(text);
  if (kind == ChannelKind::kFloat32 && !text.ends_with(')')) return number_in<float>(text);
  const std::optional<double> number = parse_exact(text);
  if (!number || !keeps_digits(text, *number)) return std::nullopt;
  return kind == ChannelKind::kFloat32 ? ChannelValue(static_cast<float>(*number)) : ChannelValue(*number);
}

}  // namespace

CsvChannels::CsvChannels(const CsvColumns& columns, const std::vector<ChannelKind>& kinds, bool single)
    : single_(single) {
  for (const CsvColumns::ChannelColumn& column : columns.channels) {
    columns_.emplace_back();
    columns_.back().column = column.column;
    columns_.back().name = column.name;
    take_unit(columns_.back().name, columns_.back().unit);
    columns_.back().scope = column.scope;
    if (columns_.size() <= kinds.size()) columns_.back().kind = kinds[columns_.size() - 1];
  }
  std::ranges::sort(columns_, {}, &Column::name);
  for (const Column& column : columns_)
    channels_.push_back({column.name, {ChannelKind::kFloat64, column.scope}, column.unit});
}

void CsvChannels::look(const CsvReader& table) {
  for (Column& column : columns_) {
    const std::string_view cell = table.cell(column.column);
    if (column.scope != ChannelScope::kPair) {
      column.text = column.text || (cell.empty() && !table.is_blank(column.column));
      look_at(cell, column);
      continue;
    }
    // A cell that is not written as pairs is an error of the second reading.
    for (const PairCell& pair : split_pair_cell(cell).value_or(std::vector<PairCell>())) look_at(pair.value, column);
  }
}

void CsvChannels::look_at(std::string_view cell, Column& column) {
  if (cell.empty() || column.text) return;
  if (is_minus_zero(cell)) {
    column.real = true;
    return;
  }
  const bool fits_signed = is_whole<std::int64_t>(cell), fits = is_whole<std::uint64_t>(cell);
  column.negative = column.negative || (fits_signed && cell.front() == '-');
  column.large = column.large || (fits && !fits_signed);
  if (fits_signed || fits) return;
  column.real = true;
  column.text = !parse_exact(cell).has_value();
}

ChannelKind CsvChannels::kind_of_cells(const Column& column) const {
  if (column.kind) return *column.kind;
  if (column.text) return ChannelKind::kText;
  if (column.real || (column.negative && column.large)) return single_ ? ChannelKind::kFloat32 : ChannelKind::kFloat64;
  return column.large ? ChannelKind::kUint64 : ChannelKind::kInt64;
}

std::vector<ChannelKind> CsvChannels::kinds() const {
  std::vector<ChannelKind> kinds;
  for (const Column& column : columns_) kinds.push_back(kind_of_cells(column));
  return kinds;
}

void CsvChannels::set_kinds(const std::vector<ChannelKind>& kinds) {
  for (std::size_t i = 0; i < std::min(kinds.size(), channels_.size()); ++i) channels_[i].type.kind = kinds[i];
}

void CsvChannels::begin_step() {
  for (Column& column : columns_) column.has_world = false;
}

Result<ChannelValue> CsvChannels::value_of(const CsvReader& table, const Column& column, ChannelKind kind) const {
  if (kind == ChannelKind::kText) return ChannelValue(std::string(table.cell(column.column)));
  if (kind == ChannelKind::kUint64) {
    const Result<std::uint64_t> value = table.whole(column.column);
    return value.ok() ? Result<ChannelValue>(ChannelValue(*value)) : value.error();
  }
  if (kind == ChannelKind::kInt64) {
    const std::string_view cell = table.cell(column.column);
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error == std::errc() && stop == cell.data() + cell.size()) return ChannelValue(value);
    return table.at(column.column, column.name + ": " + found_wanted(in_quotes(cell), "a whole number"));
  }
  if (kind == ChannelKind::kFloat32) {
    const Result<double> value = table.single(column.column);
    return value.ok() ? Result<ChannelValue>(ChannelValue(static_cast<float>(*value))) : value.error();
  }
  const Result<double> value = table.number(column.column);
  if (!value.ok()) return value.error();
  const std::string_view cell = table.cell(column.column);
  if (keeps_digits(cell, *value)) return ChannelValue(*value);
  return table.at(column.column, column.name + ": " + found_wanted(in_quotes(cell), kWholeOfFloat));
}

Status CsvChannels::take_pairs(const CsvReader& table, const Column& column, sim::BodyId body, std::size_t channel,
                               ChannelKind kind, StepValues& values) {
  const std::string_view cell = table.cell(column.column);
  const std::optional<std::vector<PairCell>> pairs = split_pair_cell(cell);
  if (!pairs) {
    return table.at(column.column, "pair." + column.name + ": " +
                                       found_wanted(in_quotes(cell),
                                                    "values of pairs of bodies by the number of the "
                                                    "other body, as in 7=0.25 9=0.5"));
  }
  for (const PairCell& pair : *pairs) {
    const std::optional<ChannelValue> value = value_in(pair.value, kind);
    if (!value) {
      const bool whole = kind == ChannelKind::kFloat64 && parse_exact(pair.value).has_value();
      const std::string wanted = whole ? std::string(kWholeOfFloat) : std::string("a ") + name_of(kind);
      return table.at(column.column, "pair." + column.name + ": " + found_wanted(in_quotes(pair.value), wanted));
    }
    const Status set = values.set(channel, *value, {body, pair.other});
    if (!set.ok()) return table.at(column.column, set.error().message);
  }
  return {};
}

Status CsvChannels::take(const CsvReader& table, sim::BodyId body, StepValues& values) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    const std::string_view cell = table.cell(column.column);
    if (table.is_blank(column.column)) continue;
    if (column.scope == ChannelScope::kPair) {
      if (Status ok = take_pairs(table, column, body, i, channels_[i].type.kind, values); !ok.ok()) return ok;
      continue;
    }
    if (column.scope == ChannelScope::kWorld && column.has_world) {
      if (cell == column.world) continue;
      return table.at(column.column, "world." + column.name + ": " +
                                         found_wanted(in_quotes(cell), in_quotes(column.world) +
                                                                           ", as in the rows before: a value of the "
                                                                           "world is one value a step"));
    }
    const Result<ChannelValue> value = value_of(table, column, channels_[i].type.kind);
    if (!value.ok()) return value.error();
    const bool world = column.scope == ChannelScope::kWorld;
    if (world) column.world = cell;
    column.has_world = world;
    const Status set = values.set(i, *value, world ? ChannelKey{} : ChannelKey{body, 0});
    if (!set.ok()) return table.at(column.column, set.error().message);
  }
  return {};
}

}  // namespace tumble::replay
