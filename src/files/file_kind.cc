#include "src/files/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <system_error>

#include "src/base/check.h"
#include "src/base/text.h"
#include "src/files/file_identity.h"

namespace tumble::files {
namespace {

using Bytes = std::string_view;

constexpr std::size_t kBytesRead = 1 << 16;  // a table may name the kinds of thousands of channels first

bool is_archive(Bytes start) { return start.starts_with("PK\x03\x04") || start.starts_with("PK\x05\x06"); }
bool is_gltf(Bytes start) { return start.starts_with("glTF"); }
bool is_mcap(Bytes start) { return start.starts_with("\x89MCAP0\r\n"); }
bool is_png(Bytes start) { return start.starts_with("\x89PNG\r\n\x1a\n"); }
bool is_mp4(Bytes start) { return start.size() > 4 && start.substr(4).starts_with("ftyp"); }
bool is_webm(Bytes start) { return start.starts_with("\x1a\x45\xdf\xa3"); }
bool is_page(Bytes start) { return start.starts_with(kPageBegins); }
bool is_probes(Bytes start) { return start.starts_with("TMBLPRB"); }
bool is_text(Bytes start) { return start.find('\0') == Bytes::npos; }
/// Every table of ours: perhaps settings, each a line "# key: value", then the names of its columns.
bool is_table(Bytes start) {
  if (!is_text(start)) return false;
  while (start.starts_with("# ")) start.remove_prefix(std::min(start.find('\n'), start.size() - 1) + 1);
  return start.starts_with("step,");
}

bool begins_with(Bytes start, std::string_view first) {
  const std::size_t at = start.find_first_not_of(" \t\r\n");
  return is_text(start) && at != Bytes::npos && first.find(start[at]) != std::string_view::npos;
}
bool is_json(Bytes start) { return begins_with(start, "{["); }
bool is_xml_with(Bytes start, std::string_view element) {
  return begins_with(start, "<") && start.find(element) != Bytes::npos;
}
bool is_svg(Bytes start) { return is_xml_with(start, "<svg"); }
bool is_junit(Bytes start) { return is_xml_with(start, "<testsuite"); }

struct Kind {
  FileKind kind;
  std::string_view ending, name;
  bool (*is)(Bytes);
};
constexpr std::array kKinds = {
    Kind{FileKind::kTable, ".csv", "table of Tumble", is_table},
    Kind{FileKind::kGltf, ".glb", "glTF file", is_gltf},
    Kind{FileKind::kPage, ".html", "page of Tumble", is_page},
    Kind{FileKind::kJson, ".json", "JSON", is_json},
    Kind{FileKind::kMcap, ".mcap", "MCAP file", is_mcap},
    Kind{FileKind::kMp4, ".mp4", "MP4 movie", is_mp4},
    Kind{FileKind::kArrays, ".npz", "archive of arrays", is_archive},
    Kind{FileKind::kPng, ".png", "PNG picture", is_png},
    Kind{FileKind::kProbes, "", "file of probes", is_probes},
    Kind{FileKind::kSvg, ".svg", "SVG", is_svg},
    Kind{FileKind::kWebm, ".webm", "WebM movie", is_webm},
    Kind{FileKind::kJunit, ".xml", "report for CI (JUnit XML)", is_junit},
};

}  // namespace

FileKind kind_by_name(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const found = std::ranges::find_if(
      kKinds, [&](const Kind& kind) { return !kind.ending.empty() && name.ends_with(kind.ending); });
  SIM_CHECK(found != kKinds.end());
  return found->kind;
}

Status replaces_its_kind(const std::string& option, const std::filesystem::path& path, FileKind kind) {
  const std::filesystem::path place = resolved(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(place, ignored)) return {};
  std::string start(kBytesRead, '\0');
  std::ifstream file(place, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  const Kind& wanted = *std::ranges::find(kKinds, kind, &Kind::kind);
  if (start.empty() || wanted.is(start)) return {};
  return bad_input(option + ": " + printable(path.string()) + ": exists and is no " + std::string(wanted.name) +
                   ", so no earlier output; name another file, or remove it first");
}

}  // namespace tumble::files
