#include "golden/engine/session_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "replay/import/import_csv.h"
#include "replay/stream/import_stream.h"
#include "replay/stream/stream_reader.h"
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

/// Converts a recorder's stream.
Status convert_stream(const std::string& path, const std::string& converted, std::vector<std::string>& warnings) {
  Result<std::unique_ptr<replay::ByteSource>> source = replay::open_file_source(path);
  if (!source.ok()) return source.error();
  const Result<replay::StreamReader> stream = replay::StreamReader::open(*std::move(source));
  if (!stream.ok()) return stream.error();
  const Result<replay::StreamImport> done =
      replay::import_stream(*stream, [&] { return replay::open_file_sink(converted); });
  if (!done.ok()) return done.error();
  warnings.insert(warnings.end(), done->warnings.begin(), done->warnings.end());
  return {};
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

}  // namespace

Result<std::string> log_of_session(const std::string& path, const std::string& converted, replay::LogReader* like,
                                   std::vector<std::string>& warnings) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return cannot_finish("wrote no log");
  if (std::filesystem::file_size(path, error) == 0) return cannot_finish("wrote an empty log");
  const FileKind kind = kind_of(path);
  if (kind == FileKind::kLog) return path;
  if (kind == FileKind::kStream) {
    if (Status ok = convert_stream(path, converted, warnings); !ok.ok()) return ok.error();
    return converted;
  }
  std::ifstream file(path, std::ios::binary);
  const std::string table{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  replay::ImportOptions how;
  how.warn = [&](const std::string& warning) { warnings.push_back(warning); };
  if (like != nullptr) {
    how.settings = settings_like(like->header(), table);
    Result<replay::SessionLike> known = replay::session_like(*like);
    if (!known.ok()) return known.error();
    how.like = *std::move(known);
  }
  const auto sink = [&] { return replay::open_file_sink(converted); };
  if (const Result<replay::LogSummary> summary = replay::import_csv(table, "its table", sink, how); !summary.ok()) {
    return summary.error();
  }
  return converted;
}

}  // namespace tumble::golden
