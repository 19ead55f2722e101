#include "replay/import/csv_channels.h"

#include <algorithm>
#include <charconv>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

template <class Number>
bool is_whole(std::string_view cell) {
  Number value{};
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && stop == cell.data() + cell.size() && !cell.empty();
}

}  // namespace

CsvChannels::CsvChannels(const CsvColumns& columns, const std::vector<ChannelKind>& kinds, bool single)
    : single_(single) {
  for (const CsvColumns::ChannelColumn& column : columns.channels) {
    columns_.emplace_back();
    columns_.back().column = column.column;
    columns_.back().name = column.name;
    columns_.back().scope = column.scope;
    if (columns_.size() <= kinds.size()) columns_.back().kind = kinds[columns_.size() - 1];
  }
  std::ranges::sort(columns_, {}, &Column::name);
  for (const Column& column : columns_) channels_.push_back({column.name, {ChannelKind::kFloat64, column.scope}, ""});
}

void CsvChannels::look(const CsvReader& table) {
  for (Column& column : columns_) {
    const std::string_view cell = table.cell(column.column);
    if (cell.empty() || column.text) continue;
    const bool fits_signed = is_whole<std::int64_t>(cell), fits = is_whole<std::uint64_t>(cell);
    column.negative = column.negative || (fits_signed && cell.front() == '-');
    column.large = column.large || (fits && !fits_signed);
    if (fits_signed || fits) continue;
    column.real = true;
    column.text = !parse_exact(cell).has_value();
  }
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
  return value.ok() ? Result<ChannelValue>(ChannelValue(*value)) : value.error();
}

Status CsvChannels::take(const CsvReader& table, sim::BodyId body, StepValues& values) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    const std::string_view cell = table.cell(column.column);
    if (cell.empty()) continue;
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
