// What commands say of an engine's own sessions: its axes through a bisection, its bodies by name, contacts that none
// can be, shapes that are no boxes; and the scenes of the program beside a project's own.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/tools/float_engine.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

/// A clone in which each commit brings another session of the engine.
void commit(const Workshop& shop, const std::string& stream) {
  const std::string line = "cd '" + shop.path("") + "' && cp " + stream +
                           ".tumblestream clone/s.tumblestream && cd clone && git add -A && git -c user.name=t -c "
                           "user.email=t@t commit -q -m " +
                           stream;
  ASSERT_EQ(std::system(line.c_str()), 0) << line;
}

TEST(EngineAxes, BisectionNamesThemAndSaysWhenALogIsOfNeitherEnd) {
  const Workshop shop;
  FloatEngine third;
  third.gravity = -9.9F;
  recorded(shop, "a");
  recorded(shop, "b", heavier());
  recorded(shop, "c", third);
  shop.write("clone/tumble.toml", "[engine]\nrun = 'cp s.tumblestream {log}'\n");
  ASSERT_EQ(std::system(("git init -q '" + shop.path("clone") + "'").c_str()), 0);
  for (const char* stream : {"a", "b"}) commit(shop, stream);
  const Outcome found = shop.run_after("cd clone; ", {"bisect", "--good", "HEAD~1", "--bad", "HEAD", "../a.tumble"});
  EXPECT_EQ(found.exit, 1) << found.err;
  EXPECT_TRUE(says(found.out, "position.y")) << found.out;
  EXPECT_FALSE(says(found.out, "position.z")) << found.out;
  const Outcome neither = shop.run_after("cd clone; ", {"bisect", "--good", "HEAD~1", "--bad", "HEAD", "../c.tumble"});
  EXPECT_EQ(neither.exit, 2) << neither.out;
  EXPECT_TRUE(says(neither.err, "their sessions differ from each other")) << neither.err;
  EXPECT_TRUE(says(neither.err, "record LOG anew at the good revision")) << neither.err;
}

TEST(EngineWords, ABodyThatComesBackIsCountedOnce) {
  const Workshop shop;
  const std::string at = ",0,0,1,1,0,0,0\n";
  std::string table =
      "# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z\n";
  for (const char* row : {"0,1", "0,2", "1,1", "2,1", "2,2", "3,1", "3,2", "3,3"}) table.append(row).append(at);
  shop.write("come.csv", table);
  ASSERT_EQ(shop.run({"import", "come.csv"}).exit, 0);
  const std::string info = shop.run({"info", "come.tumble"}).out;
  EXPECT_TRUE(says(info, "bodies      3, 1 of them thrown in\n")) << info;
  EXPECT_TRUE(says(info, "1 × remove, 2 × throw")) << info;
}

TEST(EngineAxes, BodiesAreChosenAndPrintedByName) {
  const Workshop shop;
  recorded(shop, "a");
  recorded(shop, "b", heavier());
  EXPECT_EQ(shop.run({"dump", "a.tumble", "--step", "3", "--body", "ball", "--csv"}).out,
            shop.run({"dump", "a.tumble", "--step", "3", "--body", "1", "--csv"}).out);
  EXPECT_EQ(shop.run({"measure", "a.tumble", "--bodies", "ball"}).exit, 0);
  const Outcome none = shop.run({"measure", "a.tumble", "--bodies", "bull"});
  EXPECT_EQ(none.exit, 2);
  EXPECT_TRUE(says(none.err, "or names of bodies, which 'tumble dump' shows")) << none.err;
  EXPECT_TRUE(says(shop.run({"dump", "a.tumble", "--step", "3", "--body", "bull"}).err, "or its name"));
  shop.write("golden/cases/fall/level.txt", "one ball\n");
  const auto write_case = [&](const std::string& bodies) {
    shop.write("golden/cases/fall/metrics.toml",
               "[engine]\nfiles = [\"level.txt\"]\n[[metric]]\nname = \"drift_max\"\nmax = 1\nbodies = \"" + bodies +
                   "\"\nwhy = \"it falls straight\"\n");
  };
  write_case("ball");
  write_project(shop, "a");
  ASSERT_EQ(shop.run({"bless", "fall", "--reason", "a test"}).exit, 0);
  EXPECT_EQ(shop.run({"check"}).exit, 0);
  write_project(shop, "b");
  EXPECT_TRUE(says(shop.run({"check"}).out, "body 1 (ball)"));
  write_case("bull");
  EXPECT_TRUE(says(shop.run({"check"}).out, "drift_max: bodies: found \"bull\""));
}

TEST(EngineAxes, ContactsThatNoneCanBeAreSaid) {
  const Workshop shop;
  FloatEngine engine;
  engine.normal_length = 7;
  EXPECT_TRUE(
      says(recorded(shop, "long", engine), "step 1, contact of 1 and the ground: the normal has a length of 7"));
  engine.depth = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(recorded(shop, "nan", engine), "step 1, contact of 1 and the ground: depth is nan"));
  shop.write("golden/cases/fall/level.txt", "one ball\n");
  shop.write(
      "golden/cases/fall/metrics.toml",
      "[engine]\nfiles = [\"level.txt\"]\n[[metric]]\nname = \"drift_max\"\nmax = 1\nwhy = \"it falls straight\"\n");
  write_project(shop, "nan");
  (void)shop.run({"bless", "fall", "--reason", "a test"});
  const Outcome checked = shop.run({"check"});
  EXPECT_EQ(checked.exit, 1);
  EXPECT_TRUE(says(checked.out, "not finite: step 1, contact of 1 and the ground: depth is nan")) << checked.out;
}

TEST(EngineAxes, ABallAtRestIsNotInTheGround) {
  const Workshop shop;
  FloatEngine ball;
  ball.sphere = true;
  ball.gravity = 0;
  ball.start = 0.5F;
  ball.spin = 3;
  recorded(shop, "ball", ball);
  const ordered_json json = parsed(shop.run({"measure", "ball.tumble", "--json"}));
  EXPECT_EQ(json["stacking"]["ground_penetration_peak"], 0.0) << json["stacking"];
  EXPECT_NEAR(json["stacking"]["kinetic_rotational_end"].get<double>(), 0.5 * 0.4 * 2 * 0.25 * 9, 1e-12);
  EXPECT_NEAR(json["energy"]["final"].get<double>() - 2 * 9.81 * 0.5, 0.9, 1e-9);
}

TEST(Scenes, OfTheProgramAreFoundBesideAProjectsOwn) {
  const Workshop shop;
  shop.write("golden/cases/mine/scene.toml", "name = \"mine\"\n[world]\nsteps = 3\n[[box]]\nid = 1\n");
  const Outcome listed = shop.run({"scenes"});
  EXPECT_TRUE(says(listed.out, "mine") && says(listed.out, "brick_wall")) << listed.out << listed.err;
  EXPECT_EQ(shop.run({"record", "bounce", "--steps", "2", "--quiet"}).exit, 0);
  EXPECT_EQ(shop.run({"record", "mine", "--quiet"}).exit, 0);
  const Outcome none = shop.run({"record", "brick_wal"});
  EXPECT_TRUE(says(none.err, "golden/cases or ")) << none.err;
  EXPECT_TRUE(says(none.err, "did you mean")) << none.err;
}

}  // namespace
}  // namespace tumble::test
