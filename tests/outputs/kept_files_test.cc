// No command writes over what it reads, or over a golden, whatever name the output has.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/outputs/small_table.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// The content of every file of a workshop but the program's last output.
std::map<std::string, std::string> all_files(const Workshop& shop) {
  std::map<std::string, std::string> files;
  const fs::path root = shop.path("");
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string name = fs::relative(entry.path(), root).string();
    if (entry.is_regular_file() && !name.starts_with(".")) files[name] = shop.read(name);
  }
  return files;
}

/// Each command is refused with status 2 and these words, and no file changes, comes or goes.
void expect_refused(const Workshop& shop, const std::vector<Words>& commands, const std::string& part) {
  const auto before = all_files(shop);
  for (const Words& words : commands) {
    const Outcome outcome = shop.run(words);
    std::string line;
    for (const std::string& word : words) line += word + ' ';
    EXPECT_EQ(outcome.exit, 2) << line << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << line << outcome.err;
    EXPECT_TRUE(all_files(shop) == before) << line;
  }
}

class KeptFiles : public testing::Test {
 protected:
  void SetUp() override {
    shop_.record_small("a");
    shop_.record_small("b", {"--set", "material.friction=0.3"});
    shop_.write("t.csv", kSmallTable);
  }
  void add_case() const {
    shop_.write("s/cases/one/scene.toml", kSmallScene);
    shop_.write("s/cases/one/metrics.toml", "[[metric]]\nname = \"drift_max\"\nmax = 100.0\nwhy = \"they fall\"\n");
    const Outcome outcome = shop_.run({"bless", "--all", "--suite", "s", "--reason", "a test"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
    shop_.write("s/cases/one/frame_0010.png", "a golden picture");
  }
  Workshop shop_;
};

TEST_F(KeptFiles, InputsUnderAllTheirNamesAreLeftAlone) {
  for (const char* ending : {".svg", ".png", ".mp4", ".tumble", ".toml"}) {
    fs::create_hard_link(shop_.path("a.tumble"), shop_.path(std::string("hard") + ending));
    fs::create_symlink("a.tumble", shop_.path(std::string("soft") + ending));
  }
  fs::create_directory_symlink(".", shop_.path("here"));
  std::vector<Words> commands;
  for (const std::string name : {"a.tumble", "./a.tumble", "here/a.tumble", "hard.png", "soft.svg"}) {
    commands.push_back({"measure", "a.tumble", "--series", name});
    commands.push_back({"measure", "b.tumble", "--with", "a.tumble", "--series", name});
  }
  for (const std::string stem : {"hard", "soft"}) {
    commands.push_back({"measure", "a.tumble", "--plot", stem + ".svg"});
    commands.push_back({"diff", "a.tumble", "b.tumble", "--plot", stem + ".png"});
    commands.push_back({"diff", "b.tumble", "a.tumble", "--plot", stem + ".svg"});
    commands.push_back({"render", "a.tumble", "-o", stem + ".png"});
    commands.push_back({"render", "a.tumble", "-o", stem + ".mp4"});
    commands.push_back({"render", "b.tumble", "--compare", "a.tumble", "-o", stem + ".png"});
    commands.push_back({"recover", "a.tumble", "-o", stem + ".tumble"});
    commands.push_back({"import", "t.csv", "--like", "a.tumble", "-o", stem + ".tumble"});
    commands.push_back({"record", "--from", "a.tumble:10", "-o", stem + ".tumble"});
    commands.push_back({"bench", "memory", "--scene", stem + ".toml", "--save", "a.tumble"});
  }
  expect_refused(shop_, commands, " itself");
}

TEST_F(KeptFiles, TheFolderOfPicturesMayHoldTheLog) {
  fs::create_directory(shop_.path("frames"));
  fs::create_hard_link(shop_.path("a.tumble"), shop_.path("frames/frame_0020.png"));
  expect_refused(shop_, {{"render", "a.tumble", "--every", "10", "-o", "frames"}}, "the log that is drawn itself");
}

TEST_F(KeptFiles, ABisectionDoesNotEmptyTheFolderOfItsLog) {
  shop_.write("work/bisect.lock", "");
  shop_.write("work/sessions/x.tumble", shop_.read("a.tumble"));
  fs::permissions(shop_.path("work"), fs::perms::owner_all);
  expect_refused(shop_, {{"bisect", "--good", "HEAD", "--bad", "HEAD", "work/sessions/x.tumble", "--work", "work"}},
                 "the session to ask about");
}

TEST_F(KeptFiles, NoCommandButBlessWritesGoldens) {
  add_case();
  fs::create_symlink("s/cases/one/frame_0010.png", shop_.path("link.png"));
  fs::create_symlink("s/cases/one/expected.tumble", shop_.path("link.tumble"));
  const std::string scene = "s/cases/one/scene.toml", rules = "s/cases/one/metrics.toml";
  expect_refused(shop_,
                 {{"measure", "a.tumble", "--series", rules},
                  {"measure", "a.tumble", "--series", "s/HISTORY.md"},
                  {"measure", "a.tumble", "--plot", "link.png"},
                  {"diff", "a.tumble", "b.tumble", "--plot", "s/cases/one/frame_0010.png"},
                  {"render", "a.tumble", "-o", "link.png"},
                  {"render", "a.tumble", "--every", "10", "-o", "s/cases/one"},
                  {"record", "a.toml", "-o", "s/cases/one/expected.tumble"},
                  {"record", "a.toml", "-o", "link.tumble"},
                  {"record", "--from", "a.tumble:10", "-o", "link.tumble"},
                  {"recover", "a.tumble", "-o", "s/cases/one/expected.tumble"},
                  {"import", "t.csv", "-o", "link.tumble"},
                  {"bench", "memory", "--scene", "a.toml", "--save", rules}},
                 "golden");
  const fs::path stray = shop_.path("moved.tumble");  // outside a case the file itself says what it is
  fs::copy_file(shop_.path("s/cases/one/expected.tumble"), stray);
  expect_refused(shop_, {{"record", "a.toml", "-o", "moved.tumble"}}, "is a golden");
  expect_refused(shop_,
                 {{"measure", "a.tumble", "--series", "moved.tumble"},
                  {"measure", "a.tumble", "--series", "b.tumble"},
                  {"bench", "memory", "--scene", "a.toml", "--save", "b.tumble"}},
                 "is a log or a golden");
}

TEST_F(KeptFiles, AReportKeepsOffTheSuite) {
  add_case();
  fs::create_directories(shop_.path("r"));
  fs::create_directory_symlink("../s/cases", shop_.path("r/cases"));
  expect_refused(shop_,
                 {{"check", "--suite", "s", "--report", "s"},
                  {"check", "--suite", "s", "--report", "./s/../s"},
                  {"check", "--suite", "s", "--report", "s/cases"},
                  {"check", "--suite", "s", "--report", "s/cases/one"},
                  {"check", "--suite", "s", "--report", "r"},
                  {"check", "--suite", "s", "--report", "q", "--junit", "s/cases/one/scene.toml"},
                  {"check", "--suite", "s", "--report", "q", "--junit", "r/cases/one/junit.xml"}},
                 "cases");
  expect_refused(shop_, {{"check", "--suite", "s", "--report", "q", "--junit", "s/HISTORY.md"}}, "history");
}

// A slip of the command line does not cost a file that no command of this kind wrote.
TEST_F(KeptFiles, OutputsReplaceNothingButTheirOwnKind) {
  add_case();
  const std::string kText = "a person's words", kBinary("a person's\0data", 15);
  shop_.write("x.csv", kBinary);
  for (const char* ending : {"npz", "glb", "mcap", "png", "mp4", "webm", "html", "svg", "json", "tumble"}) {
    shop_.write(std::string("x.") + ending, kText);
  }
  expect_refused(shop_,
                 {{"export", "a.tumble", "-o", "x.csv"},
                  {"export", "a.tumble", "-o", "x.npz"},
                  {"export", "a.tumble", "-o", "x.glb"},
                  {"export", "a.tumble", "-o", "x.mcap"},
                  {"render", "a.tumble", "-o", "x.png"},
                  {"render", "a.tumble", "-o", "x.mp4"},
                  {"render", "a.tumble", "-o", "x.webm"},
                  {"view", "a.tumble", "-o", "x.html"},
                  {"measure", "a.tumble", "--series", "x.csv"},
                  {"measure", "a.tumble", "--plot", "x.svg"},
                  {"diff", "a.tumble", "b.tumble", "--plot", "x.png"},
                  {"bench", "memory", "--scene", "a.toml", "--save", "x.json"},
                  {"record", "a.toml", "-o", "x.tumble"},
                  {"record", "--from", "a.tumble:10", "-o", "x.tumble"},
                  {"import", "t.csv", "-o", "x.tumble"},
                  {"recover", "a.tumble", "-o", "x.tumble"}},
                 "x.");
  for (const std::string name : {"index.html", "report.json", "junit.xml"}) {
    shop_.write("site/" + name, kText);
    expect_refused(shop_, {{"check", "--suite", "s", "--report", "site"}}, "site/" + name + ": exists and is no");
    fs::remove(shop_.path("site/" + name));
  }
}

// The name that a file has says nothing of what it holds.
TEST_F(KeptFiles, OutputsOfOneKindLookAtTheFileAndNotAtItsName) {
  add_case();
  shop_.write("prog.c", "int main(void) { return 0; }\n");
  shop_.write("package.json", "{\"name\": \"mine\"}\n");
  shop_.write("b.tumblestream", std::string("\x89tumblestream\r\n\x1a\1\0", 18));
  shop_.write("elf", std::string("\x7f"
                                 "ELF\2\1\1\0",
                                 8));
  for (const std::string name : {"prog.c", "b.tumblestream", "elf", "package.json", "a.tumble", "moved.tumble"}) {
    if (name == "moved.tumble") fs::copy_file(shop_.path("s/cases/one/expected.tumble"), shop_.path(name));
    std::vector<Words> commands = {{"measure", "b.tumble", "--series", name},
                                   {"check", "--suite", "s", "--report", "q", "--junit", name}};
    if (name != "package.json") commands.push_back({"bench", "memory", "--scene", "a.toml", "--save", name});
    expect_refused(shop_, commands, name);
  }
  EXPECT_FALSE(fs::exists(shop_.path("q"))) << "nothing ran";
}

TEST_F(KeptFiles, AReportWithoutAPlaceCostsNoRunOfTheSuite) {
  add_case();
  expect_refused(shop_, {{"check", "--suite", "s", "--report", "a.toml/r"}},
                 "a.toml/r: cannot be written: Not a directory");
  EXPECT_EQ(shop_.run({"check", "--suite", "s", "--report", "a.toml/r"}).out, "") << "no case ran";
  EXPECT_EQ(shop_.run({"check", "--suite", "s", "--report", "/proc/r"}).exit, 2);
}

TEST_F(KeptFiles, AnOutputTakesThePlaceOfAnEarlierOne) {
  add_case();
  fs::remove(shop_.path("s/cases/one/frame_0010.png"));
  for (const Words& words : std::vector<Words>{{"export", "a.tumble", "-o", "y.csv"},
                                               {"export", "a.tumble", "-o", "y.npz"},
                                               {"export", "a.tumble", "-o", "y.glb"},
                                               {"view", "a.tumble", "-o", "y.html"},
                                               {"measure", "a.tumble", "--series", "y.csv", "--plot", "y.svg"},
                                               {"bench", "memory", "--scene", "a.toml", "--save", "y.json"},
                                               {"record", "a.toml", "-o", "y.tumble"},
                                               {"import", "t.csv", "-o", "y.tumble"},
                                               {"recover", "a.tumble", "-o", "y.tumble"},
                                               {"check", "--suite", "s", "--report", "r"}}) {
    for (int time = 0; time < 2; ++time) {
      const Outcome outcome = shop_.run(words);
      EXPECT_EQ(outcome.exit, 0) << words[0] << ' ' << words.back() << ": " << outcome.err;
    }
  }
}

TEST_F(KeptFiles, TwoOutputsAreTwoFiles) {
  expect_refused(shop_,
                 {{"measure", "a.tumble", "--series", "x.svg", "--plot", "./x.svg"},
                  {"bench", "scaling", "--budget", "0.3", "--save", "x.svg", "--plot", "x.svg"}},
                 "is the file of");
}

}  // namespace
}  // namespace tumble::test
