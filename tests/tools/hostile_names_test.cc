// Names in files are anybody's: no escape sequence of one reaches the terminal, whatever the command.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/program.h"
#include "tools/output/clean_streams.h"

namespace tumble::test {
namespace {

constexpr const char* kRed = "\x1b[31mred\x07";
constexpr const char* kC1 =
    "\xc2\x9b"
    "31mred\xe2\x80\xae";

/// The bytes of an output that would drive a terminal.
std::string harmful(const std::string& output) {
  std::string found;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const auto byte = static_cast<unsigned char>(output[i]);
    const bool is_control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f;
    const bool is_c1 = byte == 0xc2 && i + 1 < output.size() && static_cast<unsigned char>(output[i + 1]) < 0xa0;
    if (is_control || is_c1 || output.compare(i, 3, "\xe2\x80\xae") == 0) found += std::to_string(i) + ' ';
  }
  return found;
}

class HostileNames : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::string name(const std::string& rest) const { return GetParam() + rest; }
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const {
    Outcome outcome = shop_.run(arguments);
    EXPECT_EQ(harmful(outcome.out), "") << arguments[0] << ": " << outcome.out;
    EXPECT_EQ(harmful(outcome.err), "") << arguments[0] << ": " << outcome.err;
    return outcome;
  }
  Workshop shop_;
};

TEST_P(HostileNames, OfScenesLogsAndCasesReachNoTerminal) {
  shop_.write(name(".toml"), kSmallScene);
  EXPECT_EQ(run({"record", name(".toml"), "-o", name(".tumble")}).exit, 0);
  EXPECT_EQ(run({"record", name(".toml"), "-o", name("2.tumble"), "--set", "world.gravity=[0, 0, -9]"}).exit, 0);
  const std::string log = name(".tumble"), other = name("2.tumble");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"info", log},
                                                    {"replay", log},
                                                    {"measure", log},
                                                    {"dump", log},
                                                    {"diff", log, other},
                                                    {"bisect", log, other},
                                                    {"measure", log, "--require", "drift_max<=0"},
                                                    {"info", name("none")},
                                                    {"dump", log, "--bodies", name("")},
                                                    {"record", name("none.toml")},
                                                    {"replay", log, name("more")},
                                                    {name("command")},
                                                    {"recover", log, "-o", name("3.tumble")},
                                                    {"import", name(".toml")},
                                                    {"measure", log, "--json"},
                                                    {"info", log, "--json"}}) {
    (void)run(arguments);
  }
  const std::string folder = "s/cases/" + name("");
  shop_.write(folder + "/scene.toml", kSmallScene);
  shop_.write(folder + "/metrics.toml", "[[metric]]\nname = \"drift_max\"\nmax = 100.0\nwhy = \"w\"\n");
  EXPECT_EQ(run({"bless", "--all", "--suite", "s", "--reason", "a test"}).exit, 0);
  EXPECT_EQ(run({"check", "--suite", "s"}).exit, 0);
  shop_.write(folder + "/stray", "");
  EXPECT_EQ(run({"check", "--suite", "s"}).exit, 1);
}

TEST_P(HostileNames, ComeThroughJsonAsTheyAre) {
  shop_.write("s.toml", kSmallScene);
  ASSERT_EQ(run({"record", "s.toml", "-o", name(".tumble")}).exit, 0);
  const Outcome outcome = run({"measure", name(".tumble"), "--json"});
  EXPECT_EQ(nlohmann::ordered_json::parse(outcome.out)["log"], name(".tumble"));
}

INSTANTIATE_TEST_SUITE_P(Sequences, HostileNames, testing::Values(kRed, kC1));

TEST(CleanBuffer, KeepsTextInPiecesOfAnySize) {
  const std::string good = "15 → 14, ≤ 2 µm … ÿ 𝄞\t\n";
  const std::string bad =
      "\x1b[31m \x7f \xc2\x9b \xe2\x80\xae \xe2\x81\xa6 \x9b \xff\r \xe9"
      "b \xe0\x82\x9b \xc0\xaf \xed\xa0\x80 \xe2\x80";  // cut characters, longer forms than needed, half of a pair
  for (std::size_t size = 1; size < 9; ++size) {
    std::ostringstream out;
    {
      const tools::CleanStream clean(out);
      for (std::size_t at = 0; at < good.size() + bad.size(); at += size) out << (good + bad).substr(at, size);
    }
    EXPECT_EQ(out.str(), good + "?[31m ? ? ? ? ? ?? ?b ? ?? ? ?") << size;
  }
}

}  // namespace
}  // namespace tumble::test
