#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "replay/export/plan/export_writer.h"
#include "replay/export/table/npz_archive.h"

namespace tumble::replay {

/// The values of channels as arrays. Texts become numbers, in the order in which they first appear, and one array of
/// all different texts at the end, because their lengths are not known before.
class NpzChannels {
 public:
  void begin(const ExportPlan& plan, NpzArchive& archive);
  /// Errors (kBadInput): more different texts than a table of them holds.
  Status add(const ExportStep& step, NpzArchive& archive);
  Status finish(NpzArchive& archive);

 private:
  struct Column {
    std::size_t channel = 0;  // of Declared::channels
    ChannelType type;
    std::string name;  // "channel.knee"
    std::size_t item_bytes = 8;
    std::size_t values = 0, present = 0;           // arrays of the archive
    std::map<std::string, std::uint32_t> numbers;  // of texts
    std::size_t longest = 0;                       // bytes of a text
  };
  Status put_value(Column& column, const ChannelValues& values, std::size_t row, const std::string& of, char* to) const;

  const ExportPlan* plan_ = nullptr;
  std::vector<Column> columns_;
  std::string bytes_, flags_;
};

}  // namespace tumble::replay
