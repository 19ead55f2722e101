#include "replay/import/csv/table_map.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

std::string without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
}

}  // namespace

Status add_mapping(TableMap& map, std::string_view text, const std::string& place) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string field = without_blanks(text.substr(0, equals));
  const std::string column = without_blanks(text.substr(std::min(equals + 1, text.size())));
  if (field.empty() || column.empty()) {
    return bad_input(place + ": found " + in_quotes(text) + ", wanted FIELD=COLUMN, as in position.x=px");
  }
  for (const TableMap::Entry& known : map.entries) {
    if (known.field != field && known.column != column) continue;
    return bad_input(place + ": found " + in_quotes(text) + ", but " + known.place + " maps " + known.field + " to " +
                     known.column + " already");
  }
  map.entries.push_back({field, column, place});
  return {};
}

Status read_map_file(TableMap& map, const std::string& path) {
  constexpr const char* kRemedy = "; name a file with lines FIELD = COLUMN";
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return bad_input(path + ": is a folder" + kRemedy);
  errno = 0;
  std::ifstream file(path);
  if (!file) return bad_input(path + ": cannot be opened: " + std::strerror(errno) + kRemedy);
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const std::string text = without_blanks(line);
    if (text.empty() || text.front() == '#') continue;
    if (Status ok = add_mapping(map, text, path + ':' + std::to_string(number)); !ok.ok()) return ok;
  }
  if (file.bad()) return cannot_finish(path + ": cannot be read to its end");
  return {};
}

Status rename_columns(const TableMap& map, CsvReader& table) {
  for (const TableMap::Entry& entry : map.entries) {
    if (table.rename(entry.column, entry.field)) continue;
    const std::vector<std::string>& names = table.columns();
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::string_view near = nearest_word(entry.column, candidates);
    return bad_input(entry.place + ": found no column " + in_quotes(entry.column) + " in " + table.name() +
                     (near.empty() ? "; it has " + std::to_string(names.size()) + " columns"
                                   : "; is " + std::string(near) + " meant?"));
  }
  return {};
}

}  // namespace tumble::replay
