#include "golden/suite/text_files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "src/files/output_file.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBytesMax = std::size_t{256} << 20;

constexpr std::size_t kTableBytesMax = std::size_t{4} << 30;

template <class Content>
Result<Content> read(const fs::path& path, std::size_t bytes_max) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return bad_input(path.string() + ": is a folder, not a file");
  // A pipe is opened by whoever waits for its other end, for ever.
  if (fs::exists(status) && !fs::is_regular_file(status))
    return bad_input(path.string() + ": is no file, but a pipe or a device; remove it");
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return bad_input(path.string() + ": cannot be opened: " + std::strerror(errno));
  const auto size = static_cast<std::size_t>(file.tellg());
  if (size > bytes_max) return bad_input(path.string() + ": larger than any such file");
  Content content(size, typename Content::value_type{});
  file.seekg(0);
  file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(size));
  if (!file) return cannot_finish(path.string() + ": cannot be read: " + std::strerror(errno));
  return content;
}

}  // namespace

Result<std::string> read_text(const fs::path& path) { return read<std::string>(path, kBytesMax); }
Result<std::string> read_table(const fs::path& path) { return read<std::string>(path, kTableBytesMax); }
Result<std::vector<std::byte>> read_bytes(const fs::path& path) {
  return read<std::vector<std::byte>>(path, kBytesMax);
}

Status write_file(const fs::path& path, std::string_view content) {
  std::error_code error;
  fs::create_directories(path.parent_path().empty() ? "." : path.parent_path(), error);
  return files::write_whole_file(path.string(), content);
}

Status write_file(const fs::path& path, std::span<const std::byte> content) {
  return write_file(path, std::string_view(reinterpret_cast<const char*>(content.data()), content.size()));
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (!lines.back().empty() && lines.back().back() == '\r') lines.back().pop_back();
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

}  // namespace tumble::golden
