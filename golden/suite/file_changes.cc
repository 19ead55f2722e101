#include "golden/suite/file_changes.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>

#include "golden/suite/text_files.h"

namespace tumble::golden {
namespace {

constexpr std::size_t kKeptBytesMax = 64 * 1024;  // of one file
constexpr std::string_view kFileMark = "file ";   // "file 12 scene.txt": twelve lines follow

struct KeptFile {
  std::string name;
  std::string hash;
  std::optional<std::vector<std::string>> lines;  // none: the text was not kept
};

/// Without their ends.
std::vector<std::string> plain_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<KeptFile> kept_files(std::string_view text) {
  std::vector<KeptFile> files;
  for (const std::string& line : plain_lines(hash_lines(text))) {
    const std::size_t equals = line.rfind(" = ");
    if (equals != std::string::npos) files.push_back({line.substr(0, equals), line.substr(equals + 3), std::nullopt});
  }
  const std::vector<std::string> rest = plain_lines(text.substr(hash_lines(text).size()));
  for (std::size_t i = 0; i < rest.size();) {
    const std::string& mark = rest[i++];
    if (!mark.starts_with(kFileMark)) continue;
    std::size_t count = 0;
    const char* const end = mark.data() + mark.size();
    const auto [at, error] = std::from_chars(mark.data() + kFileMark.size(), end, count);
    if (error != std::errc() || at == end || count > rest.size() - i) break;
    const auto file = std::ranges::find(files, std::string(at + 1, end), &KeptFile::name);
    const auto first = rest.begin() + static_cast<std::ptrdiff_t>(i);
    if (file != files.end()) file->lines.emplace(first, first + static_cast<std::ptrdiff_t>(count));
    i += count;
  }
  return files;
}

SceneChange first_change(const KeptFile& before, const KeptFile& after) {
  if (!before.lines || !after.lines) return {0, after.name, "", ""};
  const std::vector<std::string>&a = *before.lines, &b = *after.lines;
  const std::size_t k = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
  return {k + 1, after.name, k < a.size() ? a[k] : "", k < b.size() ? b[k] : ""};
}

}  // namespace

std::string text_to_keep(const std::string& name, std::string_view bytes) {
  if (bytes.size() > kKeptBytesMax || bytes.find('\0') != std::string_view::npos) return "";
  const std::vector<std::string> lines = plain_lines(bytes);
  std::string text = std::string(kFileMark) + std::to_string(lines.size()) + ' ' + name + '\n';
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

std::string_view hash_lines(std::string_view files) {
  const std::size_t end = files.find("\n\n");
  return end == std::string_view::npos ? files : files.substr(0, end + 1);
}

std::vector<SceneChange> file_changes(std::string_view before, std::string_view after) {
  const std::vector<KeptFile> old = kept_files(before), now = kept_files(after);
  std::vector<SceneChange> changes;
  for (const KeptFile& file : now) {
    const auto was = std::ranges::find(old, file.name, &KeptFile::name);
    if (was == old.end()) {
      changes.push_back({0, file.name, "", "a new file"});
    } else if (was->hash != file.hash) {
      changes.push_back(first_change(*was, file));
    }
  }
  for (const KeptFile& file : old) {
    if (std::ranges::find(now, file.name, &KeptFile::name) == now.end()) {
      changes.push_back({0, file.name, "a file no more", ""});
    }
  }
  return changes;
}

}  // namespace tumble::golden
