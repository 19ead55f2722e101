#include "tools/files/data_folder.h"

#include <system_error>

namespace tumble::tools {

std::filesystem::path data_folder() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  fs::path installed = program.parent_path().parent_path() / "share" / "tumble";
  if (!error && fs::is_directory(installed / "golden" / "cases", error)) return installed;
  return TUMBLE_SOURCE_DIR;
}

}  // namespace tumble::tools
