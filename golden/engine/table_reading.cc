#include "golden/engine/table_reading.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>

#include "golden/suite/text_files.h"
#include "replay/arrays/array_table.h"
#include "replay/arrays/npz.h"
#include "replay/arrays/pair_cell.h"
#include "replay/import/csv/csv_format.h"
#include "replay/import/csv/table_map.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

/// The engine failed that wrote what nobody can read; what [engine.table] names wrongly is bad input.
Error failed(const Error& found) {
  return {found.kind == ErrorKind::kBadInput ? ErrorKind::kCannotFinish : found.kind, found.message};
}

Result<std::string> table_of_archive(const std::string& bytes, const TableReading& reading,
                                     const std::filesystem::path& folder) {
  const Result<std::vector<replay::Array>> arrays = replay::read_npz(bytes, "its archive");
  if (!arrays.ok()) return failed(arrays.error());
  replay::ArrayOptions how;
  how.scalar_last = reading.scalar_last;
  if (!reading.model.empty()) {
    const std::string model = (folder / reading.model).string();
    const Result<std::string> xml = read_text(model);
    if (!xml.ok()) return xml.error();
    Result<std::vector<replay::MujocoJoint>> joints = replay::read_mujoco_joints(*xml, model);
    if (!joints.ok()) return joints.error();
    how.joints = *std::move(joints);
  }
  Result<std::string> table = replay::table_of_arrays(*arrays, "its archive", how);
  return table.ok() ? std::move(table) : failed(table.error());
}

/// "up" of "# up: y" or "up: y".
std::string_view key_of(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
  return line.substr(0, line.find(':'));
}

/// The header lines of `reading`, then those of the table whose keys are others.
std::string head_of(std::string_view head, const TableReading& reading) {
  std::string lines;
  for (const std::string& line : reading.header) lines += "# " + line + '\n';
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n') + 1);
    const auto is_key = [&](const std::string& own) { return key_of(own) == key_of(line); };
    if (std::ranges::none_of(reading.header, is_key)) lines += line;
    head.remove_prefix(line.size());
  }
  return lines;
}

/// Columns that the format does not know get the names of channels. A table with another fault is left to its import.
void name_channels(replay::CsvReader& table) {
  const Result<replay::CsvColumns> columns = replay::find_columns(table, true);
  if (!columns.ok()) return;
  for (const auto& channel : columns->channels) {
    const std::string name = table.columns()[channel.column];
    if (name == channel.name) table.rename(name, "channel." + name);
  }
}

Result<std::string> changed(const std::string& table, const TableReading& reading,
                            const std::filesystem::path& folder) {
  replay::TableMap map;
  for (const std::string& entry : reading.map) {
    if (Status ok = replay::add_mapping(map, entry, "[engine.table] map"); !ok.ok()) return ok.error();
  }
  if (!reading.map_file.empty()) {
    if (Status ok = replay::read_map_file(map, (folder / reading.map_file).string()); !ok.ok()) return ok.error();
  }
  Result<replay::CsvReader> reader = replay::CsvReader::open(table, "its table");
  if (!reader.ok()) return failed(reader.error());
  if (Status ok = replay::rename_columns(map, *reader); !ok.ok()) return ok.error();
  if (reading.channels) name_channels(*reader);
  std::vector<std::string> columns = reader->columns();
  for (std::string& column : columns) {
    if (reader->escaped()) column = replay::text_cell(column);
  }
  return head_of(reader->head(), reading).append(joined(columns, ",")).append(1, '\n').append(reader->rows());
}

}  // namespace

Status rewrite_table(const std::string& path, const TableReading& reading, const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};  // log_of_session() says so
  std::ifstream file(path, std::ios::binary);
  char first[2] = {};
  file.read(first, sizeof first);
  const bool is_archive = file.gcount() == 2 && first[0] == 'P' && first[1] == 'K';
  const bool is_text = file.gcount() > 0 && static_cast<unsigned char>(first[0]) != 0x89;  // of logs and streams
  const bool has_names =
      reading.channels || !reading.map.empty() || !reading.map_file.empty() || !reading.header.empty();
  if (!is_archive && (!is_text || !has_names)) return {};
  Result<std::string> table = read_table(path);
  if (table.ok() && is_archive) table = table_of_archive(*table, reading, folder);
  if (table.ok() && has_names) table = changed(*table, reading, folder);
  return table.ok() ? write_file(path, std::string_view(*table)) : table.error();
}

}  // namespace tumble::golden
