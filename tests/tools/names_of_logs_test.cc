// Names that another engine gave to phases, bodies, channels and itself stay within the lines in which commands print
// them: a name with a line end must not write a line of its own, as a verdict.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <sstream>

#include "tests/support/program.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/shape.h"

namespace tumble::test {
namespace {

constexpr const char* kLine = "HOSTILE";

std::string hostile(const std::string& name) { return name + "\n" + kLine; }

/// Two bodies, six steps, every name with a line end. hash: of the phase in step 4; angle: of the channel in step 5.
void write_log(const Workshop& shop, const std::string& name, std::uint64_t hash, double angle) {
  replay::EngineDef def;
  def.engine = {hostile("engine"), hostile("1.0"), 53};
  def.phases = {hostile("solve"), "move"};
  def.declared.channels = {{"angle", {replay::ChannelKind::kFloat64, replay::ChannelScope::kBody}, "rad"},
                           {"pairs", {replay::ChannelKind::kText, replay::ChannelScope::kPair}, ""}};
  def.declared.bodies = {{1, "one", {}}, {2, "two", {}}};
  sim::SceneDef scene;
  scene.name = hostile("scene");
  scene.title = hostile("title");
  scene.world.dt = 0.01;
  for (const sim::BodyId id : {1U, 2U}) {
    sim::BoxDef box;
    box.id = id;
    box.position = {2.0 * static_cast<double>(id), 0, 1};
    scene.boxes.push_back(box);
  }
  Result<std::unique_ptr<replay::EngineLog>> made = replay::EngineLog::create(shop.path(name), def, scene);
  ASSERT_TRUE(made.ok()) << made.error().message;
  replay::EngineLog& log = **made;
  for (std::uint64_t k = 1; k <= 6; ++k) {
    for (const sim::BodyId id : {1U, 2U}) {
      replay::EngineState state;
      state.position = {2.0 * static_cast<double>(id), 0, 1 + (k >= 5 ? angle : 0)};
      ASSERT_TRUE(log.set_state(id, state).ok());
    }
    const std::uint64_t words[] = {k == 4 ? hash : 7, 8};
    ASSERT_TRUE(log.set_phase_hashes(words).ok());
    ASSERT_TRUE(log.set_value(0, k == 5 ? angle : 0.0, {1, 0}).ok());
    ASSERT_TRUE(log.set_value(1, hostile("text"), {1, 2}).ok());
    ASSERT_TRUE(log.add_note(hostile("note")).ok());
    ASSERT_TRUE(log.add_snapshot({}, "snapshot").ok());
    ASSERT_TRUE(log.end_step(0.01).ok());
  }
  ASSERT_TRUE(log.finish().ok());
}

/// The lines of an output that begin with what a name holds behind its line end.
std::string lines_of_names(const std::string& output) {
  std::istringstream lines(output);
  std::string found;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(' ') == line.find(kLine) && line.find(kLine) != std::string::npos) found += line + '\n';
  }
  return found;
}

TEST(NamesOfLogs, StayInTheirLines) {
  const Workshop shop;
  write_log(shop, "a.tumble", 7, 0);
  write_log(shop, "phase.tumble", 9, 0);
  write_log(shop, "angle.tumble", 7, 0.5);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"info", "a.tumble"},
                                             {"diff", "a.tumble", "phase.tumble"},
                                             {"diff", "a.tumble", "angle.tumble"},
                                             {"diff", "a.tumble", "angle.tumble", "--brief"},
                                             {"diff", "a.tumble", "angle.tumble", "--tolerance", "velocity=1"},
                                             {"diff", "a.tumble", "angle.tumble", "--apart", "0.1"},
                                             {"diff", "a.tumble", "phase.tumble", "--step", "4"},
                                             {"diff", "a.tumble", "angle.tumble", "--step", "5"},
                                             {"diff", "a.tumble", "angle.tumble", "phase.tumble"},
                                             {"diff", "a.tumble", "a.tumble"},
                                             {"bisect", "a.tumble", "phase.tumble"},
                                             {"bisect", "a.tumble", "angle.tumble"},
                                             {"measure", "a.tumble"},
                                             {"measure", "a.tumble", "--require", "drift_max<=0"},
                                             {"dump", "a.tumble", "--step", "3"},
                                             {"dump", "a.tumble", "--step", "3", "--body", "1"},
                                             {"dump", "a.tumble", "--steps", "1:3", "--csv"},
                                             {"dump", "a.tumble", "--steps", "1:3", "--body", "1"},
                                             {"blame", "a.tumble", "--body", "1"},
                                             {"replay", "a.tumble"},
                                             {"recover", "a.tumble", "-o", "r.tumble"},
                                             {"export", "a.tumble", "-o", "e.csv", "--bodies", "9"},
                                             {"export", "a.tumble", "-o", "e.npz"},
                                             {"render", "a.tumble", "--step", "99", "-o", "r.png"},
                                             {"bless", "n", "--from", "a.tumble", "--reason", "r", "--suite", "s"}}) {
    const Outcome outcome = shop.run(words);
    std::string command;
    for (const std::string& word : words) command += word + ' ';
    EXPECT_EQ(lines_of_names(outcome.out), "") << command << '\n' << outcome.out;
    EXPECT_EQ(lines_of_names(outcome.err), "") << command << '\n' << outcome.err;
    EXPECT_NE(outcome.exit, 4) << command << outcome.err;
  }
}

}  // namespace
}  // namespace tumble::test
