// The relations of `tumble hunt --engine`: an engine that breaks one is seen to.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::ordered_json;

// An engine whose gravity changes with each run, and one that takes it from the first body's mass.
TEST(HuntEngine, IsAskedAgainAndOtherwise) {
  const Workshop shop;
  const auto broken = [&shop](const std::string& digits, const std::string& relation) {
    shop.write("tumble.toml", R"([engine]
shell = true
run = '''")" TUMBLE_PROGRAM R"(" record {scene} -o {log} --quiet --set "world.gravity=[0,0,-9.$()" +
                                  digits + ")]\"'''\n[engine.claims]\n" + relation + " = true\n");
    const Outcome run = shop.run({"hunt", "--engine", "--seed", "5", "--count", "6", "--relation", relation,
                                  "--unshrunk", "--json", "--threads", "1"});
    EXPECT_EQ(run.exit, 1) << run.err << run.out;
    const Json json = Json::parse(run.out, nullptr, false);
    return json.is_object() ? json.at("relations").at(relation).at("broken").get<int>() : -1;
  };
  EXPECT_GT(broken("echo >>runs; wc -l <runs", "repeat"), 0);
  for (const char* relation : {"inserted", "ids"}) {
    EXPECT_GT(broken("sed -n \"s/^mass = .*[.]//p\" {scene} | head -n 1", relation), 0) << relation;
  }
}

}  // namespace
}  // namespace tumble::test
