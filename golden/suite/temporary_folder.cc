#include "golden/suite/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "src/base/text.h"
#include "src/files/short_lived_folder.h"

namespace tumble::golden {

TemporaryFolder::TemporaryFolder(const std::string& prefix, const std::filesystem::path& within) {
  std::error_code error;
  const std::filesystem::path place = within.empty() ? std::filesystem::temp_directory_path(error) : within;
  if (error) return;
  path_ = files::make_short_lived_folder(place.string(), prefix);
}

TemporaryFolder::~TemporaryFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  files::forget_short_lived_folder(path_.string());
}

Status check_temporary_place() {
  constexpr std::size_t kProbeBytes = 512;  // a full disk takes none
  constexpr const char* kRemedy = "; free some space, or set TMPDIR to a folder that can be written";
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  if (error) {
    const char* told = std::getenv("TMPDIR");
    return cannot_finish("TMPDIR: " +
                         found_wanted(in_quotes(told == nullptr ? "" : told), "a folder for temporary files"));
  }
  errno = 0;
  const TemporaryFolder folder("tumble-probe");
  const auto wrong = [&] {
    const std::string why = errno == 0 ? "" : ": " + std::generic_category().message(errno);
    return cannot_finish(place.string() + ": no temporary files can be written" + why + kRemedy);
  };
  if (folder.path().empty()) return wrong();
  std::ofstream probe(folder.path() / "probe", std::ios::binary);
  probe << std::string(kProbeBytes, 'x') << std::flush;
  return probe.good() ? Status() : wrong();
}

}  // namespace tumble::golden
