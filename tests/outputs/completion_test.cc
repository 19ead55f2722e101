// Shells complete every command that help lists, and the words that a command takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Words = std::vector<std::string>;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Words words_of(const std::string& text) {
  std::istringstream in(text);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The commands that `tumble help` lists.
Words commands(const Workshop& shop) {
  std::istringstream lines(shop.run({"help"}).out);
  Words names;
  bool listed = false;
  for (std::string line; std::getline(lines, line) && !(listed && line.empty());) {
    if (listed) names.push_back(words_of(line).at(0));
    listed = listed || line == "Commands:";
  }
  EXPECT_GT(names.size(), 15U);
  return names;
}

/// What bash offers where the last of these words is being typed.
Words offered_by_bash(const Workshop& shop, const std::string& typed) {
  shop.write("complete.sh", shop.run({"help", "--completion", "bash"}).out);
  const std::string ask = "source ./complete.sh; COMP_WORDS=(tumble " + typed +
                          "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _tumble; echo \"${COMPREPLY[*]}\"";
  return words_of(shop.run_after("bash -c '" + ask + "'; exit 0; ", {}).out);
}

bool offers(const Words& words, const std::string& word) { return std::ranges::find(words, word) != words.end(); }

TEST(Completion, OffersEveryCommand) {
  const Workshop shop;
  const std::string zsh = shop.run({"help", "--completion", "zsh"}).out;
  const std::string fish = shop.run({"help", "--completion", "fish"}).out;
  const Words by_bash = offered_by_bash(shop, R"("")"), behind_help = offered_by_bash(shop, R"(help "")");
  for (const std::string& command : commands(shop)) {
    EXPECT_TRUE(offers(by_bash, command)) << command;
    EXPECT_TRUE(offers(behind_help, command)) << command;
    EXPECT_TRUE(holds(zsh, "  '" + command + ":")) << command;
    EXPECT_TRUE(holds(zsh, "  " + command + ") _arguments")) << command;
    EXPECT_TRUE(holds(fish, "-n __fish_use_subcommand -f -a " + command + " ")) << command;
    EXPECT_TRUE(offers(offered_by_bash(shop, command + " --h"), "--help")) << command;
  }
}

// The words of a command are those that it takes: an error lists them.
TEST(Completion, OffersTheWordsThatACommandTakes) {
  const Workshop shop;
  const Outcome wrong = shop.run({"bench", "nothing"});
  EXPECT_EQ(wrong.exit, 2);
  const Words offered = offered_by_bash(shop, R"(bench "")");
  EXPECT_GT(offered.size(), 10U);
  const std::string zsh = shop.run({"help", "--completion", "zsh"}).out;
  const std::string fish = shop.run({"help", "--completion", "fish"}).out;
  std::string all;
  for (const std::string& word : offered) {
    EXPECT_TRUE(holds(wrong.err, word)) << wrong.err;
    all += (all.empty() ? "" : " ") + word;
  }
  EXPECT_TRUE(holds(zsh, "':WHAT:(" + all + ")'"));
  EXPECT_TRUE(holds(fish, "'__fish_seen_subcommand_from bench' -f -a '" + all + "'"));
  EXPECT_EQ(offered_by_bash(shop, "bench pe"), Words{"peers"});
  EXPECT_TRUE(offered_by_bash(shop, "record bri").empty()) << "files are completed by bash itself";
}

}  // namespace
}  // namespace tumble::test
