#include "golden/suite/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string>
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

Status check_temporary_place(std::size_t bytes, std::size_t files) {
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
  for (std::size_t k = 0; k < files; ++k) {
    std::ofstream probe(folder.path() / std::to_string(k), std::ios::binary);
    probe << std::string(k == 0 ? bytes : 1, 'x') << std::flush;
    if (!probe.good()) return wrong();
  }
  return {};
}

}  // namespace tumble::golden
