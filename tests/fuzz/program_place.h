#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "tools/arguments/command.h"

/// The program `tumble` in this process, with files of its own: commands as a person runs them, often.
namespace tumble::fuzz {

struct Outcome {
  std::string command;  ///< what was run, for messages
  tools::Exit exit = tools::Exit::kSame;
  std::string out;
  std::string err;
};

/// A folder that is gone with it; in memory, where TMPDIR says so.
class ProgramPlace {
 public:
  ProgramPlace();
  ~ProgramPlace();
  ProgramPlace(const ProgramPlace&) = delete;
  ProgramPlace& operator=(const ProgramPlace&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Whether an output was begun beside this file and neither finished nor removed.
  [[nodiscard]] bool has_part_of(const std::string& name) const;
  void write(const std::string& name, std::span<const std::byte> bytes) const;
  [[nodiscard]] std::vector<std::byte> read(const std::string& name) const;
  void remove(const std::string& name) const { std::filesystem::remove(path(name)); }

  /// Runs a command and catches what it prints. Aborts if it ended in a way that no command may.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const;

 private:
  std::filesystem::path folder_;
};

/// Aborts with the words, the command and what it printed, which libFuzzer takes for a finding.
void require(bool holds, const char* wanted, const Outcome& outcome);

/// Requires one of these exit statuses; a file that was refused must be named: `file` in what went to stderr.
void require_exit(const Outcome& outcome, std::initializer_list<tools::Exit> allowed, const std::string& file);

}  // namespace tumble::fuzz
