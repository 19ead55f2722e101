// The relations of `tumble hunt --engine`: an engine that breaks one is seen to.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

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

// Scene 0 takes longer than the hunt has: what another process judged behind it is said, and fails.
TEST(HuntEngine, IsComparedWithNoOtherBuild) {
  const Workshop shop;
  const Outcome both = shop.run({"hunt", "--engine", "--against", TUMBLE_PROGRAM, "--count", "1"});
  EXPECT_EQ(both.exit, 2) << both.out;
  EXPECT_NE(both.err.find("--against"), std::string::npos) << both.err;
}

TEST(HuntEngine, WhatLiesBehindASceneThatWasNotJudgedIsSaid) {
  const Workshop shop;
  shop.write("tumble.toml", R"([engine]
shell = true
run = """grep -q 'hunt_1_0"' {scene} && sleep 6; grep -q 'hunt_1_3"' {scene} && exit 1; exit 2 # {log}"""
[engine.claims]
finishes = true
)");
  const std::vector<std::string> hunt = {"hunt", "--engine",   "--time",   "2",          "--threads",
                                         "2",    "--relation", "finishes", "--unshrunk", "--json"};
  const Outcome run = shop.run(hunt);
  EXPECT_EQ(run.exit, 1) << run.err;
  const Json json = Json::parse(run.out, nullptr, false);
  ASSERT_TRUE(json.is_object() && json.contains("beyond")) << run.out;
  EXPECT_LT(json.at("scenes"), 3U);
  EXPECT_EQ(json.at("relations").at("finishes").at("broken"), 0U);
  EXPECT_TRUE(json.at("findings").empty());
  EXPECT_GE(json.at("beyond").at("scenes"), 1U);
  ASSERT_FALSE(json.at("beyond").at("findings").empty());
  EXPECT_EQ(json.at("beyond").at("findings").at(0).at("number"), 3U);
}

// Bytes of an engine that are no text belong to its failure, and end no judge.
TEST(HuntEngine, ThatPrintsNoTextStillFailsItself) {
  const Workshop shop;
  shop.write("tumble.toml", R"([engine]
shell = true
run = """printf 'bad \\377 byte'; exit 3 # {scene} {log}"""
[engine.claims]
finishes = true
)");
  const Outcome run = shop.run(
      {"hunt", "--engine", "--count", "2", "--relation", "finishes", "--folder", "kept", "--threads", "1", "--json"});
  EXPECT_EQ(run.exit, 1) << run.err;
  const Json json = Json::parse(run.out, nullptr, false);
  ASSERT_TRUE(json.is_object() && json.at("findings").size() == 2) << run.out;
  EXPECT_EQ(json.at("findings").at(0).at("relation"), "finishes");
  const std::string what = json.at("findings").at(0).at("found").at("what");
  EXPECT_NE(what.find("ended with status 3; it printed: bad \uFFFD byte"), std::string::npos) << what;
}

#ifdef __linux__
// kill -9 leaves neither the engine running nor what the engine started.
TEST(HuntEngine, EndsWithAHuntThatIsKilled) {
  const Workshop shop;
  shop.write("tumble.toml", R"([engine]
shell = true
run = """(sleep 4; echo late >late) & echo >begun; sleep 60 # {scene} {log}"""
)");
  EXPECT_EQ(
      shop.run_after("timeout --foreground -s KILL 2 \"$0\" \"$@\"; exit; ", {"hunt", "--engine", "--count", "1"}).exit,
      128 + SIGKILL);
  EXPECT_FALSE(shop.names_with("begun").empty());
  std::this_thread::sleep_for(std::chrono::seconds(4));
  EXPECT_TRUE(shop.names_with("late").empty()) << "the engine went on";
}
#endif

// An engine that ends in the middle of a table leaves the table and its last words, each bounded, beside the scene.
TEST(HuntEngine, LeavesWhatItWroteBesideAFinding) {
  const Workshop shop;
  shop.write("tumble.toml", R"([engine]
shell = true
run = """(echo half a table; head -c 5000000 /dev/zero | tr '\\0' x) >{log}; echo no memory; echo at all; exit 3 # {scene}"""
)");
  const Outcome run = shop.run({"hunt", "--engine", "--count", "5", "--relation", "finishes", "--folder", "kept"});
  EXPECT_EQ(run.exit, 4) << run.err;
  for (const char* file : {"finishes_1_0.csv.cut", "finishes_1_0.said.txt"})
    EXPECT_NE(run.out.find(std::string("kept/findings/") + file), std::string::npos) << run.out;
  EXPECT_EQ(shop.read("kept/findings/finishes_1_0.said.txt"), "no memory\nat all\n");
  EXPECT_NE(run.out.find("it printed: no memory | at all\n"), std::string::npos) << run.out;
  const std::string wrote = shop.read("kept/findings/finishes_1_0.csv.cut");
  EXPECT_EQ(wrote.size(), 4U << 20U);
  EXPECT_EQ(wrote.substr(0, 13), "half a table\n");
  const Json json = Json::parse(shop.read("kept/hunt.json"), nullptr, false);
  ASSERT_TRUE(json.is_object() && json.at("findings").size() == 5U);
  EXPECT_EQ(json.at("findings").at(2).at("engine_files"), Json({"finishes_1_2.csv.cut", "finishes_1_2.said.txt"}));
  EXPECT_FALSE(json.at("findings").at(3).contains("engine_files")) << "three of a kind are kept";
}

// A body that falls and flies on, as semi-implicit Euler moves it, as a table.
constexpr const char* kFallingEngine = R"(/^dt = / { dt = $3 }
/^steps = / { steps = $3 }
END {
  printf "# dt: %.17g\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,", dt
  print "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,size.x,size.y,size.z,mass"
  z = 50; v = 0
  for (k = 0; k <= steps; ++k) {
    printf "%d,1,%.17g,0,%.17g,1,0,0,0,3,0,%.17g,0,0,0,1,1,1,2\n", k, 3 * k * dt, z, v
    v -= 10 * dt; z += v * dt
  }
}
)";

// Flights are judged by the integrator that the engine names, and are no parabolas without.
TEST(HuntEngine, FliesByItsIntegrator) {
  const Workshop shop;
  shop.write("fall.awk", kFallingEngine);
  shop.write("scenes/fall.toml",
             "name = \"fall\"\n[world]\nmethod = \"layered\"\ndt = 0.0078125\nsteps = 20\ngravity = [0, 0, "
             "-10]\nground = false\n"
             "[[box]]\nid = 1\nmass = 2\nposition = [0, 0, 50]\nvelocity = [3, 0, 0]\n");
  const auto status = [&shop](const std::string& keys) {
    shop.write("tumble.toml", "[engine]\nshell = true\nrun = \"awk -f fall.awk {scene} >{log}\"\n" + keys +
                                  "[engine.claims]\nflight = true\nhalved = true\n");
    const Outcome run = shop.run({"hunt", "--engine", "--judge", "scenes", "--json"});
    const Json json = Json::parse(run.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << run.err;
    for (const char* law : {"flight", "halved"}) {
      EXPECT_EQ(json.at("relations").at(law).at("broken"), run.exit == 0 ? 0U : 1U) << law << run.out;
      EXPECT_EQ(json.at("relations").at(law).at("held"), run.exit == 0 ? 1U : 0U) << law << run.out;
    }
    return run.exit;
  };
  EXPECT_EQ(status("integrator = \"semi_implicit_euler\"\n"), 0);
  EXPECT_EQ(status(""), 1);
  EXPECT_EQ(status("integrator = \"explicit_euler\"\n"), 1);
  EXPECT_EQ(status("integrator = \"semi_implicit_euler\"\nsubsteps = 2\n"), 1);
  const auto kept = [&shop](const std::string& keys) {  // a hunt goes on only with the engine as it was told
    shop.write("tumble.toml", "[engine]\nshell = true\nrun = \"awk -f fall.awk {scene} >{log}\"\n" + keys);
    return shop.run({"hunt", "--engine", "--count", "1", "--relation", "flight", "--unshrunk", "--folder", "kept"});
  };
  EXPECT_NE(kept("").exit, 2);
  EXPECT_NE(kept("").exit, 2);
  EXPECT_EQ(kept("integrator = \"explicit_euler\"\n").exit, 2);
  shop.write("tumble.toml", "[engine]\nrun = \"engine {scene} {log}\"\nintegrator = \"euler\"\n");
  const Outcome wrong = shop.run({"hunt", "--engine", "--count", "1"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_NE(wrong.err.find("semi_implicit_euler"), std::string::npos) << wrong.err;
}

// A table is kept with the names that the engine gave its columns, a log as a log.
TEST(HuntEngine, LeavesItsTableAsItWroteIt) {
  const auto kept_after = [](const Workshop& shop, const std::string& run, const std::string& more) {
    shop.write("tumble.toml", "[engine]\nshell = true\nrun = '''" + run + " # {scene}'''\n" + more);
    const Outcome hunt = shop.run({"hunt", "--engine", "--count", "1", "--folder", "kept", "--unshrunk", "--json"});
    const Json json = Json::parse(hunt.out, nullptr, false);
    return json.is_object() && !json.at("findings").empty() ? json.at("findings").at(0).value("engine_files", Json())
                                                            : Json(hunt.err);
  };
  const Workshop table, log;
  EXPECT_EQ(kept_after(table, "echo 'step,id,px' >{log}", "[engine.table]\nmap = [\"position.x=px\"]\n"),
            Json({"finishes_1_0.csv"}));
  EXPECT_EQ(table.read("kept/findings/finishes_1_0.csv"), "step,id,px\n");
  EXPECT_EQ(kept_after(log, "'" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet --seconds 0.01", ""),
            Json({"finishes_1_0.tumble"}));
}

/// An engine whose sessions have another number in a column from step 2 on.
void write_engine_with(const Workshop& shop, const std::string& column, const std::string& number) {
  shop.write("e.sh",
             "#!/bin/sh\n" TUMBLE_PROGRAM " record $1 -o $2.own --quiet || exit 2\n" TUMBLE_PROGRAM
             " export $2.own -o $2.csv >/dev/null\nawk -F, -v OFS=, '/^#/ { print; next } !c { for (i = 1; i <= "
             "NF; i++) if ($i == \"" +
                 column + "\") c = i; print; next } $1 >= 2 { $c = \"" + number + "\" } { print }' $2.csv >$2\n");
  std::filesystem::permissions(shop.path("e.sh"), std::filesystem::perms::owner_all);
  shop.write("tumble.toml", "[engine]\nrun = \"./e.sh {scene} {log}\"\n");
}

// Each law is asked of a session in which a body is nowhere from step 2 on.
TEST(HuntEngine, ThatLosesABodyHoldsNoLaw) {
  const Workshop shop;
  write_engine_with(shop, "position.x", "nan");
  const Outcome run = shop.run({"hunt", "--engine", "--count", "6", "--unshrunk", "--json"});
  const Json json = Json::parse(run.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << run.err;
  EXPECT_GT(json.at("relations").at("numbers").at("broken"), 0U) << run.out;
  for (const char* law : {"energy", "momentum", "cone", "overlap", "unmet", "flight", "standing"})
    EXPECT_EQ(json.at("relations").at(law).at("held"), 0U) << law;
  EXPECT_GT(json.at("relations").at("overlap").at("broken"), 0U);
}

// Speeds whose squares overflow, as of an engine that explodes.
TEST(HuntEngine, ThatExplodesHoldsNoEnergyAndIsJudgedToTheEnd) {
  const Workshop shop;
  write_engine_with(shop, "velocity.x", "1e200");
  const Outcome run = shop.run({"hunt", "--engine", "--count", "6", "--shrink", "1", "--json"});
  const Json json = Json::parse(run.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << run.err;
  EXPECT_EQ(json.at("scenes"), 6U) << run.err;
  EXPECT_EQ(json.at("relations").at("energy").at("held"), 0U) << run.out;
  EXPECT_GT(json.at("relations").at("energy").at("broken"), 0U) << run.out;
}

// Its session holds one body, which no drawn scene has: judges read no body that is not there, and nothing holds of it.
TEST(HuntEngine, SessionsOfOtherBodiesAreNotJudged) {
  const Workshop shop;
  shop.write("other.toml", "[world]\nsteps = 400\ndt = 0.01\n[[box]]\nid = 977\nposition = [0.0, 0.0, 9.0]\n");
  const auto hunt = [&shop](const std::string& claims) {
    shop.write("tumble.toml", "[engine]\nshell = true\nrun = \"\"\"'" TUMBLE_PROGRAM "' record '" +
                                  shop.path("other.toml") + "' -o {log} --quiet # {scene}\"\"\"\n[engine.claims]\n" +
                                  claims);
    return shop.run({"hunt", "--engine", "--seed", "1", "--count", "12", "--unshrunk", "--json", "--threads", "1"});
  };
  for (const std::string claims : {"slope = true\nrepeat = true\n", ""}) {
    const Outcome unclaimed = hunt(claims);
    EXPECT_EQ(unclaimed.exit, 4) << claims << unclaimed.err;
    EXPECT_NE(unclaimed.err.find("nothing was judged"), std::string::npos) << unclaimed.err;
    EXPECT_NE(unclaimed.err.find("has other bodies than the scene"), std::string::npos) << unclaimed.err;
  }
  const Outcome claimed = hunt("start = true\nfinishes = true\n");
  EXPECT_EQ(claimed.exit, 1) << claimed.err;
  const Json json = Json::parse(claimed.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << claimed.out;
  for (const auto& [name, tally] : json.at("relations").items()) {
    EXPECT_EQ(tally.at("held"), 0U) << name;
    EXPECT_EQ(tally.at("broken"), name == "start" || name == "finishes" ? 12U : 0U) << name;
  }
  for (const Json& finding : json.at("findings")) EXPECT_NE(finding.at("relation"), "survives") << finding;
}

// Nothing is known of an engine that does not run: it refuses no scene and breaks no claim.
TEST(HuntEngine, ThatDoesNotStartIsNeitherRefusalNorHeld) {
  const Workshop shop;
  shop.write("tumble.toml", "[engine]\nrun = \"./e.sh {scene} {log}\"\n[engine.claims]\nfinishes = true\n");
  const auto expect_unable = [&shop](const std::vector<std::string>& words) {
    const Outcome run = shop.run(words);
    EXPECT_EQ(run.exit, 4) << run.out;
    EXPECT_NE(run.err.find("the engine does not start"), std::string::npos) << run.err;
    EXPECT_EQ(run.out.find("no scene broke"), std::string::npos) << run.out;
  };
  const std::vector<std::string> hunt = {"hunt", "--engine", "--count", "3", "--relation", "finishes"};
  expect_unable(hunt);
  shop.write("e.sh", "#!/bin/sh\n");  // not executable
  expect_unable(hunt);
  shop.write("corpus/s.toml", shop.run({"hunt", "--print", "1"}).out);
  expect_unable({"hunt", "--engine", "--judge", "corpus"});
  // One that is gone when it is asked again.
  shop.write("e.sh", "#!/bin/sh\nrm e.sh\nexec " TUMBLE_PROGRAM " record $1 -o $2 --quiet\n");
  std::filesystem::permissions(shop.path("e.sh"), std::filesystem::perms::owner_all);
  expect_unable({"hunt", "--engine", "--count", "1", "--relation", "repeat"});
}

}  // namespace
}  // namespace tumble::test
