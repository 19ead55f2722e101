#include "tools/files/helper_program.h"

#include <filesystem>

namespace tumble::tools {

std::string helper_program(const std::string& name) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const std::filesystem::path helper = self.parent_path() / name;
  return std::filesystem::is_regular_file(helper, error) ? helper.string() : std::string();
}

}  // namespace tumble::tools
