// [engine.table] of a tumble.toml: the tables and the archives of an engine, read by replay as import read them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

void write_project(const Workshop& shop, const std::string& run, const std::string& more = "") {
  shop.write("tumble.toml", "[engine]\nrun = \"" + run + "\"\n" + more);
}

// A table with names of its own is read as [engine.table] says, by replay as by import.
TEST(EngineReading, ReplayReadsATableByItsMapping) {
  const Workshop shop;
  const auto renamed = [&](const char* name, const char* height) {
    std::string text = table();
    text.replace(text.find("position.x"), 10, "px");
    const std::size_t at = text.find("0.7,");
    text.replace(at, 3, height);
    shop.write(name, text);
  };
  renamed("a.csv", "0.7");
  shop.write("its.map", "# the engine's names\nposition.x = px\n");
  ASSERT_EQ(shop.run({"import", "a.csv", "--map-file", "its.map"}).exit, 0);
  write_project(shop, "cp new.csv {log}", "[engine.table]\nmap_file = \"its.map\"\n");
  renamed("new.csv", "0.7");
  const Outcome same = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  renamed("new.csv", "0.8");
  const Outcome other = shop.run({"replay", "a.tumble", "--json"});
  EXPECT_EQ(other.exit, 1) << other.err;
  EXPECT_EQ(parsed(other)["first"]["field"], "position.z");
  EXPECT_EQ(parsed(other)["first"]["step"], 2);
  write_project(shop, "cp new.csv {log}", "[engine.table]\nmap = [\"position.x=px\"]\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 1);
  write_project(shop, "cp new.csv {log}");
  const Outcome without = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(without.exit, 4) << without.out;
  EXPECT_TRUE(says(without.err, "position.x")) << without.err;
  write_project(shop, "cp new.csv {log}", "[engine.table]\nmap = \"px\"\n");
  EXPECT_TRUE(says(shop.run({"replay", "a.tumble"}).err, "[engine.table] key \"map\"")) << "a mapping without =";
}

// What `import` reads before the names of the columns is there for [engine.table] too: a mark of UTF-8, empty lines,
// blanks, and names that hold commas.
TEST(EngineReading, ReplayFindsTheNamesWhereImportFindsThem) {
  const Workshop shop;
  std::string text = table();
  text.replace(text.find("position.x"), 10, "px");
  shop.write("a.csv", text);
  ASSERT_EQ(shop.run({"import", "a.csv", "--map", "position.x=px"}).exit, 0);
  write_project(shop, "cp new.csv {log}", "[engine.table]\nmap = [\"position.x=px\"]\n");
  for (const char* before : {"\n", "\xef\xbb\xbf", "\n  # a remark\n \n"}) {
    shop.write("new.csv", before + text);
    const Outcome same = shop.run({"replay", "a.tumble"});
    EXPECT_EQ(same.exit, 0) << before << same.out << same.err;
  }
  std::string named = "# escapes: percent\n" + text;
  named.replace(named.find("px"), 2, "p%2cx");
  shop.write("new.csv", named);
  write_project(shop, "cp new.csv {log}", "[engine.table]\nmap = [\"position.x=p,x\"]\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 0);
  named.replace(named.find("frozen"), 6, "frozen,_a%2cb");
  for (std::size_t at = named.find("\n0,"); at != std::string::npos && at + 1 < named.size();) {
    at = named.find('\n', at + 1);
    if (at != std::string::npos) named.insert(at, ",1"), at += 2;
  }
  shop.write("new.csv", named);
  const Outcome comma = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(comma.exit, 0) << comma.out << comma.err;
}

// An archive of arrays likewise, by the joints of its model.
TEST(EngineReading, ReplayReadsAnArchiveOfArrays) {
  const Workshop shop;
  const std::string robot = std::string(TUMBLE_SOURCE_DIR) + "/tests/data/robot.npz";
  ASSERT_EQ(shop.run({"import", robot, "-o", "a.tumble"}).exit, 0);
  write_project(shop, "cp '" + robot + "' {log}");
  const Outcome same = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
}

// Columns that the format does not know are channels where [engine.table] says so, for replay and for each revision
// that bisect runs.
TEST(EngineReading, EveryOtherColumnIsAChannelAndBisectFindsWhatMovedIt) {
  const Workshop shop;
  const auto write_knees = [&](const std::string& name, const std::string& angle) {
    std::string text = table();
    text.replace(text.find("frozen"), 6, "frozen,knee");
    for (std::size_t k = 0; k < 5; ++k) {
      const std::string row = "\n" + std::to_string(k) + ",2,";
      text.insert(text.find('\n', text.find(row) + 1), k == 3 ? ',' + angle : ",0.5");
      text.insert(text.find('\n', text.find("\n" + std::to_string(k) + ",1,") + 1), ",0.25");
    }
    shop.write(name, text);
  };
  write_knees("a.csv", "0.5");
  ASSERT_EQ(shop.run({"import", "a.csv", "--channels"}).exit, 0);
  const std::string channels = "[engine.table]\nchannels = true\n";
  write_knees("new.csv", "0.75");
  write_project(shop, "cp new.csv {log}", channels);
  const Outcome moved = shop.run({"replay", "a.tumble", "--json"});
  EXPECT_EQ(moved.exit, 1) << moved.err;
  EXPECT_EQ(parsed(moved)["first"]["field"], "channel.knee") << moved.out;
  EXPECT_EQ(parsed(moved)["first"]["step"], 3);
  write_project(shop, "cp new.csv {log}");
  EXPECT_TRUE(says(shop.run({"replay", "a.tumble"}).err, "knee")) << "without the key it is an unknown column";
  write_project(shop, "cp new.csv {log}", "[engine.table]\nchannels = 1\n");
  EXPECT_TRUE(says(shop.run({"replay", "a.tumble"}).err, "[engine.table] key \"channels\": found 1")) << "no flag";

  write_knees("project/knees.csv", "0.5");
  write_knees("moved.csv", "0.75");
  shop.write("project/tumble.toml", "[engine]\nbuild = 'cp knees.csv new.csv'\nrun = 'cp new.csv {log}'\n" + channels);
  const std::string commits = "{ cd '" + shop.path("project") + R"(' && git init -q -b main
commit() { git add -A && git -c user.name=a -c user.email=a@b commit --allow-empty -qm "$1"; }
echo new.csv >.gitignore; commit first; commit second
mv ../moved.csv knees.csv; commit moved; commit last
} >')" + shop.path("said") + "' 2>&1";
  ASSERT_EQ(std::system(commits.c_str()), 0) << shop.read("said");
  const Outcome bisect = shop.run(
      {"bisect", "--repo", "project", "--good", "HEAD~3", "--bad", "HEAD", "a.tumble", "--work", "work", "--json"});
  EXPECT_EQ(bisect.exit, 1) << bisect.err;
  EXPECT_EQ(parsed(bisect)["commit"]["subject"], "moved") << bisect.out;
  EXPECT_EQ(parsed(bisect)["sessions"]["first"]["field"], "channel.knee") << bisect.out;
}

}  // namespace
}  // namespace tumble::test
