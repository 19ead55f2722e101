#include "tests/fuzz/program_place.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "tools/run_program.h"

namespace tumble::fuzz {
namespace {

namespace fs = std::filesystem;

/// Leads a stream into a text for as long as it lives.
class Caught {
 public:
  explicit Caught(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Caught() { stream_.rdbuf(before_); }
  Caught(const Caught&) = delete;
  Caught& operator=(const Caught&) = delete;
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::ostream& stream_;
  std::streambuf* before_;
};

}  // namespace

ProgramPlace::ProgramPlace() {
  std::string pattern = fs::temp_directory_path() / "tumble-fuzz-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) std::abort();
  folder_ = pattern;
}

ProgramPlace::~ProgramPlace() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

bool ProgramPlace::has_part_of(const std::string& name) const {
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().filename().string().starts_with(name + ".part")) return true;
  }
  return false;
}

void ProgramPlace::write(const std::string& name, std::span<const std::byte> bytes) const {
  std::ofstream file(path(name), std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) std::abort();  // a full disk would pass for an answer of the program
}

std::vector<std::byte> ProgramPlace::read(const std::string& name) const {
  std::ifstream file(path(name), std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

Outcome ProgramPlace::run(const std::vector<std::string>& arguments) const {
  Outcome outcome;
  for (const std::string& word : arguments) outcome.command += word + ' ';
  {
    const Caught out(std::cout);
    const Caught err(std::cerr);
    outcome.exit = tools::run_program(arguments);
    outcome.out = out.text();
    outcome.err = err.text();
  }
  // What run_program() says of an exception; the same words may come from the file.
  require(!outcome.err.starts_with("tumble: internal error"), "wanted no internal error", outcome);
  require(!outcome.err.starts_with("tumble: out of memory"), "wanted a limit before memory ends", outcome);
  return outcome;
}

void require(bool holds, const char* wanted, const Outcome& outcome) {
  if (holds) return;
  std::fprintf(stderr, "%s\ntumble %s\nexit status %d\nstdout: %s\nstderr: %s\n", wanted, outcome.command.c_str(),
               static_cast<int>(outcome.exit), outcome.out.c_str(), outcome.err.c_str());
  std::abort();
}

void require_exit(const Outcome& outcome, std::initializer_list<tools::Exit> allowed, const std::string& file) {
  require(std::ranges::count(allowed, outcome.exit) == 1, "wanted an exit status that the command documents", outcome);
  const bool refused = outcome.exit == tools::Exit::kBadInput || outcome.exit == tools::Exit::kDamaged;
  require(!refused || outcome.err.find(file) != std::string::npos, "wanted the file's name in the error", outcome);
}

}  // namespace tumble::fuzz
