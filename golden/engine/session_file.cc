#include "golden/engine/session_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "golden/engine/table_reading.h"
#include "golden/suite/text_files.h"
#include "replay/import/csv/import_csv.h"
#include "replay/stream/import_stream.h"
#include "replay/stream/stream_end.h"
#include "replay/stream/stream_reader.h"
#include "replay/stream/stream_tail.h"
#include "src/base/text.h"
#include "tumble/replay/prelude.h"

namespace tumble::golden {
namespace {

enum class FileKind : std::uint8_t { kLog, kStream, kTable };

FileKind kind_of(const std::string& path) {
  std::array<char, 64> start = {};
  static_assert(start.size() >= replay::kMagicEnd && start.size() >= replay::kStreamMagic.size());
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  const auto found = std::as_bytes(std::span(start)).first(static_cast<std::size_t>(file.gcount()));
  if (replay::starts_like_log(found.first(std::min(found.size(), replay::kMagicEnd)))) return FileKind::kLog;
  const auto magic = found.first(std::min(found.size(), replay::kStreamMagic.size()));
  return replay::StreamReader::is_stream(magic) ? FileKind::kStream : FileKind::kTable;
}

/// Converts a recorder's stream. growing: the engine still writes to it, so that its end is none.
Status convert_stream(const std::string& path, const std::string& converted, bool growing, SessionLog& log) {
  Result<std::unique_ptr<replay::ByteSource>> source = replay::open_stream_source(path);
  if (!source.ok()) return source.error();
  const Result<replay::StreamReader> stream = replay::StreamReader::open(*std::move(source));
  if (!stream.ok()) return stream.error();
  const replay::StreamCondition& condition = stream->condition();
  if (condition.damage && !growing) return damaged("wrote a damaged stream: " + *condition.damage);
  const Result<replay::StreamImport> done =
      replay::import_stream(*stream, [&] { return replay::open_file_sink(converted); });
  if (!done.ok() && done.error().kind == ErrorKind::kBadInput) {
    return bad_input("wrote a stream that no log can hold: " + done.error().message);
  }
  if (!done.ok()) return done.error();
  if (!done->refused.empty()) log.refused = "wrote a stream with a step that no log can hold: " + done->refused;
  log.warnings = done->warnings;
  if (!condition.refusal.empty()) {
    log.unfinished = replay::cut_short(*stream);
  } else if (!condition.finished) {
    log.unfinished = "its stream ends without the last frame, after step " +
                     std::to_string(stream->steps().back().step) +
                     ": the engine did not close its recorder (tumble_rec_close)";
  }
  return {};
}

/// A table without its last step, whose rows may not all be there yet; empty where no step is left.
std::string without_last_step(const std::string& table) {
  const std::string_view text(table);
  std::size_t at = 0;
  while (text.substr(at).starts_with('#')) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return "";
    at = end + 1;
  }
  const std::size_t end = text.find('\n', at);
  if (end == std::string_view::npos) return "";
  const std::string_view names = text.substr(at, end - at);
  const auto cell = [](std::string_view line, std::size_t column) {
    for (; column > 0; --column) line.remove_prefix(std::min(line.size(), line.find(',') + 1));
    return line.substr(0, std::min(line.find_first_of(",\r\n"), line.size()));
  };
  std::size_t column = 0, columns = static_cast<std::size_t>(std::ranges::count(names, ',')) + 1;
  while (column < columns && cell(names, column) != "step" && cell(names, column) != "time") ++column;
  std::size_t stop = text.rfind('\n');
  if (column == columns || stop == end) return "";
  std::string_view last;  // the step of the last complete row
  for (std::size_t row_end = stop; row_end > end;) {
    const std::size_t begin = text.rfind('\n', row_end - 1) + 1;
    const std::string_view step = cell(text.substr(begin, row_end - begin), column);
    if (last.empty()) last = step;
    if (step != last) return table.substr(0, row_end + 1);
    row_end = begin - 1;
  }
  return "";
}

/// Whether a line "# key: …" stands before the names of the columns.
bool gives(std::string_view table, std::string_view key) {
  while (table.starts_with('#')) {
    std::string_view line = table.substr(0, table.find('\n'));
    table.remove_prefix(std::min(table.size(), line.size() + 1));
    line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
    if (line.starts_with(key) && line.substr(key.size()).starts_with(':')) return true;
  }
  return false;
}

/// Keys that the wanted log knows and the table does not give: an import that was told them by --header is repeated.
std::vector<std::string> settings_like(const replay::LogHeader& header, std::string_view table) {
  std::vector<std::string> settings;
  const auto add = [&](const std::string& key, const std::string& value) {
    if (!value.empty() && !gives(table, key)) settings.push_back(key + ": " + value);
  };
  if (!header.engine) return settings;
  add("engine", header.engine->name);
  add("precision", header.engine->precision_bits == replay::kBinary32Bits ? "float32" : "float64");
  const replay::EngineAxes axes = header.axes();
  add("up", std::string(1, "xyz"[axes.up]));
  add("handed", axes.left_handed ? "left" : "right");
  add("length", exact(axes.metres));
  return settings;
}

/// Converts a table.
Status convert_table(const std::string& table, const std::string& converted, replay::LogReader* like, SessionLog& log) {
  replay::ImportOptions how;
  how.warn = [&](const std::string& warning) { log.warnings.push_back(warning); };
  if (like != nullptr) {
    how.settings = settings_like(like->header(), table);
    Result<replay::SessionLike> known = replay::session_like(*like);
    if (!known.ok()) return known.error();
    how.like = *std::move(known);
  }
  const auto sink = [&] { return replay::open_file_sink(converted); };
  const Result<replay::LogSummary> summary = replay::import_csv(table, "its table", sink, how);
  if (summary.ok()) return {};
  return Error{summary.error().kind, "wrote a table that no log can hold: " + summary.error().message};
}

}  // namespace

const char* ending_of_session(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 2> start = {};
  file.read(start.data(), start.size());
  if (start == std::array{'P', 'K'}) return ".npz";
  const FileKind kind = kind_of(path);
  if (kind == FileKind::kTable) return ".csv";
  return kind == FileKind::kLog ? ".tumble" : ".tumblestream";
}

Result<SessionLog> log_of_session(const std::string& path, const std::string& converted, replay::LogReader* like) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return cannot_finish("wrote no log");
  if (!std::filesystem::is_regular_file(path, error)) return cannot_finish("wrote no file where the log should be");
  if (std::filesystem::file_size(path, error) == 0) return cannot_finish("wrote an empty log");
  const FileKind kind = kind_of(path);
  SessionLog log = {kind == FileKind::kLog ? path : converted, {}, "", ""};
  if (kind == FileKind::kLog) return log;
  Status done;
  if (kind == FileKind::kStream) {
    done = convert_stream(path, converted, false, log);
  } else {
    const Result<std::string> table = read_table(path);
    done = table.ok() ? convert_table(*table, converted, like, log) : table.error();
  }
  return done.ok() ? Result<SessionLog>(std::move(log)) : done.error();
}

std::optional<std::string> log_so_far(const std::string& path, const std::string& converted, replay::LogReader* like,
                                      const EngineProject& project) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) == 0) return {};
  const FileKind kind = kind_of(path);
  if (kind == FileKind::kLog) return path;
  SessionLog log;
  if (kind == FileKind::kStream) {
    return convert_stream(path, converted, true, log).ok() ? std::optional<std::string>(converted) : std::nullopt;
  }
  const std::string copy = converted + ".table";  // which is read as the whole one will be
  const Result<std::string> written = read_table(path);
  if (!written.ok() || !write_file(copy, std::string_view(*written)).ok()) return {};
  if (!rewrite_table(copy, project.table, project.folder).ok()) return {};
  const Result<std::string> copied = read_table(copy);
  const std::string table = copied.ok() ? without_last_step(*copied) : "";
  const bool is_done = !table.empty() && convert_table(table, converted, like, log).ok();
  return is_done ? std::optional<std::string>(converted) : std::nullopt;
}

}  // namespace tumble::golden
