// Tables of other engines' states: what they say, in whichever axes and units, and how they can be wrong.
#include "replay/import/csv/import_csv.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/replay/imported_table.h"
#include "tumble/replay/compare.h"

namespace tumble::replay {
namespace {

const std::string kColumns =
    "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
    "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z";

/// A table of one body: its header lines, and its rows after "step,id,".
std::string table(const std::string& header, const std::string& rows) { return header + kColumns + "\n" + rows; }

sim::Vec3 position(LogReader& log, std::uint64_t k, std::size_t row = 0) {
  return (*log.read_step(k))->states.position[row];
}

TEST(ImportCsv, ReadsWhatTheTableSays) {
  Result<LogReader> log = import(table("# engine: mine\r\n# version: 7\n#just a remark\n# dt: 0.5\n# scene: drop\n",
                                       "0,4, 1,2,3 ,1,0,0,0,0,0,-1,0,0,0\r\n\n1,4,1,2,2.5,1,0,0,0,0,0,+1e-1,0,0,9\n"));
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(to_string(*log->header().engine), "mine 7");
  EXPECT_EQ(log->header().scene.name, "drop");
  ASSERT_EQ(log->last_step(), 1U);
  const StepRecord last = **log->read_step(1);
  EXPECT_EQ(last.dt, 0.5);
  EXPECT_EQ(last.states.id, std::vector<sim::BodyId>{4});
  EXPECT_EQ(last.states.position[0], sim::Vec3(1, 2, 2.5));
  EXPECT_EQ(last.states.velocity[0], sim::Vec3(0, 0, 0.1));
  EXPECT_EQ(last.states.spin[0], sim::Vec3(0, 0, 9));
}

TEST(ImportCsv, AxesAndUnitsBecomeOurs) {
  const std::string row = "0,1,100,200,-300,0.4,0.2,0.4,0.8,1,2,3,4,5,6\n";
  Result<LogReader> up =
      import(table("# dt: 0.1\n# up: y\n# length: cm\n# gravity: 0 -981 0\n# size: 100 200 300\n", row));
  ASSERT_TRUE(up.ok()) << up.error().message;
  EXPECT_EQ(position(*up, 0), sim::Vec3(1, 3, 2));
  EXPECT_NEAR(up->header().scene.world.gravity.z(), -9.81, 1e-12);
  EXPECT_EQ(up->header().scene.boxes[0].size, sim::Vec3(1, 3, 2));
  const BodyStates states = (*up->read_step(0))->states;
  EXPECT_EQ(states.orientation[0], (sim::Quat{0.4, 0.2, -0.8, 0.4}));
  EXPECT_EQ(states.spin[0], sim::Vec3(4, -6, 5)) << "spins have no length";
  Result<LogReader> left = import(table("# dt: 0.1\n# up: y\n# handed: left\n", row));
  ASSERT_TRUE(left.ok()) << left.error().message;
  EXPECT_EQ(position(*left, 0), sim::Vec3(100, -300, 200));
  EXPECT_EQ((*left->read_step(0))->states.spin[0], sim::Vec3(-4, -6, -5)) << "a mirror turns spins round";
  Result<LogReader> x = import(table("# dt: 0.1\n# up: x\n", row));
  EXPECT_EQ(position(*x, 0), sim::Vec3(200, -300, 100));
}

TEST(ImportCsv, TheLogKeepsAxesUnitAndColumnsPassedOver) {
  const std::string columns = "_joint," + kColumns + ",_heat\n";
  Result<LogReader> log =
      import("# dt: 0.1\n# up: y\n# handed: left\n# length: cm\n" + columns + "7,0,1,0,1,0,1,0,0,0,0,0,0,0,0,0,300\n");
  ASSERT_TRUE(log.ok()) << log.error().message;
  ASSERT_TRUE(log->header().table);
  EXPECT_EQ(log->header().table->passed_over, (std::vector<std::string>{"_joint", "_heat"}));
  EXPECT_EQ(log->header().axes(), (EngineAxes{1, true, 0.01}));
  EXPECT_EQ(to_string(log->header().axes()), "y up, left-handed, cm");
  EXPECT_EQ(to_string(*log->header().engine), "CSV");
  Result<LogReader> plain = import(table("# dt: 0.1\n", "0,1,0,1,0,1,0,0,0,0,0,0,0,0,0\n"));
  ASSERT_TRUE(plain.ok()) << plain.error().message;
  EXPECT_FALSE(plain->header().table) << "a table in our axes says nothing more, and its log keeps its bytes";
}

TEST(ImportCsv, Float32IsReadAsFloat) {
  const std::string row = "0,1,0.1,0,0,1,0,0,0,0,0,0,0,0,0\n";
  Result<LogReader> log = import(table("# dt: 0.1\n# precision: float32\n", row));
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(position(*log, 0).x(), static_cast<double>(0.1F));
  EXPECT_EQ(log->header().engine->precision_bits, kBinary32Bits);
}

TEST(ImportCsv, BodiesComeAndGo) {
  const std::string rest = ",0,0,1,1,0,0,0,0,0,0,0,0,0\n";
  Result<LogReader> log = import(table("# dt: 0.1\n", "10,1" + rest + "20,1" + rest + "20,5" + rest + "30,5" + rest));
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(log->last_step(), 2U) << "the first step of the table is state 0";
  EXPECT_EQ(sim::name_of((*log->read_step(1))->inputs.at(0)), std::string("throw"));
  EXPECT_EQ(sim::name_of((*log->read_step(2))->inputs.at(0)), std::string("remove"));
  EXPECT_EQ((*log->read_step(2))->dt, 1.0) << "ten steps of the engine";
}

TEST(ImportCsv, TimeGivesDt) {
  std::string text = table("", "0.5,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n0.75,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n");
  text.replace(0, 4, "time");
  Result<LogReader> log = import(text);
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ((*log->read_step(1))->dt, 0.25);
}

TEST(ImportCsv, OptionalColumnsSayWhatABodyIs) {
  std::string text = table("# dt: 0.1\n", "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0,2,3,4,7,0.9,1,5,6,x\n");
  text.insert(text.find("\n0,1"), ",size.x,size.y,size.z,mass,friction,static,row,column,_ignored");
  Result<LogReader> log = import(text);
  ASSERT_TRUE(log.ok()) << log.error().message;
  const sim::BoxDef& box = log->header().scene.boxes.at(0);
  EXPECT_EQ(box.size, sim::Vec3(2, 3, 4));
  EXPECT_EQ(box.mass, 7);
  EXPECT_EQ(box.material.friction, 0.9);
  EXPECT_TRUE(box.is_static);
  EXPECT_EQ(box.origin, (sim::Origin{sim::Origin::Kind::kGrid, 0, 5, 6}));
}

/// A log as `dump --csv` prints it.
std::string dumped(LogReader& log) {
  std::string text = kColumns + ",frozen\n";
  for (std::uint64_t k = 0; k <= log.last_step(); ++k) {
    const BodyStates s = (*log.read_step(k))->states;
    for (std::size_t i = 0; i < s.size(); ++i) {
      text += std::to_string(k) + ',' + std::to_string(s.id[i]);
      for (const double v : {s.position.x[i], s.position.y[i], s.position.z[i], s.orientation.w[i], s.orientation.x[i],
                             s.orientation.y[i], s.orientation.z[i], s.velocity.x[i], s.velocity.y[i], s.velocity.z[i],
                             s.spin.x[i], s.spin.y[i], s.spin.z[i]}) {
        text += ',' + to_string(FieldValue(v));
      }
      text += s.frozen[i] != 0 ? ",1\n" : ",0\n";
    }
  }
  return text;
}

TEST(ImportCsv, WhatWasDumpedComesBackWithEqualStates) {
  Result<LogReader> ours = open_memory(record_to_memory(scene_with_inputs()));
  ASSERT_TRUE(ours.ok());
  ImportOptions options;
  Result<SessionLike> like = session_like(*ours);
  ASSERT_TRUE(like.ok());
  options.like = *std::move(like);
  // The scene changes its dt on the way, which a table says with a column time.
  std::string text = dumped(*ours);
  double time = 0;
  std::string timed = "time," + text.substr(0, text.find('\n') + 1);
  std::uint64_t last = 0;
  for (std::size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1) {
    const std::uint64_t step = std::strtoull(text.c_str() + at, nullptr, 10);
    if (step != last) time += (*ours->read_step(step))->dt;
    last = step;
    timed += to_string(FieldValue(time)) + ',' + text.substr(at, text.find('\n', at) + 1 - at);
  }
  Result<LogReader> log = import(timed, options);
  ASSERT_TRUE(log.ok()) << log.error().message;
  ASSERT_EQ(log->last_step(), ours->last_step());
  for (std::uint64_t k = 0; k <= log->last_step(); ++k) {
    ASSERT_TRUE(same_bits((*log->read_step(k))->states, (*ours->read_step(k))->states)) << "step " << k;
    if (k == 0) continue;
    ASSERT_NEAR((*log->read_step(k))->dt, (*ours->read_step(k))->dt, 1e-12) << "step " << k;
  }
}

TEST(ImportCsv, DiffOfTheRoundTripIsIdentical) {
  Result<LogReader> ours = open_memory(record_to_memory(small_scene()));
  ASSERT_TRUE(ours.ok());
  ImportOptions options;
  options.settings = {"dt: " + to_string(FieldValue(ours->header().scene.world.dt))};
  Result<LogReader> log = import(dumped(*ours), options);
  ASSERT_TRUE(log.ok()) << log.error().message;
  const Result<DiffReport> report = diff_logs(*ours, *log);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->identical()) << describe(*report->first);
}

/// A body that falls by 9.81 m/s² in steps of 0.01 s, its velocity times `factor`, and what the import says of it.
std::string misfits(const std::string& header, double factor = 1) {
  std::string rows, warnings;
  for (int k = 0; k < 20; ++k) {
    const double v = -0.0981 * k, z = 100 - 0.000981 * k * (k + 1) / 2;
    rows +=
        std::to_string(k) + ",1,0,0," + std::to_string(z) + ",1,0,0,0,0,0," + std::to_string(v * factor) + ",0,0,0\n";
  }
  ImportOptions options;
  options.warn = [&](const std::string& warning) { warnings += warning + '\n'; };
  EXPECT_TRUE(import(table(header, rows), options).ok());
  return warnings;
}

TEST(ImportCsv, WhatDoesNotFitIsSaidWithTheRemedy) {
  const auto says = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(misfits("# dt: 0.01\n"), "");
  EXPECT_TRUE(
      says(misfits("# dt: 0.01\n# gravity: 0 0 -981\n"), "but gravity is 981 m/s^2; is \"gravity\", \"dt\" or"));
  EXPECT_TRUE(says(misfits("# dt: 0.02\n"), "is \"gravity\", \"dt\" or the unit of length another one?"));
  EXPECT_TRUE(says(misfits("# dt: 0.01\n# up: y\n# gravity: 0 -9.81 0\n"), "accelerate along -z"));
  EXPECT_TRUE(says(misfits("# dt: 0.01\n", -1), "bodies move against their velocities in "));
  EXPECT_TRUE(says(misfits("# dt: 0.01\n", 57.3), "times as far in a step as their velocities say"));
  EXPECT_TRUE(says(misfits("# dt: 0.01\n# gravity: 0 0 0\n"), "but gravity is 0 m/s^2"));
  EXPECT_TRUE(
      says(misfits("# dt: 0.01\n# up: y\n# gravity: 0 0 -9.81\n"),
           "gravity points along -z, but the axes are y up, right-handed, m; is \"up\" missing, or another one?"));
  EXPECT_TRUE(says(misfits("# dt: 0.01\n# gravity: 0 0 9.81\n"), "accelerate along -z"));
}

TEST(ImportCsv, ErrorsNameFileLineAndColumn) {
  const std::string good = "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n";
  const auto expect = [](const std::string& text, const std::string& wanted, const ImportOptions& options = {}) {
    EXPECT_NE(error_of(text, options).find(wanted), std::string::npos) << error_of(text, options);
  };
  expect("", "t.csv:1:1: found no line with the names");
  expect(table("", good), "t.csv:1:1: found neither a column time or dt nor a line \"# dt: …\"");
  expect(table("# dt: 0.1\n# upp: y\n", good), "t.csv:2:1: found key \"upp\", wanted one of engine, version");
  expect(table("# dt: soon\n", good), "t.csv:1:1: dt: found \"soon\", wanted a number of seconds > 0");
  expect(table("# dt: 0.1\n", good + "1,1,0,0,1x,1,0,0,0,0,0,0,0,0,0\n"),
         "t.csv:4:9: position.z: found \"1x\", wanted a number");
  expect(table("# dt: 0.1\n", "0,1,0,0\n"), "t.csv:3:1: found 4 cells, wanted 15");
  expect(table("# dt: 0.1\n", "0,-1,0,0,1,1,0,0,0,0,0,0,0,0,0\n"),
         "t.csv:3:3: id: found \"-1\", wanted a whole number");
  expect(table("# dt: 0.1\n", good + good), "t.csv:3:1: found body 1 twice in the step");
  expect(table("# dt: 0.1\n", good + "2,1" + good.substr(3) + "3,1" + good.substr(3)),
         "t.csv:5:1: step: found 3 after 2, wanted 4: steps are equally far apart; one that is missing is a longer "
         "step with a column "
         "time in place of step");
  expect(table("# dt: 0.1\n", "5,1" + good.substr(3) + good), "t.csv:4:1: step: found 0 after 5, wanted a later one");
  expect(table("# dt: 0.1\n", ""), "found no row");
  expect(table("# dt: 9\n", good + "1,1" + good.substr(3)), "t.csv:4:1: found a step of 9 s");
  expect(table("# dt: 0.1\n# mass: -1\n", good), "t.csv:4:3: body 1: found a mass of -1");
  std::string text = table("# dt: 0.1\n", good);
  text.replace(text.find("position.x"), 10, "position.q");
  expect(text,
         "t.csv:2:9: found column \"position.q\", wanted step, id, position.x or another of the format (is position.");
  text = table("# dt: 0.1\n", good);
  text.replace(text.find("velocity.x"), 10, "_");
  expect(text, "t.csv:2:1: found 2 columns of velocity, wanted 3");
  ImportOptions options;
  options.settings = {"up: w"};
  expect(table("# dt: 0.1\n", good), "\"up: w\": up: found \"w\", wanted x, y or z", options);
}

TEST(ImportCsv, ACameraIsJudgedInMetresAndAtItsPlace) {
  const std::string row = "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n";
  const Result<LogReader> far = import(table("# dt: 0.1\n# length: mm\n# camera.position: 2e7 0 0\n", row));
  ASSERT_TRUE(far.ok()) << far.error().message;
  EXPECT_EQ(far->header().scene.camera.position, sim::Vec3(2e4, 0, 0));
  EXPECT_NE(error_of(table("# dt: 0.1\n# length: 1000\n# camera.position: 5e5 0 0\n", row))
                .find("t.csv:3:1: camera position: found 5e+08, 0, 0, wanted three coordinates up to 1e6 m"),
            std::string::npos)
      << error_of(table("# dt: 0.1\n# length: 1000\n# camera.position: 5e5 0 0\n", row));
  ImportOptions options;
  options.settings = {"camera.fov: 500"};
  EXPECT_EQ(error_of(table("# dt: 0.1\n# camera.target: 0 0 1\n", row), options),
            "\"camera.fov: 500\": camera fov: found 500, wanted a number from 1 to 170");
  options.settings = {"camera.target: 12 -16 8"};
  EXPECT_TRUE(error_of(table("# dt: 0.1\n", row), options).starts_with("\"camera.target: 12 -16 8\": camera"));
}

TEST(ImportCsv, NoLogIsTouchedWhereTheTableIsWrong) {
  bool asked = false;
  const auto sink = [&]() -> Result<std::unique_ptr<ByteSink>> {
    asked = true;
    return bad_input("no");
  };
  const std::string row = ",1,0,0,1,1,0,0,0,0,0,0,0,0,0\n";
  EXPECT_FALSE(import_csv(table("# dt: 0.1\n", "0" + row + "1" + row + "1,x\n"), "t.csv", sink).ok());
  EXPECT_FALSE(asked);
}

}  // namespace
}  // namespace tumble::replay
