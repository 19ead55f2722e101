// An engine that fails in a benchmark has that in its row; the others are run all the same, and the end is no good one.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A copy of the program in a build folder of its own, whose Bullet can be timed and writes no log.
class BenchFailures : public ::testing::Test {
 protected:
  BenchFailures() {
    const fs::path own = shop_.path("build"), build = fs::path(TUMBLE_PROGRAM).parent_path().parent_path();
    fs::create_directories(own / "tools");
    fs::create_directories(own / "bench" / "peers");
    fs::copy_file(TUMBLE_PROGRAM, own / "tools" / "tumble");
    fs::create_symlink(build / "bench" / "peers" / "tumble_peer_tumble",
                       own / "bench" / "peers" / "tumble_peer_tumble");
    shop_.write("build/bench/peers/tumble_peer_bullet",
                "#!/bin/sh\ncase \"$*\" in *--log*) echo 'no log of' >&2; echo mine >&2; exit 3;; esac\n"
                "echo '{\"engine\": \"Bullet 0\", \"cpu_s\": 0.5}'\n");
    shop_.write("build/bench/peers/tumble_peer_ode", "#!/bin/sh\necho '{}'\n");
    for (const char* name : {"bullet", "ode"}) {
      fs::permissions(own / "bench" / "peers" / (std::string("tumble_peer_") + name), fs::perms::owner_all);
    }
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const std::string line = "cd '" + shop_.path("") + "' && build/tools/tumble bench " + arguments + " >out 2>err";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, shop_.read("out"), shop_.read("err")};
  }

  Workshop shop_;
};

TEST_F(BenchFailures, LeaveTheOtherPeersTheirRows) {
  const std::string what = "peers --scene grid_6_coarse --repeat 1 --engine bullet --engine ode";
  const Outcome run = this->run(what);
  EXPECT_EQ(run.exit, 4) << run.err;
  EXPECT_NE(run.out.find("Bullet 0 failed: ended with status 3: no log of; mine"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("ode failed: printed no result"), std::string::npos) << run.out;
  EXPECT_NE(
      run.err.find("2 runs of engines failed, first Bullet 0 in grid_6_coarse: ended with status 3: no log of; mine"),
      std::string::npos)
      << run.err;
  const Outcome as_json = this->run(what + " --json");
  EXPECT_EQ(as_json.exit, 4);
  const Json engines = Json::parse(as_json.out)["scenes"][0]["engines"];
  ASSERT_EQ(engines.size(), 3U);
  EXPECT_EQ(engines[0]["failure"], "");
  EXPECT_EQ(engines[0]["lateral_max"], 0);
  EXPECT_EQ(engines[1]["failure"], "ended with status 3: no log of; mine");
  EXPECT_EQ(engines[2]["failure"], "printed no result");
}

TEST_F(BenchFailures, LeaveTheOtherEnginesTheirAccuracy) {
  const Outcome run = this->run("accuracy --scene grid_2 --engine bullet --engine layered --budget 0.01 --json");
  EXPECT_EQ(run.exit, 4) << run.err;
  const Json engines = Json::parse(run.out)["engines"];
  ASSERT_EQ(engines.size(), 2U);
  EXPECT_EQ(engines[0]["failure"], "");
  EXPECT_EQ(engines[1]["failure"], "dt 1/30, 1 substep: ended with status 3: no log of; mine");
  EXPECT_NE(run.err.find("1 run of engines failed: bullet in grid_2: dt 1/30"), std::string::npos) << run.err;
}

TEST_F(BenchFailures, AreNamedBesideTableOne) {
  const Outcome run = this->run("table1 --budget 0.01 --engine ode --json");
  EXPECT_EQ(run.exit, 4) << run.err;
  const Json cells = Json::parse(run.out)["cells"];
  int failed = 0;
  for (const Json& cell : cells) failed += cell["engines"][0]["failure"] == "printed no result" ? 1 : 0;
  EXPECT_GT(failed, 0);
  EXPECT_NE(run.err.find("failed"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("ode in "), std::string::npos) << run.err;
}

TEST_F(BenchFailures, LeaveTheOtherScenesTheirMemory) {
  std::string fast = kSmallScene;  // the thrown box leaves the world after four seconds
  const std::string throw_at = "velocity = [0.0, 6.0, 0.0]", steps = "steps = 40";
  fast.replace(fast.find(throw_at), throw_at.size(), "velocity = [0.0, 8000.0, 0.0]");
  fast.replace(fast.find(steps), steps.size(), "steps = 300");
  shop_.write("lost.toml", fast);
  shop_.write("small.toml", kSmallScene);
  const Outcome run = this->run("memory --scene lost.toml --scene small.toml --json");
  EXPECT_EQ(run.exit, 4) << run.err;
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json["scenes"].size(), 1U) << json;
  EXPECT_EQ(json["scenes"][0]["bodies"], 3);
  ASSERT_EQ(json["failures"].size(), 1U) << json;
  EXPECT_EQ(json["failures"][0]["run"], "lost.toml");
  EXPECT_NE(run.err.find("1 run failed: lost.toml: "), std::string::npos) << run.err;
  const Outcome text = this->run("memory --scene lost.toml --scene small.toml");
  EXPECT_NE(text.out.find("lost.toml failed: "), std::string::npos) << text.out;
  EXPECT_EQ(this->run("memory --scene small.toml --scene missing.toml").out, "") << "bad usage costs no run";
}

TEST_F(BenchFailures, LeaveTheOtherWindowsTheirFrames) {
  shop_.write("build/tools/tumble-live",
              "#!/bin/sh\ncase \"$*\" in *brick_wall*) echo 'no display' >&2; exit 4;; esac\n"
              "echo '{\"driver\": \"d\", \"measured\": {\"frames_per_second\": 9}}'\n");
  fs::permissions(shop_.path("build/tools/tumble-live"), fs::perms::owner_all);
  const Outcome run = this->run("live --budget 0.1 --json");
  EXPECT_EQ(run.exit, 4) << run.err;
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json["rows"].size(), 1U) << json;
  EXPECT_EQ(json["rows"][0]["scene"], "6400 cubes");
  EXPECT_EQ(json["failures"][0]["run"], "brick_wall");
  EXPECT_NE(run.err.find("1 run failed: brick_wall: the window ended with status 4: no display"), std::string::npos)
      << run.err;
}

TEST_F(BenchFailures, LeaveTheOtherFormatsTheirSpeed) {
  // No file of more than 100 blocks: the log and the mcap fit, npz and glb do not.
  const std::string line =
      "cd '" + shop_.path("") +
      "' && (trap '' XFSZ; ulimit -f 600; build/tools/tumble bench export --scene grid_2 --json) >out 2>err";
  const int status = std::system(line.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4) << shop_.read("err");
  const Json json = Json::parse(shop_.read("out"));
  EXPECT_GE(json["rows"].size(), 1U) << json;
  EXPECT_GE(json["failures"].size(), 1U) << json;
}

}  // namespace
}  // namespace tumble::test
