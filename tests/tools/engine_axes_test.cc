// An engine whose y points up and that computes in floats: every command names its fields, contacts and axes as the
// engine does, counts ULPs of floats, and warns of what does not fit what the engine says of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "replay/view/phase_partings.h"
#include "tests/tools/float_engine.h"
#include "tests/tools/json_output.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

TEST(EngineAxes, EveryCommandNamesOneFieldAlike) {
  const Workshop shop;
  recorded(shop, "a");
  recorded(shop, "b", heavier());
  write_project(shop, "b");
  const std::vector<std::vector<std::string>> commands = {
      {"diff", "a.tumble", "b.tumble"}, {"bisect", "a.tumble", "b.tumble"}, {"replay", "a.tumble"}};
  ordered_json values;
  for (std::vector<std::string> command : commands) {
    const std::string text = shop.run(command).out;
    EXPECT_TRUE(says(text, "position.y")) << command.front() << text;
    EXPECT_FALSE(says(text, "position.z")) << command.front() << text;
    EXPECT_TRUE(says(text, "1  (ball)")) << command.front() << text;
    command.emplace_back("--json");
    const ordered_json first = parsed(shop.run(command))["first"];
    EXPECT_EQ(first["field"], "position.y") << command.front();
    if (values.is_null()) values = first["actual"];
    EXPECT_EQ(first["actual"], values) << command.front();
    EXPECT_LT(first["ulps"], 100) << "floats: " << command.front();
  }
  const ordered_json step = parsed(shop.run({"diff", "a.tumble", "b.tumble", "--step", "20", "--json"}));
  for (const ordered_json& field : step["bodies"][0]["fields"]) EXPECT_LT(field["ulps"], 100000) << field;
}

// A line of the header for one body and one for several name places alike.
TEST(EngineAxes, BodiesOfOneLineOfTheHeaderAreNamedByTheSameAxes) {
  const Workshop shop;
  for (const std::string z : {"0.25", "0.5"}) {
    std::string table =
        "# up: y\n# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
        "orientation.y,orientation.z\n";
    for (const std::string row : {"0,1,0,", "0,2,3,", "1,1,0,", "1,2,3,"})
      table.append(row).append("7,").append(z).append(",1,0,0,0\n");
    shop.write("at" + z + ".csv", table);
    ASSERT_EQ(shop.run({"import", "at" + z + ".csv"}).exit, 0);
  }
  const std::string text = shop.run({"diff", "at0.25.tumble", "at0.5.tumble"}).out;
  EXPECT_TRUE(says(text, "header: position.z of bodies 1, 2: 0.25 → 0.5\n")) << text;
}

TEST(EngineAxes, ABodyOnTheGroundIsOnItInAxesOfEitherHand) {
  const Workshop shop;
  for (const std::string hand : {"left", "right"}) {
    for (const std::string up : {"x", "y", "z"}) {
      std::string rows;
      for (int k = 0; k < 40; ++k) {
        const std::string height = std::to_string(300 - 0.04905 * k * k);
        rows += std::to_string(k) + ",1," + (up == "x" ? height : "0") + "," + (up == "y" ? height : "0") + "," +
                (up == "z" ? height : "0") + ",1,0,0,0\n";
      }
      std::string table = "# up: ";
      table.append(up).append("\n# handed: ").append(hand).append("\n# length: cm\n# dt: 0.01\n# size: 100 100 100\n");
      table.append(
          "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z\n");
      shop.write("fall.csv", table.append(rows));
      ASSERT_EQ(shop.run({"import", "fall.csv"}).exit, 0) << up << hand;
      const ordered_json found = parsed(shop.run({"measure", "fall.tumble", "--json"}));
      EXPECT_EQ(found["stacking"]["lost"], 0) << up << hand;
      EXPECT_NEAR(found["stacking"]["top_drop_max"].get<double>(), 74.6, 0.1) << up << hand;
      EXPECT_EQ(found["stacking"]["ground_penetration_peak"], 0) << up << hand;
    }
  }
}

TEST(EngineAxes, ContactsAreInTheEnginesAxesAndUnit) {
  const Workshop shop;
  for (const int left : {0, 1}) {
    FloatEngine engine;
    engine.left_handed = left;
    engine.metres = 0.01;
    engine.told_gravity = -9.81;
    recorded(shop, "cm" + std::to_string(left), engine);
    const ordered_json contact =
        parsed(shop.run({"dump", "cm" + std::to_string(left) + ".tumble", "--step", "3", "--json"}))["contacts"][0];
    constexpr std::array<double, 3> kPlace = {10, 30, 20};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(contact["position"][k].get<double>(), kPlace.at(k), 1e-12) << contact;
      EXPECT_EQ(contact["normal"][k], k == 1 ? 1.0 : 0.0) << contact;
    }
    EXPECT_NEAR(contact["depth"].get<double>(), 0.5, 1e-12);
  }
}

TEST(EngineAxes, ContactsThatAreTheFirstDifferenceAreSaidToDiffer) {
  const Workshop shop;
  recorded(shop, "a");
  FloatEngine moved;
  moved.contact_y = 31;
  recorded(shop, "b", moved);
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_TRUE(says(text.out, "contact.position.y")) << text.out;
  EXPECT_TRUE(says(text.out, "1 m, 524288 ULPs")) << text.out;
  EXPECT_TRUE(says(text.out, "differ from step 1 on, first of body 1 and the ground: position")) << text.out;
  EXPECT_FALSE(says(text.out, "the same")) << text.out;
  EXPECT_EQ(parsed(shop.run({"diff", "a.tumble", "b.tumble", "--json"}))["aftermath"]["contacts_from"], 1);
  const Outcome step = shop.run({"diff", "a.tumble", "b.tumble", "--step", "3"});
  EXPECT_TRUE(says(step.out, "contacts, pair body 1 (ball) and the ground, contact.position.y")) << step.out;
  FloatEngine none;
  none.contact_y = std::numeric_limits<double>::quiet_NaN();
  recorded(shop, "c", none);
  recorded(shop, "d", none);
  EXPECT_FALSE(says(shop.run({"diff", "c.tumble", "d.tumble"}).out, "contacts of the engine"));
  const Outcome gone = shop.run({"diff", "a.tumble", "c.tumble"});
  EXPECT_TRUE(says(gone.out, "different in what was recorded: only a.tumble has contacts")) << gone.out;
  recorded(shop, "e");
  EXPECT_TRUE(says(shop.run({"diff", "a.tumble", "e.tumble"}).out, "contacts of the engine"));
}

// Contacts that nobody told, or that nobody compares, are not said to be none or the same.
TEST(EngineAxes, ContactsThatAreNotComparedAreSaidToBeSo) {
  const Workshop shop;
  FloatEngine silent = heavier(), other = heavier();
  silent.contact_y = std::numeric_limits<double>::quiet_NaN();
  other.name = "other";
  recorded(shop, "a");
  recorded(shop, "b", other);
  const std::string two = shop.run({"diff", "a.tumble", "b.tumble"}).out;
  EXPECT_TRUE(says(two, "contacts                  not compared")) << two;
  recorded(shop, "c", silent);
  silent.gravity = -9.83F;
  recorded(shop, "d", silent);
  EXPECT_TRUE(says(shop.run({"diff", "c.tumble", "d.tumble"}).out, "contacts                  none in either log"));
}

TEST(EngineAxes, OneUlpIsOne) {
  const Workshop shop;
  const std::string names =
      "# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
      "orientation.y,orientation.z\n";
  shop.write("a.csv", names + "0,1,1,0,5,1,0,0,0\n1,1,1,0,5,1,0,0,0\n");
  shop.write("b.csv", names + "0,1,1,0,5,1,0,0,0\n1,1,1.0000000000000002,0,5,1,0,0,0\n");
  for (const char* table : {"a.csv", "b.csv"}) EXPECT_EQ(shop.run({"import", table}).exit, 0);
  const std::string text = shop.run({"diff", "a.tumble", "b.tumble"}).out;
  EXPECT_TRUE(says(text, "2.22e-16 m, 1 ULP\n")) << text;
}

TEST(EngineAxes, PhasesOfTwoLogsOfOneEngineAreCompared) {
  const Workshop shop;
  recorded(shop, "a");
  recorded(shop, "b", heavier());
  Result<replay::LogReader> a = replay::LogReader::open(shop.path("a.tumble"));
  Result<replay::LogReader> b = replay::LogReader::open(shop.path("b.tumble"));
  ASSERT_TRUE(a.ok() && b.ok());
  const Result<replay::PhasePartings> found = replay::phase_partings(*a, *b, 1, {});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->phases.size(), 2U);
  EXPECT_TRUE(found->phases[0].step.has_value());
  EXPECT_FALSE(found->phases[1].step.has_value());
}

TEST(EngineAxes, ACaseIsJudgedInThem) {
  const Workshop shop;
  recorded(shop, "a");
  FloatEngine other = heavier();
  other.contact_y = 31;
  recorded(shop, "b", other);
  write_project(shop, "a");
  const auto write_case = [&](const std::string& axis) {
    shop.write("golden/cases/fall/level.txt", "one ball\n");
    shop.write("golden/cases/fall/metrics.toml",
               "[engine]\nfiles = [\"level.txt\"]\n[[metric]]\nname = \"lateral_max\"\nmax = 1\naxis = \"" + axis +
                   "\"\nwhy = \"it falls straight\"\n");
  };
  write_case("z");
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err << blessed.out;
  EXPECT_EQ(shop.run({"check"}).exit, 0) << "z is horizontal";
  write_project(shop, "b");
  const Outcome moved = shop.run({"check", "--report", "r", "--annotate", "github"});
  EXPECT_EQ(moved.exit, 1);
  EXPECT_TRUE(says(moved.out, "channels and contacts that differ in step 1: contacts")) << moved.out;
  const std::string annotation = moved.out.substr(std::min(moved.out.find("::error"), moved.out.size()));
  EXPECT_TRUE(says(annotation, "; first difference: step 1, substep 0, phase move; at step 1, 1 of 1 body differs"))
      << annotation;
  EXPECT_FALSE(says(annotation, "largest distance")) << "the summary has it: " << annotation;
  EXPECT_FALSE(says(shop.read("r/index.html"), "> · 1 body")) << "a case without a title";
  EXPECT_TRUE(says(moved.out, "position.y") || says(moved.out, "velocity.y")) << moved.out;
  EXPECT_FALSE(says(moved.out, "position.z") || says(moved.out, "velocity.z")) << moved.out;
  const std::string track = shop.read("r/cases/fall/expected_track.csv");
  EXPECT_TRUE(track.starts_with("# axes: y up, right-handed, m\nstep,id,x_m,y_m,z_m\n0,1,1.0")) << track.substr(0, 90);
  EXPECT_TRUE(says(track, "0,1,1.000000,10.000000,3.000000")) << track.substr(0, 90);
  write_project(shop, "a");
  write_case("y");
  const Outcome up = shop.run({"check"});
  EXPECT_EQ(up.exit, 1);
  EXPECT_TRUE(says(up.out, "found y, which points up in the engine's axes (y up, right-handed, m); wanted x or z"))
      << up.out;
}

TEST(EngineAxes, WhatDoesNotFitIsSaidWithTheRemedy) {
  const Workshop shop;
  int count = 0;
  const auto import = [&](const FloatEngine& engine) { return recorded(shop, "w" + std::to_string(++count), engine); };
  EXPECT_FALSE(says(import({}), "free flight"));
  FloatEngine engine;
  engine.told_gravity = -981;
  EXPECT_TRUE(says(import(engine), "but gravity is 981 m/s^2; is \"gravity\", \"dt\" or the unit")) << "gravity";
  engine = {};
  engine.up = 'z';
  EXPECT_TRUE(says(import(engine), "accelerate along -y")) << "up";
  engine = {};
  engine.velocity_factor = -1;
  EXPECT_TRUE(says(import(engine), "against their velocities")) << "sign";
  engine.velocity_factor = 57.3;
  EXPECT_TRUE(says(import(engine), "as far in a step as their velocities say")) << "unit";
  engine = {};
  engine.told_dt = 0.02;
  EXPECT_TRUE(says(import(engine), "is \"gravity\", \"dt\" or the unit of length another one?")) << "dt";
  engine = {};
  engine.scalar_last = true;
  EXPECT_TRUE(says(import(engine), "in the order x y z w?")) << "quaternion";
  engine = {};
  engine.spin = 2;
  EXPECT_FALSE(says(import(engine), "spins"));
  engine.spin_factor = 57.2957795;
  EXPECT_TRUE(says(import(engine), "degrees/s")) << "spin";
  engine.spin_factor = -1;
  EXPECT_TRUE(says(import(engine), "against their spins")) << "spin";
}

}  // namespace
}  // namespace tumble::test
