// How much memory the program takes at most for files that mean it harm: those of hostile_files.h and any given.
// Usage: hostile_memory PROGRAM LIMIT_MB [FILE|FOLDER...]
// Runs info, replay, recover and measure (import of .csv, record of .toml) on each and prints the largest peaks.
// Exit status: 0 all below the limit, 1 one above it or ended by a signal, 2 bad usage.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/trial/hostile_files.h"

namespace tumble::trial {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShown = 8;
constexpr rlim_t kSeconds = 60;  // of the processor, for a run

struct Peak {
  long kilobytes = 0;
  bool ended = true;  ///< by itself
  std::string what;
};

[[noreturn]] void become(std::vector<std::string> words) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const rlimit seconds = {kSeconds, kSeconds};
  setrlimit(RLIMIT_CPU, &seconds);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

/// This process is small, so what a child had of it before it became the program does not count.
Peak peak_of(const std::vector<std::string>& words) {
  Peak peak;
  for (const std::string& word : words) peak.what += word + ' ';
  const pid_t child = fork();
  if (child == 0) become(words);
  int status = 0;
  rusage usage = {};
  peak.ended = child > 0 && wait4(child, &status, 0, &usage) == child && WIFEXITED(status) && WEXITSTATUS(status) <= 4;
  peak.kilobytes = usage.ru_maxrss;
  return peak;
}

/// Made in a process of its own, because making them takes more memory than reading them may.
void make_files(const std::string& folder) {
  const pid_t child = fork();
  if (child == 0) _exit(make_hostile_files(folder).ok() ? 0 : 1);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
    std::fprintf(stderr, "hostile_memory: %s: the files cannot be made\n", folder.c_str());
    std::exit(1);
  }
}

std::vector<std::vector<std::string>> commands_for(const std::string& program, const fs::path& file,
                                                   const std::string& folder) {
  const std::string output = folder + "/output.tumble";
  const std::string input = file.string();
  if (file.extension() == ".toml") return {{program, "record", input, "-o", output, "--steps", "1"}};
  if (file.extension() == ".csv") return {{program, "import", input, "-o", output}};
  return {{program, "info", input, "--json"},
          {program, "replay", input, "--brief"},
          {program, "measure", input},
          {program, "recover", input, "-o", output},
          {program, "replay", output, "--brief"}};
}

std::vector<fs::path> files_of(const std::vector<std::string>& places) {
  std::vector<fs::path> files;
  for (const std::string& place : places) {
    if (!fs::is_directory(place)) {
      files.emplace_back(place);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(place)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

int report(std::vector<Peak> peaks, long limit_mb, std::size_t files) {
  std::ranges::sort(peaks, std::greater(), &Peak::kilobytes);
  for (std::size_t i = 0; i < std::min(kShown, peaks.size()); ++i) {
    std::printf("%7.1f MB  %s\n", static_cast<double>(peaks[i].kilobytes) / 1024, peaks[i].what.c_str());
  }
  std::printf("%zu files, %zu runs\n", files, peaks.size());
  int bad = 0;
  for (const Peak& peak : peaks) {
    if (peak.ended && peak.kilobytes <= limit_mb * 1024) continue;
    ++bad;
    std::fprintf(stderr, "hostile_memory: %s%s\n", peak.what.c_str(),
                 peak.ended ? ": found more memory than the limit" : ": did not end by itself");
  }
  return bad == 0 ? 0 : 1;
}

int run(const std::string& program, long limit_mb, std::vector<std::string> places) {
  std::string folder = fs::temp_directory_path() / "tumble-hostile-XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) return 1;
  fs::create_directory(folder + "/made");
  make_files(folder + "/made");
  places.push_back(folder + "/made");
  const std::vector<fs::path> files = files_of(places);
  std::vector<Peak> peaks;
  for (const fs::path& file : files) {
    for (const auto& words : commands_for(program, file, folder)) {
      peaks.push_back(peak_of(words));
      peaks.back().what += "(" + file.filename().string() + ", " + std::to_string(fs::file_size(file)) + " bytes)";
    }
    fs::remove(folder + "/output.tumble");
  }
  fs::remove_all(folder);
  return report(std::move(peaks), limit_mb, files.size());
}

}  // namespace
}  // namespace tumble::trial

int main(int argc, char** argv) {
  const long limit_mb = argc < 3 ? 0 : std::strtol(argv[2], nullptr, 10);
  if (limit_mb <= 0) {
    std::fprintf(stderr, "usage: hostile_memory PROGRAM LIMIT_MB [FILE|FOLDER...]\n");
    return 2;
  }
  return tumble::trial::run(argv[1], limit_mb, {argv + 3, argv + argc});
}
