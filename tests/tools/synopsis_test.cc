// The synopsis of docs/commands.md has every command of the program with every option that its help names, and no
// other.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Options = std::set<std::string>;

void add_all(const std::string& text, const std::regex& option, Options& found) {
  for (std::sregex_iterator it(text.begin(), text.end(), option); it != std::sregex_iterator(); ++it) {
    found.insert((*it)[1]);
  }
}

/// The long options of each command of the synopsis: the indented lines before the first other text.
std::map<std::string, Options> synopsis() {
  std::ifstream document(TUMBLE_SOURCE_FOLDER "/docs/commands.md");
  std::map<std::string, Options> commands;
  std::string line, command;
  while (std::getline(document, line)) {
    if (!line.starts_with("    ")) {
      if (line.empty() || line.starts_with("#")) continue;
      break;
    }
    std::smatch start;
    if (std::regex_search(line, start, std::regex("^    tumble ([a-z]+)"))) command = start[1];
    add_all(line, std::regex("[^-a-z](--[a-z][-a-z]*)"), commands[command]);
  }
  return commands;
}

/// Those that the help of a command lists, without those that every command has or that the synopsis gives by `-o`.
Options options_of_help(const std::string& help) {
  Options options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::smatch option;
    if (std::regex_search(line, option, std::regex("^  (?:-[a-z],)?(--[a-z][-a-z]*)"))) options.insert(option[1]);
  }
  options.erase("--help");
  options.erase("--output");
  return options;
}

TEST(Synopsis, HasEveryCommandAndItsOptions) {
  const Workshop shop;
  std::map<std::string, Options> said = synopsis();
  ASSERT_GE(said.size(), 15U) << "no synopsis found in docs/commands.md";
  said.erase("help");
  const std::string overview = shop.run({"help"}).out;
  const std::regex row("\n  ([a-z]+)  +");
  std::size_t commands = 0;
  for (std::sregex_iterator it(overview.begin(), overview.end(), row); it != std::sregex_iterator(); ++it) {
    const std::string command = (*it)[1];
    if (command == "help") continue;
    ++commands;
    const Outcome help = shop.run({command, "--help"});
    ASSERT_EQ(help.exit, 0) << command;
    EXPECT_EQ(said[command], options_of_help(help.out)) << "tumble " << command << " in docs/commands.md";
  }
  EXPECT_EQ(commands, said.size()) << overview;
}

}  // namespace
}  // namespace tumble::test
