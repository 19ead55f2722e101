#include "replay/export/export_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "replay/export/scene/gltf_writer.h"
#include "replay/export/table/csv_writer.h"
#include "replay/export/table/npz_writer.h"
#include "src/base/text.h"

#ifdef TUMBLE_MCAP
#include "replay/export/scene/mcap_writer.h"
#endif

namespace tumble::replay {
namespace {

#ifdef TUMBLE_MCAP
constexpr auto kMakeMcap = make_mcap_writer;
#else
constexpr std::unique_ptr<ExportWriter> (*kMakeMcap)(files::OutputFile&) = nullptr;
#endif

constexpr std::array kFormats = {
    ExportFormat{".csv", "table of comma-separated values", true, make_csv_writer},
    ExportFormat{".npz", "arrays for numpy", false, make_npz_writer},
    ExportFormat{".glb", "glTF 2.0", false, make_gltf_writer},
    ExportFormat{".mcap", "MCAP for Foxglove and Rerun", true, kMakeMcap},
};

}  // namespace

Result<const ExportFormat*> export_format(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string wanted;
  for (const ExportFormat& format : kFormats) {
    if (ending == format.ending && format.make != nullptr) return &format;
    if (ending == format.ending) {
      return bad_input(
          path + ": this build cannot write " + format.ending +
          ": it was built without libprotobuf; install libprotobuf-dev and protobuf-compiler and build again");
    }
    wanted += std::string(wanted.empty() ? "" : &format == &kFormats.back() ? " or " : ", ") + format.ending;
  }
  return bad_input(path + ": found the ending " + in_quotes(ending) + ", wanted " + wanted +
                   ": the ending names the format");
}

}  // namespace tumble::replay
