// In libFuzzer's place: runs a target over the files given, or all files of the folders given, as a test.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputs_of(int argc, char** argv) {
  std::vector<fs::path> paths;
  for (int i = 1; i < argc; ++i) {
    if (!fs::is_directory(argv[i])) {
      paths.emplace_back(argv[i]);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(argv[i])) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
  }
  std::ranges::sort(paths);
  return paths;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<fs::path> paths = inputs_of(argc, argv);
  for (const fs::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!file) {
      std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
      return 1;
    }
    std::printf("%s: %zu bytes\n", path.c_str(), content.size());
    std::fflush(stdout);
    test_one_input(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
  }
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%zu inputs, peak memory %.1f MB\n", paths.size(), static_cast<double>(usage.ru_maxrss) / 1024);
  return paths.empty() ? 1 : 0;
}
