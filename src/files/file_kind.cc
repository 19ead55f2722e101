#include "src/files/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

#include "src/base/text.h"
#include "src/files/file_identity.h"

namespace tumble::files {
namespace {

using Bytes = std::string_view;

constexpr std::size_t kBytesRead = 4096;

bool is_archive(Bytes start) { return start.starts_with("PK\x03\x04") || start.starts_with("PK\x05\x06"); }
bool is_gltf(Bytes start) { return start.starts_with("glTF"); }
bool is_mcap(Bytes start) { return start.starts_with("\x89MCAP0\r\n"); }
bool is_png(Bytes start) { return start.starts_with("\x89PNG\r\n\x1a\n"); }
bool is_mp4(Bytes start) { return start.size() > 4 && start.substr(4).starts_with("ftyp"); }
bool is_webm(Bytes start) { return start.starts_with("\x1a\x45\xdf\xa3"); }
bool is_page(Bytes start) { return start.starts_with(kPageBegins); }
bool is_text(Bytes start) { return start.find('\0') == Bytes::npos && !is_png(start) && !start.starts_with("%PDF"); }

bool begins_with(Bytes start, std::string_view first) {
  const std::size_t at = start.find_first_not_of(" \t\r\n");
  return is_text(start) && at != Bytes::npos && first.find(start[at]) != std::string_view::npos;
}
bool is_json(Bytes start) { return begins_with(start, "{["); }
bool is_xml(Bytes start) { return begins_with(start, "<"); }

struct Kind {
  std::string_view ending, name;
  bool (*is)(Bytes);
};
constexpr std::array kKinds = {
    Kind{".csv", "table as text", is_text},
    Kind{".glb", "glTF file", is_gltf},
    Kind{".html", "page of Tumble", is_page},
    Kind{".json", "JSON", is_json},
    Kind{".mcap", "MCAP file", is_mcap},
    Kind{".mp4", "MP4 movie", is_mp4},
    Kind{".npz", "archive of arrays", is_archive},
    Kind{".png", "PNG picture", is_png},
    Kind{".svg", "SVG", is_xml},
    Kind{".webm", "WebM movie", is_webm},
    Kind{".xml", "XML", is_xml},
};

}  // namespace

Status replaces_its_kind(const std::string& option, const std::filesystem::path& path) {
  const std::filesystem::path place = resolved(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(place, ignored)) return {};
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Kind& kind : kKinds) {
    if (kind.ending != ending) continue;
    std::string start(kBytesRead, '\0');
    std::ifstream file(place, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    if (start.empty() || kind.is(start)) return {};
    return bad_input(option + ": " + printable(path.string()) + ": exists and is no " + std::string(kind.name) +
                     ", so no earlier output; name another file, or remove it first");
  }
  return {};
}

}  // namespace tumble::files
