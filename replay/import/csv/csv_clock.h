#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "replay/import/csv/csv_format.h"
#include "replay/import/csv/csv_reader.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Reads the columns step, time and dt of a table. Says where a step begins and how long each step takes. Errors
/// (kBadInput) name file, line and column.
class CsvClock {
 public:
  /// dt: s, of one step of the engine; none: the column dt (s, since the step before), else the differences of the
  /// column time.
  CsvClock(const CsvColumns& columns, std::optional<double> dt)
      : step_column_(columns.step), time_column_(columns.time), dt_column_(columns.dt), dt_(dt) {}

  /// Reads the cells of the table's row. Errors: no number, a time that is infinite or NaN, another time than the first
  /// row of the same step has.
  Status read_row(const CsvReader& table);

  /// Whether the row belongs to the step that began last.
  [[nodiscard]] bool in_step() const { return steps_ > 0 && row_key_ == key_; }

  /// Begins a step with the row. Returns its dt, 0 for the first step. Errors: the step does not follow the one before;
  /// its time contradicts dt.
  Result<double> begin_step(const CsvReader& table);

 private:
  static constexpr std::size_t kNone = CsvColumns::kNone;
  void note_digits(std::string_view cell);
  [[nodiscard]] double last_place() const;
  [[nodiscard]] Status check_time(const CsvReader& table, double time_before, double dt) const;

  std::size_t step_column_, time_column_, dt_column_;
  std::optional<double> dt_;
  double row_key_ = 0, row_time_ = 0;  // of the row; the key is the step number, or the time without such a column
  double key_ = 0, time_ = 0;          // of the step that began last
  double start_ = 0;                   // s, time of the first step
  double stride_ = 1;                  // between the keys of two steps
  std::uint64_t steps_ = 0;            // begun
  std::uint64_t line_ = 0;             // of the first row of the step
  int decimals_ = 0;                   // behind the point, and all digits, in any time read so far
  int digits_ = 0;
};

}  // namespace tumble::replay
