// The examples of the documents are run, so that no printed hash, size or count goes stale.
//
// In a block that starts with ```console a line "$ command" is run by sh, and the lines below it are its output, both
// streams together. "…" stands for any text within a line, and a line "…" for any number of lines. A command without
// lines below it only must not end with status 2 (bad usage) or 4 (could not finish). The blocks of a document share a
// folder, which starts empty.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/source_tree.h"

namespace tumble::test {
namespace {

const std::string kAny = "…";

struct Example {
  std::size_t line = 0;
  std::string command;
  std::vector<std::string> output;
};

std::vector<Example> examples_of(const SourceFile& document) {
  std::vector<Example> examples;
  bool in_block = false;
  for (std::size_t i = 0; i < document.lines.size(); ++i) {
    const std::string& line = document.lines[i];
    if (line.starts_with("```")) {
      in_block = line == "```console";
    } else if (in_block && line.starts_with("$ ")) {
      examples.push_back({i + 1, line.substr(2), {}});
    } else if (in_block && !examples.empty()) {
      examples.back().output.push_back(line);
    }
  }
  return examples;
}

// Blanks between examples belong to none.
void drop_blank_end(std::vector<std::string>& lines) {
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
}

bool line_matches(const std::string& line, const std::string& wanted) {
  std::string pattern;
  for (std::size_t at = 0; at < wanted.size();) {
    if (wanted.compare(at, kAny.size(), kAny) == 0) {
      pattern += ".*";
      at += kAny.size();
      continue;
    }
    if (std::string_view(R"(\^$.|?*+()[]{})").find(wanted[at]) != std::string_view::npos) pattern += '\\';
    pattern += wanted[at++];
  }
  return std::regex_match(line, std::regex(pattern));
}

bool matches(const std::vector<std::string>& lines, const std::vector<std::string>& wanted) {
  std::vector<bool> reached(lines.size() + 1, false);  // whether the wanted lines so far may end before line i
  reached[0] = true;
  for (const std::string& want : wanted) {
    std::vector<bool> next(lines.size() + 1, false);
    for (std::size_t i = 0; i <= lines.size(); ++i) {
      if (want == kAny) {
        next[i] = reached[i] || (i > 0 && next[i - 1]);
      } else {
        next[i] = i > 0 && reached[i - 1] && line_matches(lines[i - 1], want);
      }
    }
    reached = next;
  }
  return reached.back();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  drop_blank_end(lines);
  return lines;
}

// Runs an example in a folder; `tumble` is this build's.
void run(const Workshop& shop, const SourceFile& document, Example example) {
  shop.write("example.sh", "PATH=" + shop.path("bin") + ":$PATH\n" + example.command + "\n");
  const std::string line = "cd '" + shop.path("work") + "' && sh ../example.sh >../output 2>&1";
  const int status = std::system(line.c_str());
  const std::string output = shop.read("output");
  const int exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  drop_blank_end(example.output);
  if (example.output.empty()) {
    EXPECT_TRUE(exit == 0 || exit == 1 || exit == 3)
        << document.path << ':' << example.line << ": " << example.command << "\nended with a failure:\n"
        << output;
    return;
  }
  EXPECT_TRUE(matches(lines_of(output), example.output))
      << document.path << ':' << example.line << ": " << example.command << "\nprints something else now:\n"
      << output;
}

TEST(Examples, PrintWhatTheDocumentsShow) {
  std::size_t seen = 0;
  for (const SourceFile& document : source_tree()) {
    if (!document.ends_with(".md")) continue;
    const std::vector<Example> examples = examples_of(document);
    if (examples.empty()) continue;
    const Workshop shop;
    std::filesystem::create_directories(shop.path("bin"));
    std::filesystem::create_directories(shop.path("work"));
    std::filesystem::create_symlink(TUMBLE_PROGRAM, shop.path("bin/tumble"));
    for (const Example& example : examples) run(shop, document, example);
    seen += examples.size();
  }
  EXPECT_GE(seen, 5U) << "the test saw hardly any examples, so it proves nothing";
}

TEST(Examples, DotsStandForTextAndForLines) {
  EXPECT_TRUE(matches({"elapsed  1.2 s", "size"}, {"elapsed  … s", "size"}));
  EXPECT_FALSE(matches({"elapsed  1.2 s", "size"}, {"elapsed  … ms", "size"}));
  EXPECT_FALSE(matches({"one", "two"}, {"one"}));
  EXPECT_TRUE(matches({"one", "two", "three"}, {"…", "three"}));
  EXPECT_TRUE(matches({"[1.0]"}, {"[1.0]"}));
  EXPECT_FALSE(matches({"[1x0]"}, {"[1.0]"}));
}

// Commands in the documents' text, run or not: "tumble record …" at the start of a line of a block.
TEST(Examples, OptionsInTheDocumentsExist) {
  const std::regex command(R"(^(?:    )?(?:\$ )?tumble ([a-z]+) (.*)$)");
  const std::regex option(R"((?:^|[ \[])(--[a-z][a-z-]*))");
  const std::regex quoted("'[^']*'");  // another program's words, or a value
  const Workshop shop;
  std::map<std::string, std::string> helps;
  std::size_t seen = 0;
  for (const SourceFile& document : source_tree()) {
    if (!document.ends_with(".md")) continue;
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_match(document.lines[i], match, command)) continue;
      const std::string name = match[1];
      if (name == "help") continue;
      if (!helps.contains(name)) {
        const Outcome help = shop.run({name, "--help"});
        helps[name] = help.exit == 0 ? help.out : "";
      }
      EXPECT_NE(helps[name], "") << document.path << ':' << i + 1 << ": there is no command " << name;
      const std::string words = std::regex_replace(match[2].str(), quoted, "");
      for (std::sregex_iterator it(words.begin(), words.end(), option); it != std::sregex_iterator(); ++it) {
        ++seen;
        EXPECT_NE(helps[name].find((*it)[1].str()), std::string::npos)
            << document.path << ':' << i + 1 << ": " << name << " has no option " << (*it)[1];
      }
    }
  }
  EXPECT_GE(seen, 20U) << "the test saw hardly any options, so it proves nothing";
}

}  // namespace
}  // namespace tumble::test
