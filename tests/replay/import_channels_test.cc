// Tables of any engine: columns under other names, channels, names for ids, poses alone, Euler angles, shapes; and two
// sessions that differ in a channel are never called identical.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "replay/measure/measure_log.h"
#include "replay/measure/metric_bound.h"
#include "tests/replay/imported_table.h"
#include "tumble/replay/compare.h"

namespace tumble::replay {
namespace {

/// Two links at rest for 70 steps, a knee that bends, a seed, a control.
struct Robot {
  double knee = 0;  // what is added to the angle at step 40
  std::string seed = "18446744073709551615";
  std::string control = "walk";
  [[nodiscard]] std::string table() const {
    std::string text =
        std::string("# dt: 0.01\nstep,id,") + kPose + kMotion + ",channel.knee,world.seed,world.control\n";
    for (int k = 0; k < 70; ++k) {
      for (const int id : {1, 2}) {
        const double angle = 0.01 * k + (id == 2 && k == 40 ? knee : 0);
        text += std::to_string(k) + ',' + std::to_string(id) + ',' + std::to_string(3 * id) +
                ",0,1,1,0,0,0,0,0,0,0,0,0," + (id == 1 ? "" : to_string(FieldValue(angle))) + ',' +
                (k < 30 ? "7" : seed) + ',' + control + '\n';
      }
    }
    return text;
  }
};

Divergence first_of(const std::string& a, const std::string& b, const std::map<std::string, double>& tolerances = {}) {
  LogReader in_a = must_import(a), in_b = must_import(b);
  Tolerances tolerance;
  for (const auto& [name, value] : tolerances) {
    EXPECT_TRUE(set_tolerance(tolerance, name, value, in_a.header().declared.channels).ok()) << name;
  }
  const Result<DiffReport> report = diff_logs(in_a, in_b, tolerance);
  EXPECT_TRUE(report.ok());
  return report->first.value_or(Divergence());
}

TEST(ImportChannels, AJointASeedAndAControlThatDifferAreFound) {
  const Robot robot;
  const Divergence knee = first_of(robot.table(), Robot{.knee = 1e-15}.table());
  EXPECT_EQ(knee.field, "channel.knee");
  EXPECT_EQ(knee.step, 40U);
  EXPECT_EQ(knee.body, 2U);
  EXPECT_GT(knee.ulps.value_or(0), 0U);
  const Divergence seed = first_of(robot.table(), Robot{.seed = "18446744073709551614"}.table());
  EXPECT_EQ(seed.field, "channel.seed");
  EXPECT_EQ(seed.step, 30U);
  EXPECT_EQ(seed.actual, FieldValue(std::uint64_t{18446744073709551614ULL}));
  const Divergence control = first_of(robot.table(), Robot{.control = "run"}.table());
  EXPECT_EQ(control.field, "channel.control");
  EXPECT_EQ(control.step, 0U) << "a value of the start counts";
  EXPECT_EQ(control.actual, FieldValue(std::string("run")));
  EXPECT_EQ(first_of(robot.table(), robot.table()).field, "");
  EXPECT_EQ(first_of(robot.table(), Robot{.knee = 1e-3}.table(), {{"knee", 1e-2}}).field, "");
  EXPECT_EQ(first_of(robot.table(), Robot{.knee = 1e-3}.table(), {{"channel.knee", 1e-4}}).field, "channel.knee");
}

TEST(ImportChannels, IdenticalSaysWhatWasComparedAndWhatWasNot) {
  const Robot robot;
  std::string other = robot.table();
  other.replace(other.find("channel.knee"), 12, "_knee");
  LogReader a = must_import(robot.table()), b = must_import(other);
  const Result<DiffReport> report = diff_logs(a, b);
  ASSERT_TRUE(report.ok());
  EXPECT_FALSE(report->identical()) << "nothing compared the knee";
  EXPECT_FALSE(report->computed_again());
  const auto says = [](const std::vector<std::string>& list, const std::string& part) {
    return std::ranges::any_of(list, [&](const std::string& line) { return line.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(says(report->scope.compared, "2 channels (control, seed)"));
  EXPECT_TRUE(says(report->scope.not_compared, "channel knee: only the first log has it"));
  EXPECT_TRUE(says(report->scope.not_compared, "column _knee"));
}

TEST(ImportChannels, NumbersOfOtherKindsAreComparedByTheirValues) {
  Robot robot;
  robot.seed = "8";
  Robot real = robot;
  real.seed = "8.5";
  const Divergence found = first_of(robot.table(), real.table());
  EXPECT_EQ(found.field, "channel.seed");
  EXPECT_EQ(found.step, 30U) << "7 and 7.0 are one number";
}

// A float64 would change the digits, and two numbers that differ would be the same.
TEST(ImportChannels, AMinusZeroKeepsItsSign) {
  const LogReader log = must_import(Robot{.control = "-0"}.table());
  const std::vector<Channel>& channels = log.header().declared.channels;
  const auto control = std::ranges::find(channels, "control", &Channel::name);
  ASSERT_NE(control, channels.end());
  EXPECT_EQ(control->type.kind, ChannelKind::kFloat64);
}

TEST(ImportChannels, WholeNumbersThatNoFloatHoldsAreRefused) {
  Robot robot;
  robot.seed = "18446744073709551617";
  EXPECT_NE(error_of(robot.table()).find("seed: found \"18446744073709551617\", wanted a whole number that a float64"),
            std::string::npos)
      << error_of(robot.table());
  robot.seed = "36893488147419103232";  // 2^65
  EXPECT_EQ(error_of(robot.table()), "no error");
  robot.seed = "18446744073709552000";  // 2^64 in JavaScript and Rust: the shortest digits, then zeros
  EXPECT_EQ(error_of(robot.table()), "no error");
}

TEST(ImportChannels, WholeNumbersOfPairsThatNoFloatHoldsAreRefused) {
  const std::string head = std::string("# dt: 0.01\nstep,id,") + kPose + kMotion + ",pair.force\n";
  const std::string rows = "0,1,5,6,1,1,0,0,0,0,0,0,0,0,0,2=0.5\n1,1,5,6,1,1,0,0,0,0,0,0,0,0,0,2=";
  EXPECT_EQ(error_of(head + rows + "18446744073709552000\n"), "no error");
  const std::string error = error_of(head + rows + "18446744073709551617\n");
  EXPECT_NE(error.find("pair.force: found \"18446744073709551617\", wanted a whole"), std::string::npos) << error;
}

TEST(ImportChannels, MetricsBoundThem) {
  LogReader log = must_import(Robot{.knee = 1}.table());
  const Result<Metrics> metrics = measure_log(log);
  ASSERT_TRUE(metrics.ok());
  const auto value = [&](const char* name) { return find_metric(name)->value(*metrics); };
  EXPECT_DOUBLE_EQ(value("channel.knee.max").value(), 1.4);
  EXPECT_DOUBLE_EQ(value("channel.knee.min").value(), 0);
  EXPECT_DOUBLE_EQ(value("channel.knee.change_max").value(), 1.01);
  EXPECT_DOUBLE_EQ(value("channel.knee.last").value(), 0.69);
  EXPECT_EQ(value("channel.seed.changes"), 1.0);
  EXPECT_EQ(value("channel.control.changes"), 0.0);
  EXPECT_EQ(value("channel.control.max"), std::nullopt);
  EXPECT_EQ(value("channel.hip.max"), std::nullopt);
  EXPECT_EQ(find_metric("channel.knee"), nullptr);
  EXPECT_EQ(find_metric("channel.knee.max"), find_metric("channel.knee.max"));
  const Result<MetricBound> bound = parse_metric_bound("channel.knee.max <= 0.7");
  ASSERT_TRUE(bound.ok()) << bound.error().message;
  EXPECT_FALSE(bound->holds(bound->metric->value(*metrics)));
  EXPECT_FALSE(parse_metric_bound("channel.seed.changes>=0").ok()) << "a bound that judges nothing";
}

TEST(ImportChannels, ColumnsHaveAnyNames) {
  ImportOptions options;
  ASSERT_TRUE(add_mapping(options.map, "position.x=px", "--map").ok());
  ASSERT_TRUE(add_mapping(options.map, "position.y = py", "--map").ok());
  ASSERT_TRUE(add_mapping(options.map, "id=link", "--map").ok());
  options.map.others_are_channels = true;
  std::string text = std::string("# dt: 0.01\nstep,link,") + kPose + kMotion + ",torque\n";
  text.replace(text.find("position.x"), 10, "px");
  text.replace(text.find("position.y"), 10, "py");
  LogReader log = must_import(text + "0,1,5,6,1,1,0,0,0,0,0,0,0,0,0,2.5\n", options);
  EXPECT_EQ((*log.read_step(0))->states.position[0], sim::Vec3(5, 6, 1));
  EXPECT_EQ(log.header().declared.channels.at(0).name, "torque");
  EXPECT_FALSE(add_mapping(options.map, "position.x=qx", "--map").ok());
  EXPECT_FALSE(add_mapping(options.map, "position.x", "--map").ok());
  ASSERT_TRUE(add_mapping(options.map, "position.z=pzz", "--map").ok());
  EXPECT_NE(error_of(text, options).find("--map: found no column \"pzz\" in t.csv"), std::string::npos);
}

TEST(ImportChannels, IdsAreNumbersOrNames) {
  const std::string head = std::string("# dt: 0.01\nstep,id,") + kPose + kMotion + "\n";
  const auto row = [](const std::string& step, const std::string& id) {
    return step + ',' + id + ",0,0,1,1,0,0,0,0,0,0,0,0,0\n";
  };
  LogReader log = must_import(head + row("0", "0") + row("0", "wheel fl") + row("0", "7") + row("1", "7") +
                              row("1", "0") + row("1", "wheel fl"));
  LogReader other = must_import(head + row("0", "7") + row("0", "wheel fl") + row("0", "0") + row("1", "0") +
                                row("1", "wheel fl") + row("1", "7"));
  const BodyStates states = (*log.read_step(1))->states;
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(states.id[0], 7U);
  EXPECT_EQ(log.bodies().text(7), "body 7");
  std::vector<std::string> names = {log.bodies().name(states.id[1]), log.bodies().name(states.id[2])};
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"0", "wheel fl"}));
  EXPECT_TRUE(diff_logs(log, other)->identical()) << "the order of rows names no body";
  EXPECT_NE(error_of(head + row("0", "-3")).find("id: found \"-3\""), std::string::npos);
}

TEST(ImportChannels, ABodyMayVanishAndComeBack) {
  const std::string head = std::string("# dt: 0.01\nstep,id,") + kPose + kMotion + "\n";
  const auto row = [](int step, int id, double x) {
    return std::to_string(step) + ',' + std::to_string(id) + ',' + to_string(FieldValue(x)) +
           ",0,1,1,0,0,0,0,0,0,0,0,0\n";
  };
  ImportOptions options;
  std::vector<std::string> warnings;
  options.warn = [&](const std::string& text) { warnings.push_back(text); };
  LogReader log = must_import(
      head + row(0, 1, 0) + row(0, 2, 1) + row(1, 1, 0) + row(2, 1, 0) + row(2, 2, 9) + row(3, 1, 0) + row(3, 2, 9),
      options);
  EXPECT_EQ((*log.read_step(1))->states.size(), 1U);
  EXPECT_EQ((*log.read_step(2))->states.position[1].x(), 9);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("body 2 comes back in step 2"), std::string::npos);
}

TEST(ImportChannels, PosesAloneGiveMotionThatNoVerdictCovers) {
  std::string pose = std::string("# dt: 0.5\nstep,id,") + kPose + "\n", full = pose;
  full.insert(full.size() - 1, kMotion);
  for (int k = 0; k < 4; ++k) {
    const std::string row = std::to_string(k) + ",1," + std::to_string(2 * k) + ",0,1,1,0,0,0";
    pose += row + "\n";
    full += row + ",4.5,0,0,0,0,1\n";
  }
  LogReader derived = must_import(pose), given = must_import(full);
  EXPECT_TRUE(derived.header().declared.velocity_derived);
  EXPECT_EQ((*derived.read_step(2))->states.velocity[0], sim::Vec3(4, 0, 0));
  EXPECT_EQ((*derived.read_step(0))->states.velocity[0], sim::Vec3(0, 0, 0));
  const Result<DiffReport> report = diff_logs(derived, given);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->identical()) << describe(*report->first);
  EXPECT_EQ(std::ranges::count_if(report->scope.not_compared,
                                  [](const std::string& s) { return s.find("derived") != std::string::npos; }),
            2);
  std::string moved = pose;
  moved.replace(moved.find("2,1,4,"), 6, "2,1,5,");
  LogReader other = must_import(moved);
  EXPECT_EQ(diff_logs(derived, other)->first->field, "position.x");
}

TEST(ImportChannels, EulerAnglesTurnByTheNamedConvention) {
  const std::string head = "step,id,position.x,position.y,position.z,euler.1,euler.2,euler.3\n0,1,0,0,1,90,0,90\n";
  const auto turned = [&](const std::string& order) {  // where the body's x axis points
    LogReader log = must_import("# dt: 0.1\n# euler: " + order + "\n" + head);
    return sim::Vec3(sim::axes_of((*log.read_step(0))->states.orientation[0])[0]);
  };
  EXPECT_LT(sim::length(sim::Vec3(turned("XYZ") - sim::Vec3(0, 0, 1))), 1e-15);  // about x, then the new z
  EXPECT_LT(sim::length(sim::Vec3(turned("xyz") - sim::Vec3(0, 1, 0))), 1e-15);  // about x, then the world's z
  EXPECT_NE(error_of("# dt: 0.1\n# euler: XXY\n" + head).find("euler: found \"XXY\", wanted three axes"),
            std::string::npos);
}

TEST(ImportChannels, ShapesAreKeptAndNamedByTheirHash) {
  const std::string mesh = ::testing::TempDir() + "tumble_import_pyramid.obj";
  std::ofstream(mesh) << "v 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
  const std::string head =
      std::string("# dt: 0.01\n# up: y\nstep,id,") + kPose + kMotion + ",shape,size.x,size.y,size.z\n";
  const auto row = [](int id, const std::string& shape) {
    return "0," + std::to_string(id) + ",0,0,1,1,0,0,0,0,0,0,0,0,0," + shape + ",1,3,1\n";
  };
  LogReader log = must_import(head + row(1, "sphere") + row(2, "capsule-y") + row(3, "mesh:" + mesh) + row(4, "box") +
                              row(5, "sphere"));
  EXPECT_EQ(to_string(*log.bodies().shape(1)), "sphere of radius 0.5 m");
  EXPECT_EQ(to_string(*log.bodies().shape(2)), "capsule of radius 0.5 m and half length 1 m along z");
  EXPECT_EQ(log.bodies().shape(3)->triangles.size(), 12U);
  EXPECT_EQ(log.bodies().shape(4), nullptr);
  EXPECT_EQ(log.bodies().shape_count(), 3U) << "a shape is stored once";
  EXPECT_NE(error_of(head + row(1, "blob")).find("shape: found \"blob\", wanted box, sphere"), std::string::npos);
  EXPECT_NE(error_of(head + row(1, "capsule-x")).find("at least as long as wide"), std::string::npos);
  EXPECT_NE(error_of(head + row(1, "mesh:none.obj")).find("none.obj: cannot be opened"), std::string::npos);
}

TEST(ImportChannels, WarnsOfAxesUnitsAndTimesThatDoNotFit) {
  const auto warnings_of = [](const std::string& header, double g, double speed, bool along_y) {
    std::string text = header + "step,id," + kPose + kMotion + "\n";
    for (int k = 0; k < 40; ++k) {
      const double t = 0.02 * k;
      const std::string height = to_string(FieldValue(50 - g * t * t / 2));
      const std::string fall = to_string(FieldValue(-speed * g * t));
      text += std::to_string(k) + ",1,0," + (along_y ? height + ",0" : "0," + height) + ",1,0,0,0," +
              (along_y ? "0," + fall + ",0" : "0,0," + fall) + ",0,0,0\n";
    }
    ImportOptions options;
    std::string all;
    options.warn = [&](const std::string& warning) { all += warning + "\n"; };
    EXPECT_TRUE(import(text, options).ok());
    return all;
  };
  EXPECT_EQ(warnings_of("# dt: 0.02\n", 9.81, 1, false), "");
  EXPECT_EQ(warnings_of("# dt: 0.02\n# up: y\n", 9.81, 1, true), "");
  EXPECT_NE(warnings_of("# dt: 0.02\n", 9.81, 1, true).find("accelerate along -y in "), std::string::npos);
  EXPECT_NE(warnings_of("# dt: 0.02\n", 981, 1, false).find("is \"gravity\", \"dt\" or the unit of length"),
            std::string::npos);
  EXPECT_NE(warnings_of("# dt: 0.02\n", 9.81, 60, false).find("as far in a step as their velocities say"),
            std::string::npos);
}

}  // namespace
}  // namespace tumble::replay
