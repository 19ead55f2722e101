// Two builds of the program of a real engine, compiled from the sources in examples/engines with one line changed:
// `diff --zoom` names the line, `bisect` the commit.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

struct Glue {
  std::string name;     // of the engine's folder
  std::string flags;    // of pkg-config
  std::string line;     // of the demo, which the change replaces
  std::string changed;  // its replacement
  std::string probe;    // that then differs first
};

void shell(const Workshop& shop, const std::string& commands) {
  const std::string line =
      "{ cd '" + shop.path("") + "' && set -e\n" + commands + "\n} >'" + shop.path("said") + "' 2>&1";
  ASSERT_EQ(std::system(line.c_str()), 0) << shop.read("said");
}

/// A clone with the glue and its tumble.toml; the third of four commits has the change.
void make_project(const Workshop& shop, const Glue& glue) {
  const std::string tree = TUMBLE_SOURCE_FOLDER, from = tree + "/examples/engines/" + glue.name + "/";
  shell(shop, "mkdir -p project/" + glue.name + "\ncp " + from + glue.name + "_demo.cc " + from + "tumble_" +
                  glue.name + ".h project/" + glue.name + "/\ncp " + tree + "/examples/engines/demo.h " + tree +
                  "/replay/recorder/tumble_recorder.* " + tree + "/replay/probe/tumble_probe.* project/");
  const std::string demo = glue.name + "/" + glue.name + "_demo.cc";
  shop.write("project/build.sh",
             "set -e\nmkdir -p out\ncc -O1 -I. -c tumble_recorder.c -o out/recorder.o\ncc -O1 -I. -c "
             "tumble_probe.c -o out/probe.o\nc++ -std=c++20 -O1 -I. " +
                 demo + " out/recorder.o out/probe.o " + glue.flags + " -o out/demo\n");
  shop.write("project/tumble.toml", "[engine]\nbuild = 'sh build.sh'\nrun = 'out/demo {log} --steps 60'\n");
  shop.write("project/.gitignore", "out\n");
  shop.write("change.sed", "s|" + glue.line + "|" + glue.changed + "|\n");
  shell(shop,
        "cd project\ncommit() { git add -A && git -c user.name=a -c user.email=a@b commit --allow-empty -qm \"$1\"; }\n"
        "git init -q -b main\ncommit first\ncommit second\nsed -i -f ../change.sed " +
            demo + "\ncommit changed\ncommit last\ngit worktree add -q ../before HEAD~2");
}

void check_two_builds(const Glue& glue) {
  const Workshop shop;
  make_project(shop, glue);
  shell(
      shop,
      "for build in before project; do (cd $build && sh build.sh && out/demo ../$build.tumblestream --steps 60); done");
  for (const char* build : {"before", "project"}) {
    ASSERT_EQ(shop.run({"import", std::string(build) + ".tumblestream"}).exit, 0);
  }
  const Outcome diff = shop.run(
      {"diff", "before.tumble", "project.tumble", "--zoom", "--engine-a", "before", "--engine-b", "project", "--json"});
  EXPECT_EQ(diff.exit, 1) << diff.err;
  const ordered_json first = parsed(diff)["first"];
  EXPECT_GT(first["step"], 0) << first;
  EXPECT_GT(first["body"], 0) << first;
  EXPECT_TRUE(says(first["field"], ".")) << first;
  const ordered_json zoom = parsed(diff)["zoom"];
  ASSERT_TRUE(zoom["first"].is_object()) << zoom;
  EXPECT_EQ(zoom["first"]["actual"]["name"], glue.probe) << zoom["first"];
  EXPECT_TRUE(says(zoom["first"]["actual"]["file"], glue.name + "_demo.cc")) << zoom["first"];
  EXPECT_EQ(zoom["strays"], ordered_json({"", ""})) << "both builds repeat their logs";
  const Outcome bisect = shop.run({"bisect", "--repo", "project", "--good", "HEAD~3", "--bad", "HEAD", "before.tumble",
                                   "--work", "work", "--json"});
  EXPECT_EQ(bisect.exit, 1) << bisect.err;
  EXPECT_EQ(parsed(bisect)["commit"]["subject"], "changed") << bisect.out;
}

#ifdef TUMBLE_HAS_ODE
TEST(TwoBuilds, OfTheGlueOfOde) {
  check_two_builds({"ode", "$(pkg-config --cflags --libs ode)", "surface.mu = scene.friction;",
                    "surface.mu = scene.friction * 1.001;", "contact.friction"});
}
#endif

#ifdef TUMBLE_HAS_BULLET
TEST(TwoBuilds, OfTheGlueOfBullet) {
  check_two_builds({"bullet", "$(pkg-config --cflags --libs bullet)", "info.m_friction = btScalar(0.5);",
                    "info.m_friction = btScalar(0.501);", "contact.friction"});
}
#endif

#ifdef TUMBLE_HAS_MUJOCO
TEST(TwoBuilds, OfTheGlueOfMujoco) {
  check_two_builds({"mujoco", "-lmujoco", "data->ctrl\\[0\\] = std::sin(0.05 \\* k);",
                    "data->ctrl[0] = 1.001 * std::sin(0.05 * k);", "motor.control"});
}
#endif

TEST(TwoBuilds, NeedAnEngine) {
#if !defined(TUMBLE_HAS_ODE) && !defined(TUMBLE_HAS_BULLET) && !defined(TUMBLE_HAS_MUJOCO)
  GTEST_SKIP() << "neither Bullet nor ODE nor MuJoCo is here; tools/setup.sh --with peers installs them";
#endif
}

}  // namespace
}  // namespace tumble::test
