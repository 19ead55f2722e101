#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "replay/export/plan/export_writer.h"
#include "replay/export/table/npz_archive.h"

namespace tumble::replay {

/// The values of channels as arrays. Texts become numbers, in the order in which they first appear, and one array of
/// all different texts at the end, because their lengths are not known before. Values of pairs are a row each, beside
/// arrays of their steps and bodies; look() counts them.
class NpzChannels {
 public:
  Status begin(const ExportPlan& plan, NpzArchive& archive);
  [[nodiscard]] bool has_pairs() const;
  void look(const ExportStep& step);
  /// Errors (kBadInput): more different texts than a table of them holds.
  Status add(const ExportStep& step, NpzArchive& archive);
  Status finish(NpzArchive& archive);
  [[nodiscard]] std::uint64_t lost_values() const { return lost_values_; }  ///< of bodies that are not in the step

 private:
  struct Column {
    std::size_t channel = 0;  // of Declared::channels
    ChannelType type;
    std::string name;  // "channel.knee"
    std::size_t item_bytes = 8;
    std::size_t values = 0, present = 0;           // arrays of the archive
    std::map<std::string, std::uint32_t> numbers;  // of texts
    std::size_t longest = 0;                       // bytes of a text
    std::uint64_t rows = 0;                        // of pairs
    std::array<std::size_t, 3> places = {};        // of pairs: arrays of steps and of both bodies
    [[nodiscard]] bool of_pairs() const { return type.scope == ChannelScope::kPair; }
  };
  void plan_pairs(NpzArchive& archive);
  Status add_pairs(Column& column, const ExportStep& step, NpzArchive& archive);
  [[nodiscard]] bool is_there(const ExportStep& step, sim::BodyId body) const;
  Status put_value(Column& column, const ChannelValues& values, std::size_t row, const std::string& of, char* to) const;

  const ExportPlan* plan_ = nullptr;
  std::vector<Column> columns_;
  std::string bytes_, flags_;
  bool pairs_planned_ = false;
  std::uint64_t lost_values_ = 0;
};

}  // namespace tumble::replay
