// The commands info, replay and recover as the program runs them, over a file. The first byte of an input says which
// command, and whether the rest is a log or one laid open.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/fuzz/mend.h"
#include "tests/fuzz/target.h"
#include "tools/command.h"

namespace tumble::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder of this process's own, and what the commands print goes nowhere.
class Place {
 public:
  Place() : folder_(fs::temp_directory_path() / ("tumble-fuzz-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    std::cout.rdbuf(out_.rdbuf());
    std::cerr.rdbuf(out_.rdbuf());
  }
  ~Place() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::string path(const char* name) const { return folder_ / name; }
  void forget_output() { out_.str({}); }

 private:
  fs::path folder_;
  std::ostringstream out_;
};

void run(tools::Action (*declare)(CLI::App&), const std::vector<std::string>& arguments) {
  CLI::App app("fuzzed");
  const tools::Action action = declare(app);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  (void)action().ok();
}

}  // namespace
}  // namespace tumble::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tumble;
  static fuzz::Place place;
  constexpr std::size_t kCommands = 3;
  if (size == 0) return 0;
  const auto rest = fuzz::as_bytes(data + 1, size - 1);
  const bool is_open = data[0] / kCommands % 2 == 1;
  const fuzz::Bytes log = is_open ? fuzz::mended(rest) : fuzz::Bytes(rest.begin(), rest.end());
  const std::string path = place.path("input.tumble");
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(log.data()), static_cast<std::streamsize>(log.size()));
  place.forget_output();
  switch (data[0] % kCommands) {
    case 0:
      fuzz::run(tools::declare_info, {path, "--json"});
      break;
    case 1:
      fuzz::run(tools::declare_replay, {path});
      break;
    default:
      fuzz::run(tools::declare_recover, {path, "-o", place.path("output.tumble")});
      break;
  }
  return 0;
}
