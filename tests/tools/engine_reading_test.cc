// [engine.table] of a tumble.toml: the tables and the archives of an engine, read by replay as import read them.
#include <gtest/gtest.h>

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
  EXPECT_EQ(without.exit, 2) << without.out;
  EXPECT_TRUE(says(without.err, "position.x")) << without.err;
  write_project(shop, "cp new.csv {log}", "[engine.table]\nmap = \"px\"\n");
  EXPECT_TRUE(says(shop.run({"replay", "a.tumble"}).err, "[engine.table] key \"map\"")) << "a mapping without =";
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

}  // namespace
}  // namespace tumble::test
