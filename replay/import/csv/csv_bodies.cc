#include "replay/import/csv/csv_bodies.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

using sim::BoxDef;

constexpr double kNoPlace = -1;

Result<double> read_number(const CsvReader& table, std::size_t column) { return table.number(column); }

/// An edge. The length of a box loses its sign with the axes, so the sign is read here.
template <bool kSingle>
Result<double> read_edge(const CsvReader& table, std::size_t column) {
  Result<double> value = kSingle ? table.single(column) : table.number(column);
  if (!value.ok() || !(*value <= 0)) return value;
  return table.at(column,
                  table.columns()[column] + ": " + found_wanted(shortened(table.cell(column)), "an edge above 0"));
}

Result<double> read_flag(const CsvReader& table, std::size_t column) {
  const Result<bool> value = table.flag(column);
  if (!value.ok()) return value.error();
  return *value ? 1.0 : 0.0;
}

/// The number of a texture in sim::Texture.
Result<double> read_texture(const CsvReader& table, std::size_t column) {
  constexpr const auto& kNames = sim::kTextureNames;
  const auto* const found = std::ranges::find(kNames, table.cell(column));
  if (found != kNames.end()) return static_cast<double>(found - kNames.begin());
  return table.at(column,
                  "texture: " + found_wanted(in_quotes(table.cell(column)), list_text({kNames.begin(), kNames.end()})));
}

/// Row or column of a grid. An empty cell: the body is in none.
Result<double> read_place(const CsvReader& table, std::size_t column) {
  if (table.cell(column).empty()) return kNoPlace;
  const Result<std::uint64_t> value = table.whole(column);
  if (!value.ok()) return value.error();
  if (*value <= sim::kBodiesMax) return static_cast<double>(*value);
  return table.at(column, table.columns()[column] + ": " +
                              found_wanted(std::to_string(*value), "at most " + std::to_string(sim::kBodiesMax)));
}

// A body with a row or a column counts as part of a grid, because metrics know rows and columns of grids.
void set_row(BoxDef& box, double value) {
  if (value == kNoPlace) return;
  box.origin.row = static_cast<std::uint32_t>(value);
  box.origin.kind = sim::Origin::Kind::kGrid;
}

void set_column(BoxDef& box, double value) {
  if (value == kNoPlace) return;
  box.origin.column = static_cast<std::uint32_t>(value);
  box.origin.kind = sim::Origin::Kind::kGrid;
}

void set_friction(BoxDef& box, double value) {
  box.material.friction = value;
  box.material.friction_dynamic = value;
}

// A cell as an error shows it: an empty one is seen too.
std::string as_found(std::string_view cell) { return cell.empty() ? "\"\"" : shortened(cell); }

}  // namespace

CsvBodies::CsvBodies(const CsvColumns& columns, const CsvSettings& settings)
    : axes_(settings.axes), has_size_(columns.size[0] != CsvColumns::kNone) {
  const auto read_length =
      settings.engine.precision_bits == kBinary32Bits && !settings.wide_cells ? read_edge<true> : read_edge<false>;
  const std::initializer_list<Column> all = {
      {columns.size[0], read_length, [](BoxDef& box, double value) { box.size.x() = value; }},
      {columns.size[1], read_length, [](BoxDef& box, double value) { box.size.y() = value; }},
      {columns.size[2], read_length, [](BoxDef& box, double value) { box.size.z() = value; }},
      {columns.mass, read_number, [](BoxDef& box, double value) { box.mass = value; }},
      {columns.friction, read_number, set_friction},
      {columns.friction_dynamic, read_number, [](BoxDef& box, double value) { box.material.friction_dynamic = value; }},
      {columns.texture, read_texture,
       [](BoxDef& box, double value) { box.material.texture = static_cast<sim::Texture>(value); }},
      {columns.restitution, read_number, [](BoxDef& box, double value) { box.material.restitution = value; }},
      {columns.is_static, read_flag, [](BoxDef& box, double value) { box.is_static = value != 0; }},
      {columns.row, read_place, set_row},
      {columns.column, read_place, set_column}};
  for (const Column& column : all) {
    if (column.column != CsvColumns::kNone) columns_.push_back(column);
  }
}

Result<CsvBodies::FirstRow> CsvBodies::read_first(const CsvReader& table, BoxDef& box) const {
  FirstRow first;
  first.line = table.line();
  for (const Column& column : columns_) {
    const Result<double> value = column.read(table, column.column);
    if (!value.ok()) return value.error();
    column.set(box, *value);
    first.cells.push_back(table.cell(column.column));
    first.values.push_back(*value);
  }
  if (has_size_) box.size = axes_.extents(box.size);
  return first;
}

Status CsvBodies::check_later(const CsvReader& table, const FirstRow& first) const {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const std::size_t column = columns_[k].column;
    if (table.cell(column) == first.cells[k]) continue;
    const Result<double> value = columns_[k].read(table, column);
    if (!value.ok()) return value.error();
    if (*value == first.values[k]) continue;
    return table.at(column, table.columns()[column] + ": " +
                                found_wanted(as_found(table.cell(column)), as_found(first.cells[k])) + " as in line " +
                                std::to_string(first.line) + ": a body keeps the value that it first appears with");
  }
  return {};
}

}  // namespace tumble::replay
