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

/// A command line up to the name of an option.
struct Value {
  std::string before;
  Words arguments;  // with a value that is none, which the error answers with those that there are
};

// What shells offer for an option's value is what the option takes: an error lists it.
TEST(Completion, OffersTheValuesThatAnOptionTakes) {
  const Workshop shop;
  shop.record_small("a");
  const std::vector<Value> values = {{"check --annotate", {"check", "--annotate", "nothing"}},
                                     {"check --require", {"check", "--require", "nothing"}},
                                     {"record a --mirror", {"record", "a.toml", "--mirror", "nothing"}},
                                     {"hunt --relation", {"hunt", "--relation", "nothing"}},
                                     {"render a --gl", {"render", "a.tumble", "--gl", "nothing"}},
                                     {"render a --pass", {"render", "a.tumble", "--pass", "nothing"}},
                                     {"render a --show", {"render", "a.tumble", "--show", "nothing"}},
                                     {"render a --effects", {"render", "a.tumble", "--effects", "nothing"}},
                                     {"help --completion", {"help", "--completion", "nothing"}}};
  for (const auto& [before, arguments] : values) {
    const Outcome wrong = shop.run(arguments);
    EXPECT_EQ(wrong.exit, 2) << before;
    const Words offered = offered_by_bash(shop, before + " \"\"");
    EXPECT_GE(offered.size(), 2U) << before;
    for (const std::string& word : offered) EXPECT_TRUE(holds(wrong.err, word)) << before << ": " << wrong.err;
  }
}

// Errors name too many metrics to list them; each one that is offered makes a bound.
TEST(Completion, OffersMetrics) {
  const Workshop shop;
  shop.record_small("a");
  Words words = {"measure", "a.tumble", "--json"};
  for (const std::string& metric : offered_by_bash(shop, "measure a --require \"\"")) {
    words.insert(words.end(), {"--require", metric + "<=0.25"});
  }
  EXPECT_GT(words.size(), 40U);
  EXPECT_NE(shop.run(words).exit, 2) << shop.run(words).err;
}

TEST(Completion, OffersValuesBehindAnEqualSignAndInEveryShell) {
  const Workshop shop;
  EXPECT_EQ(offered_by_bash(shop, "record a --hashes = st"), Words{"states"});
  EXPECT_EQ(offered_by_bash(shop, "record a --hashes =").size(), 3U);
  EXPECT_EQ(offered_by_bash(shop, "blame a --field velocity."), (Words{"velocity.x", "velocity.y", "velocity.z"}));
  EXPECT_TRUE(offered_by_bash(shop, "record a --output \"\"").empty()) << "files are completed by bash itself";
  EXPECT_TRUE(holds(shop.run({"help", "--completion", "zsh"}).out, ":SERVICE:(github gitlab)'"));
  EXPECT_TRUE(holds(shop.run({"help", "--completion", "fish"}).out, " -l annotate -x -a 'github gitlab' -d "));
}

}  // namespace
}  // namespace tumble::test
