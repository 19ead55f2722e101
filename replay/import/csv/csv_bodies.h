#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "replay/import/csv/csv_format.h"
#include "replay/import/csv/csv_reader.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// Reads the columns that describe a body, not its state: size, mass, static, friction,
/// friction_dynamic, restitution, texture, row, column. The
/// row in which a body first appears gives the values. Every later row of the body must repeat them, so that no change
/// is passed over. Errors (kBadInput) name file, line and column.
class CsvBodies {
 public:
  /// The cells of the row in which a body first appeared.
  struct FirstRow {
    std::uint64_t line = 0;
    // One for each column read.
    std::vector<std::string_view> cells;  ///< in the text of the table
    std::vector<double> values;
  };

  CsvBodies(const CsvColumns& columns, const CsvSettings& settings);

  /// Reads the table's row into `box`. Values without a column stay. Errors: no number of the column's kind.
  Result<FirstRow> read_first(const CsvReader& table, sim::BoxDef& box) const;

  /// Errors: a cell of the table's row is no number of its kind, or has another value than the first row.
  [[nodiscard]] Status check_later(const CsvReader& table, const FirstRow& first) const;

 private:
  struct Column {
    std::size_t column;  // in the table
    Result<double> (*read)(const CsvReader& table, std::size_t column);
    void (*set)(sim::BoxDef& box, double value);
  };

  std::vector<Column> columns_;
  EngineAxes axes_;
  bool has_size_;
};

}  // namespace tumble::replay
