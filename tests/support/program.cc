#include "tests/support/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace tumble::test {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// In the child process; never returns.
[[noreturn]] void become(const std::string& folder, std::vector<std::string> words, const std::string& out,
                         const std::string& err) {
  const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const bool ready =
      dup2(out_file, STDOUT_FILENO) >= 0 && dup2(err_file, STDERR_FILENO) >= 0 && chdir(folder.c_str()) == 0;
  if (ready) execv(argv[0], argv.data());
  _exit(127);
}

Outcome outcome_of(const std::string& folder, const std::vector<std::string>& words) {
  const std::string out = folder + "/.out", err = folder + "/.err";
  const pid_t child = fork();
  if (child == 0) become(folder, words, out, err);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return {};
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

}  // namespace

const char* const kSmallScene = R"(title = "three boxes"
category = "session"
[world]
method = "thesis"
dt = 0.016666666666666666
steps = 40
[[box]]
position = [0.0, 0.0, 0.7]
[[box]]
position = [0.1, 0.2, 2.0]
[[input]]
step = 5
kind = "throw"
position = [0.0, -3.0, 1.0]
velocity = [0.0, 6.0, 0.0]
)";

Workshop::Workshop() {
  std::string pattern = testing::TempDir() + "tumble-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder " + pattern);
  folder_ = pattern;
}

Workshop::~Workshop() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void Workshop::write(const std::string& name, const std::string& content) const {
  std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
  std::ofstream(path(name), std::ios::binary) << content;
}

std::string Workshop::read(const std::string& name) const { return content_of(path(name)); }

std::vector<std::string> Workshop::names_with(const std::string& part) const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (name.find(part) != std::string::npos) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

Outcome Workshop::run(const std::vector<std::string>& arguments) const {
  std::vector<std::string> words = {TUMBLE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return outcome_of(folder_, words);
}

Outcome Workshop::run_after(const std::string& before, const std::vector<std::string>& arguments) const {
  std::vector<std::string> words = {"/bin/sh", "-c", before + "exec \"$0\" \"$@\"", TUMBLE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return outcome_of(folder_, words);
}

void Workshop::record_small(const std::string& name, const std::vector<std::string>& more) const {
  write(name + ".toml", kSmallScene);
  std::vector<std::string> arguments = {"record", name + ".toml", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run(arguments);
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
}

}  // namespace tumble::test
