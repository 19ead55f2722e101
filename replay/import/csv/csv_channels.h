#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "replay/format/step_values.h"
#include "replay/import/csv/csv_format.h"
#include "replay/import/csv/csv_reader.h"
#include "tumble/replay/channel.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The columns of a table that become channels. The first reading finds the kind of each column: whole numbers are
/// int64 (uint64 where one is larger), other numbers float64 (float32 in a table of floats), anything else is text. The
/// second reading takes the values. An empty cell is no value; a cell of a column of pairs has several ("7=0.25 9=0.5",
/// of the row's body with 7 and with 9). Errors (kBadInput) name file, line and column.
class CsvChannels {
 public:
  /// kinds: in the order of the columns in the table; empty: as the cells look.
  CsvChannels(const CsvColumns& columns, const std::vector<ChannelKind>& kinds, bool single);

  /// First reading: looks at the cells of the row.
  void look(const CsvReader& table);
  /// The kinds found, which the second reading takes.
  [[nodiscard]] std::vector<ChannelKind> kinds() const;

  /// Second reading. Errors: kinds of another table.
  void set_kinds(const std::vector<ChannelKind>& kinds);
  /// By ascending names.
  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }

  /// Takes the cells of a row of a body. Errors: a cell that is no number of its column's kind; a value of the world
  /// that is another one than in an earlier row of the step.
  Status take(const CsvReader& table, sim::BodyId body, StepValues& values);
  void begin_step();

 private:
  struct Column {
    std::size_t column = 0;  // in the table
    std::string name;
    std::string unit;
    ChannelScope scope = ChannelScope::kBody;
    std::optional<ChannelKind> kind = {};                              // given by the table
    bool text = false, real = false, negative = false, large = false;  // seen so far
    std::string world;                                                 // the cell of the step, of a world channel
    bool has_world = false;
  };
  static void look_at(std::string_view cell, Column& column);
  [[nodiscard]] ChannelKind kind_of_cells(const Column& column) const;
  static Status take_pairs(const CsvReader& table, const Column& column, sim::BodyId body, std::size_t channel,
                           ChannelKind kind, StepValues& values);
  [[nodiscard]] Result<ChannelValue> value_of(const CsvReader& table, const Column& column, ChannelKind kind) const;

  std::vector<Column> columns_;  // in the order of channels_
  std::vector<Channel> channels_;
  bool single_;
};

}  // namespace tumble::replay
