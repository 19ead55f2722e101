// Bullet, ODE and MuJoCo with the recorder linked in: one planted change of a parameter, and the first difference
// named.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

struct Engine {
  std::string name;
  std::string demo;
};

std::vector<Engine> engines() {
  std::vector<Engine> all;
#ifdef BULLET_DEMO
  all.push_back({"Bullet", BULLET_DEMO});
#endif
#ifdef ODE_DEMO
  all.push_back({"ODE", ODE_DEMO});
#endif
#ifdef MUJOCO_DEMO
  all.push_back({"MuJoCo", MUJOCO_DEMO});
#endif
  return all;
}

class Engines : public testing::Test {
 protected:
  void SetUp() override {
    if (engines().empty()) GTEST_SKIP() << "no other engine is here; tools/setup.sh --with peers";
  }

  /// Runs a demo in the workshop; its exit status.
  [[nodiscard]] int demo(const Engine& engine, const std::string& arguments) const {
    const std::string command = "cd '" + shop_.path("") + "' && '" + engine.demo + "' " + arguments + " > demo.txt";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void record_as_log(const Engine& engine, const std::string& name, const std::string& arguments) const {
    ASSERT_EQ(demo(engine, name + ".tumblestream " + arguments), 0) << engine.name;
    const Outcome imported = shop_.run({"import", name + ".tumblestream", "-o", name + ".tumble"});
    ASSERT_EQ(imported.exit, 0) << engine.name << imported.err;
  }

  Workshop shop_;
};

TEST_F(Engines, TwoRunsAlikeAreIdentical) {
  for (const Engine& engine : engines()) {
    record_as_log(engine, "one", "");
    record_as_log(engine, "two", "");
    const Outcome diff = shop_.run({"diff", "one.tumble", "two.tumble"});
    EXPECT_EQ(diff.exit, 0) << engine.name << diff.out << diff.err;
    EXPECT_EQ(shop_.run({"info", "one.tumble"}).exit, 0) << engine.name;
    EXPECT_EQ(demo(engine, "--verify one.tumblestream"), 0) << engine.name << shop_.read("demo.txt");
    EXPECT_NE(shop_.read("demo.txt").find("240 steps verified"), std::string::npos) << shop_.read("demo.txt");
  }
}

TEST_F(Engines, AChangedParameterIsNamedByStepBodyAndField) {
  for (const Engine& engine : engines()) {
    record_as_log(engine, "one", "");
    record_as_log(engine, "changed", "--friction 0.501");
    const Outcome diff = shop_.run({"diff", "one.tumble", "changed.tumble", "--json"});
    ASSERT_EQ(diff.exit, 1) << engine.name << diff.err;
    const auto first = nlohmann::json::parse(diff.out)["first"];
    EXPECT_GT(first["step"], 0) << engine.name << diff.out;
    EXPECT_GT(first["body"], 0) << engine.name << diff.out;
    const std::string field = first["field"];
    EXPECT_FALSE(field.empty()) << engine.name << diff.out;

    // The recorder itself finds the same place while the engine runs.
    ASSERT_EQ(demo(engine, "--friction 0.501 --verify one.tumblestream"), 1) << engine.name;
    const std::string place = "step " + std::to_string(first["step"].get<int>()) + ", body " +
                              std::to_string(first["body"].get<int>()) + ": state: " + field;
    EXPECT_NE(shop_.read("demo.txt").find(place), std::string::npos) << place << '\n' << shop_.read("demo.txt");
  }
}

}  // namespace
}  // namespace tumble::test
