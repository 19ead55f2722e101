// What a table tells by mistake is imported and said: names that the log has otherwise, quaternions in another order,
// bodies that leap.
#include <algorithm>
#include <array>
#include <cmath>

#include "replay/arrays/array_joints.h"
#include "replay/arrays/mujoco_model.h"
#include "src/base/text.h"
#include "tests/replay/imported_table.h"
#include "tumble/replay/body_table.h"

namespace tumble::replay {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// What an import of this table warns of, a line each.
std::string warnings_of(const std::string& text, bool scalar_last = false) {
  ImportOptions options;
  options.scalar_last = scalar_last;
  std::string all;
  options.warn = [&](const std::string& warning) { all += warning + "\n"; };
  const Result<LogReader> log = import(text, options);
  EXPECT_TRUE(log.ok()) << log.error().message;
  return all;
}

/// Two bodies at rest in two steps; rows "step,id,more" each, with `columns` the names of more.
std::string resting(const std::string& columns, const std::vector<std::string>& rows) {
  std::string text = "# dt: 0.01\nstep,id," + columns + "," + kPose + "\n";
  for (const std::string& row : rows) text += row + ",0,0,1,1,0,0,0\n";
  return text;
}

TEST(ImportOddness, ANameThatChangesIsSaid) {
  const std::string later = resting("name", {"0,1,cup", "1,1,mug"});
  EXPECT_EQ(warnings_of(later),
            "t.csv:4:5: body 1 is called \"mug\", and the log keeps what its first row has, \"cup\"\n");
  EXPECT_EQ(must_import(later).bodies().name(1), "cup");
  EXPECT_TRUE(holds(warnings_of(resting("name", {"0,1,", "1,1,mug"})), "what its first row has, no name"));
  EXPECT_EQ(warnings_of(resting("name", {"0,1,cup", "1,1,"})), "") << "an empty cell says nothing";
  EXPECT_EQ(warnings_of(resting("name", {"0,1,cup", "1,1,cup"})), "");
}

TEST(ImportOddness, ANameThatTwoBodiesHaveIsSaid) {
  EXPECT_EQ(warnings_of(resting("name", {"0,1,cup", "0,2,cup", "0,3,cup"})),
            "t.csv:4:5: bodies 1 and 2 are both called \"cup\"; commands that look for one body want its number, and 1 "
            "body more likewise\n");
  EXPECT_EQ(warnings_of(resting("name", {"0,1,", "0,2,"})), "") << "no name is none";
}

TEST(ImportOddness, AnIdThatIsATextKeepsItsNameOrSaysSo) {
  const std::string empty = resting("name", {"0,cup,", "1,cup,"}), other = resting("name", {"0,cup,mug", "1,cup,mug"});
  EXPECT_EQ(warnings_of(empty), "");
  EXPECT_EQ(must_import(empty).bodies().bodies().begin()->second.name, "cup");
  EXPECT_TRUE(
      holds(warnings_of(other), "the body with the id \"cup\" has the name \"mug\" too; the log keeps that name"))
      << warnings_of(other);
  EXPECT_EQ(must_import(other).bodies().bodies().begin()->second.name, "mug");
  EXPECT_TRUE(holds(error_of(resting("name", {"0,cup,", "0,cup,"})), "found body \"cup\" twice in the step"));
}

TEST(ImportOddness, AShapeThatChangesIsAnError) {
  EXPECT_TRUE(holds(error_of(resting("shape", {"0,1,box", "1,1,sphere"})),
                    "t.csv:4:5: shape: found \"sphere\", wanted \"box\" as in line 3: a body keeps the value"));
  EXPECT_EQ(warnings_of(resting("shape", {"0,1,box", "1,1,"})), "");
}

TEST(ImportOddness, ATableOfAnotherDialectIsNamed) {
  EXPECT_EQ(error_of("step;id;position.x\n0;1;0,5\n"),
            "t.csv:1:1: found columns apart by semicolons, wanted commas, and points in numbers");
  EXPECT_EQ(error_of("step\tid\n0\t1\n"),
            "t.csv:1:1: found columns apart by tabs, wanted commas, and points in numbers");
  EXPECT_EQ(error_of("\"step\",\"id\"\n0,1\n"),
            "t.csv:1:1: found names in quotes, wanted names and cells without quotes");
}

TEST(ImportOddness, AJointWithoutANameIsSaid) {
  const auto said = [](const std::string& joints) {
    const auto model =
        read_mujoco_joints("<mujoco><worldbody><body>" + joints + "</body></worldbody></mujoco>", "m.xml");
    return model.ok() ? unnamed_joints(*model) : model.error().message;
  };
  EXPECT_EQ(said("<joint name='hip'/><joint/><joint/>"),
            "2 joints of --model without a name, called by the place in the model: joint 1 and so on");
  EXPECT_EQ(said("<joint name='hip'/><joint name='joint 1'/>"), "");
}

/// A body that turns about one axis, 0 x to 2 z, from 0.3 rad on, by 0.02 rad a step.
std::string turning(int axis, bool scalar_last, bool with_spins) {
  std::string text = "# dt: 0.01\nstep,id," + std::string(kPose) + (with_spins ? ",spin.x,spin.y,spin.z" : "") + "\n";
  for (int k = 0; k < 40; ++k) {
    const double half = (0.3 + 0.02 * k) / 2;
    std::vector<double> q = {0, 0, 0}, spin = {0, 0, 0};
    q.at(static_cast<std::size_t>(axis)) = std::sin(half);
    spin.at(static_cast<std::size_t>(axis)) = 2;
    q.insert(scalar_last ? q.end() : q.begin(), std::cos(half));
    text += std::to_string(k) + ",1,0,0,5";
    if (with_spins) q.insert(q.end(), spin.begin(), spin.end());
    for (const double number : q) text += ',' + exact(number);
    text += '\n';
  }
  return text;
}

// Where nothing tells how a body turns, numbers of a turn about x are those of a turn about z.
TEST(ImportOddness, QuaternionsWithTheScalarLastAreSaidWhateverTheAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool with_spins : {false, true}) {
      EXPECT_EQ(warnings_of(turning(axis, false, with_spins)), "") << axis << with_spins;
      if (axis == 0 && !with_spins) continue;
      const std::string said = warnings_of(turning(axis, true, with_spins));
      EXPECT_TRUE(holds(said, "in the order x y z w? wanted w x y z")) << axis << with_spins << said;
      EXPECT_EQ(std::ranges::count(said, '\n'), 1) << "no other remedy beside it: " << said;
    }
  }
}

/// A body that does not turn, or turns about one axis by its spins from this orientation on, w x y z.
std::string facing(const std::array<double, 4>& start, double rate, bool with_spins) {
  std::string text = "# dt: 0.01\nstep,id," + std::string(kPose) + (with_spins ? ",spin.x,spin.y,spin.z" : "") + "\n";
  for (int k = 0; k < 40; ++k) {
    const double c = std::cos(0.005 * rate * k), s = std::sin(0.005 * rate * k);
    const auto& [w, x, y, z] = start;  // turned further about z
    const std::array<double, 4> q = {c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w};
    text += std::to_string(k) + ",1,0,0,5";
    for (const double number : q) text += ',' + exact(number);
    text += (with_spins ? ",0,0," + exact(rate) : "") + "\n";
  }
  return text;
}

TEST(ImportOddness, ABodyThatFacesBackwardsIsNoWrongOrder) {
  const std::array<double, 4> about_x = {0, 1, 0, 0}, about_y = {0, 0, 1, 0}, about_z = {0, 0, 0, 1};
  for (const double rate : {0.0, 0.2, 0.5, 3.0}) {
    for (const bool with_spins : {false, true}) {
      EXPECT_EQ(warnings_of(facing(about_x, rate, with_spins)), "") << rate << with_spins;
      EXPECT_EQ(warnings_of(facing(about_y, rate, with_spins)), "") << rate << with_spins;
      const bool told = with_spins && rate > 0;  // else the numbers are those of a body that is not turned, too
      EXPECT_EQ(holds(warnings_of(facing(about_z, rate, with_spins)), "in the order x y z w?"), !told) << rate;
    }
  }
  std::string up = facing(about_y, 0, false);
  EXPECT_EQ(warnings_of(up.insert(0, "# up: y\n")), "") << "the numbers count as the engine tells them";
}

// A table of w x y z that was read as x y z w has the numbers x y z w under the names w x y z.
TEST(ImportOddness, ScalarLastThatWasGivenWronglyIsNotAdvised) {
  const std::string leave =
      "--scalar-last was given, and the numbers of the quaternion look like w x y z: leave it out";
  const std::array<double, 4> not_turned = {0, 1, 0, 0};  // 1 0 0 0, read as x y z w
  EXPECT_TRUE(holds(warnings_of(facing(not_turned, 0, false), true), leave));
  EXPECT_FALSE(holds(warnings_of(facing(not_turned, 0, false), true), "arrays: --scalar-last"));
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(warnings_of(turning(axis, false, true), true), "") << axis;
  EXPECT_EQ(warnings_of(facing({0, 0, 0, 1}, 0, false), true), "") << "backwards";
}

TEST(ImportOddness, VelocitiesOfAnotherDirectionAreSaid) {
  const auto moving_along_x = [](const std::string& velocity) {
    std::string text = "# dt: 0.01\nstep,id," + std::string(kPose) + ",velocity.x,velocity.y,velocity.z\n";
    for (int k = 0; k < 40; ++k) {
      text += std::to_string(k) + ",1," + exact(0.1 * k) + ",0,0,1,0,0,0," + velocity + '\n';
    }
    return warnings_of(text);
  };
  EXPECT_EQ(moving_along_x("10,0,0"), "");
  EXPECT_EQ(moving_along_x("0,10,0"),
            "bodies move in another direction than their velocities say, as far, in 39 states of 39; are the "
            "velocities in the body's axes, wanted the world's, or are columns swapped?\n");
  EXPECT_TRUE(holds(moving_along_x("0,40,0"), "bodies move 0.25 times as far in a step as their velocities say"));
}

/// A body that begins with this speed along x and accelerates steadily along x and z; m/s, m/s².
std::string driven(double speed, double x, double z, const std::string& gravity = "0 0 -9.81") {
  std::string text = "# dt: 0.01\n# gravity: " + gravity + "\nstep,id," + kPose + "\n";
  for (int k = 0; k < 40; ++k) {
    const double t = 0.01 * k;
    text += std::to_string(k) + ",1," + exact(speed * t + x * t * t / 2) + ",0," + exact(z * t * t / 2) + ",1,0,0,0\n";
  }
  return text;
}

TEST(ImportOddness, WhatSlidesIsNotInFreeFlight) {
  const std::string slope = "3.355 0 -9.218", another = "and gravity has another direction",
                    size = "accelerate by about";
  EXPECT_EQ(warnings_of(driven(9, -7, 0)), "") << "friction of 0.7";
  EXPECT_EQ(warnings_of(driven(0, 2.3, 0)), "") << "a push";
  EXPECT_EQ(warnings_of(driven(0, 1.6, 0, slope)), "") << "down a slope";
  EXPECT_TRUE(holds(warnings_of(driven(0, -9.81, 0)), another));
  EXPECT_TRUE(holds(warnings_of(driven(0, 0, 9.81)), another));
  EXPECT_TRUE(holds(warnings_of(driven(0, 0, -1.6)), size)) << "the moon";
  EXPECT_TRUE(holds(warnings_of(driven(0, 0, -981)), size)) << "centimetres";
  EXPECT_TRUE(holds(warnings_of(driven(0, -9810, 0)), size)) << "millimetres, and another axis";
}

/// A body that moves by 1 mm a step along x, and by `leap` more in step 20.
std::string moving(double leap, double stays, bool with_velocities, const std::string& size = "1,1,1") {
  std::string text = "# dt: 0.01\nstep,id,size.x,size.y,size.z," + std::string(kPose) +
                     (with_velocities ? ",velocity.x,velocity.y,velocity.z" : "") + "\n";
  for (int k = 0; k < 40; ++k) {
    const double x = 0.001 * k + (k >= 20 ? leap : 0) + (k > 20 ? stays * (k - 20) : 0);
    text +=
        std::to_string(k) + ",1," + size + "," + exact(x) + ",0,5,1,0,0,0" + (with_velocities ? ",0.1,0,0" : "") + "\n";
  }
  return text;
}

TEST(ImportOddness, ALeapOfOneStepIsSaid) {
  for (const bool with_velocities : {false, true}) {
    EXPECT_EQ(warnings_of(moving(50, 0, with_velocities)),
              "body 1 moves by 50 m in step 20, and by at most 0.001 m in the steps beside it; did the engine put it "
              "there, or is a row wrong?\n");
    EXPECT_EQ(warnings_of(moving(0.9, 0, with_velocities)), "") << "less than its edge";
    EXPECT_TRUE(holds(warnings_of(moving(0.9, 0, with_velocities, "0.1,0.2,0.1")), "moves by 0.901 m in step 20"));
  }
  EXPECT_EQ(warnings_of(moving(3, 3, false)), "") << "a hit: it goes on as fast";
}

TEST(ImportOddness, ALeapThereAndBackIsSaidWithTheNameOfTheBody) {
  const auto leaping = [](double there, double back) {
    std::string text = "# dt: 0.01\nstep,id,size.x,size.y,size.z," + std::string(kPose) + "\n";
    for (int k = 0; k < 40; ++k) {
      const double x = 0.001 * k + (k == 20 ? there : 0) + (k > 20 ? there - back : 0);
      text += std::to_string(k) + ",cup,1,1,1," + exact(x) + ",0,5,1,0,0,0\n";
    }
    return text;
  };
  const std::string said = warnings_of(leaping(50, 50));
  EXPECT_TRUE(holds(said,
                    " (\"cup\") moves by 50 m in step 20 and back in the next, and by at most 0.001 m in the "
                    "steps beside them; is the row of that step wrong?\n"))
      << said;
  EXPECT_EQ(warnings_of(leaping(0.9, 0.9)), "") << "less than its edge";
  EXPECT_EQ(warnings_of(leaping(50, -50)), "") << "on, not back";
  EXPECT_TRUE(holds(warnings_of(leaping(50, 0)), " (\"cup\") moves by 50 m in step 20, and"));
}

// Files that no program writes must not use up the stack, and the message says where they go wrong.
TEST(ImportOddness, AModelThatIsNestedTooDeepIsNamedByItsLine) {
  const auto nested = [](std::size_t depth, const std::string& tag) {
    std::string xml;
    for (std::size_t i = 0; i < depth; ++i) xml += "<" + tag + ">\n";
    for (std::size_t i = 0; i < depth; ++i) xml += "</" + tag + ">";
    return xml;
  };
  const auto model = [](const std::string& defaults, const std::string& bodies) {
    return read_mujoco_joints("<mujoco>\n" + defaults + "<worldbody>\n" + bodies + "</worldbody></mujoco>", "m.xml");
  };
  EXPECT_TRUE(model("", nested(900, "body")).ok());
  for (const char* tag : {"body", "frame"}) {
    const Result<std::vector<MujocoJoint>> deep = model("", nested(300'000, tag));
    ASSERT_FALSE(deep.ok()) << tag;
    EXPECT_EQ(deep.error().message,
              "m.xml:1001: found elements nested deeper than 1000, wanted a model of fewer bodies within one another");
  }
  EXPECT_FALSE(model(nested(300'000, "default"), "").ok());
  const Result<std::vector<MujocoJoint>> cut = read_mujoco_joints("<mujoco>\n<worldbody>\n<body", "m.xml");
  ASSERT_FALSE(cut.ok());
  EXPECT_TRUE(cut.error().message.starts_with("m.xml:3: found no model in MJCF")) << cut.error().message;
}

}  // namespace
}  // namespace tumble::replay
