// tumble export as a user meets it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/program.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {
namespace {

void expect_error(const Outcome& run, int exit, const std::string& part) {
  EXPECT_EQ(run.exit, exit) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  EXPECT_TRUE(run.out.empty()) << run.out;
}

TEST(Export, ChoosesStepsBodiesAndEvery) {
  const Workshop shop;
  shop.record_small("a");
  const Outcome run =
      shop.run({"export", "a.tumble", "-o", "a.csv", "--steps", "3:20", "--every", "4", "--bodies", "1", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const nlohmann::json json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["states"], 5);
  EXPECT_EQ(json["bodies"], 1);
  EXPECT_EQ(json["first_step"], 3);
  EXPECT_EQ(json["last_step"], 19);
  std::istringstream lines(shop.read("a.csv"));
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);)
    rows += std::isdigit(static_cast<unsigned char>(line[0])) ? 1U : 0U;
  EXPECT_EQ(rows, 5U);
}

TEST(Export, SaysWhatIsWrongAndLeavesNoFile) {
  const Workshop shop;
  shop.record_small("a");
  expect_error(shop.run({"export", "a.tumble", "-o", "a.xyz"}), 2, "wanted .csv");
  expect_error(shop.run({"export", "a.tumble", "-o", "a"}), 2, "the ending names the format");
  expect_error(shop.run({"export", "a.tumble", "-o", "a.csv", "--bodies", "99"}), 2, "none of these bodies");
  expect_error(shop.run({"export", "a.tumble", "-o", "a.csv", "--bodies", "wheel"}), 2, "\"wheel\"");
  expect_error(shop.run({"export", "a.tumble", "-o", "a.csv", "--steps", "0:900"}), 2, "no step 900");
  expect_error(shop.run({"export", "a.tumble", "-o", "a.csv", "--every", "0"}), 2, "--every");
  expect_error(shop.run({"export", "a.tumble", "-o", "a.tumble"}), 2, "");
  expect_error(shop.run({"export", "a.tumble", "-o", "no/folder/a.csv"}), 2, "No such file");
  std::filesystem::create_symlink("/dev/null", shop.path("null.npz"));
  expect_error(shop.run({"export", "a.tumble", "-o", "null.npz"}), 2, "is a device or a pipe");
  EXPECT_TRUE(shop.names_with("a.csv").empty());
}

TEST(Export, AFullDiskEndsWithFour) {
  const Workshop shop;
  shop.record_small("a");
  for (const char* file : {"a.csv", "a.npz"}) {
    const Outcome run = shop.run_after("ulimit -f 8; trap '' XFSZ; ", {"export", "a.tumble", "-o", file});
    EXPECT_EQ(run.exit, 4) << file << run.err;
  }
  EXPECT_TRUE(shop.names_with("a.csv").empty());
  EXPECT_TRUE(shop.names_with("a.npz").empty());
}

TEST(Export, ATornLogIsExportedAsFarAsItGoes) {
  const Workshop shop;
  shop.record_small("a");
  const std::string log = shop.read("a.tumble");
  shop.write("torn.tumble", log.substr(0, log.size() - 40));
  const Outcome run = shop.run({"export", "torn.tumble", "-o", "torn.csv"});
  EXPECT_EQ(run.exit, 3) << run.err;
  EXPECT_FALSE(shop.names_with("torn.csv").empty());
}

/// A session with a chunk in its middle that is damaged; some body is thrown in, and one removed, in every few steps.
void record_busy(const Workshop& shop) {
  std::string scene =
      "title = \"throws\"\ncategory = \"session\"\n[world]\ndt = 0.01\nsteps = 400\n[[pile]]\ncount = [4, 4, 4]\n";
  for (int k = 3; k < 390; k += 3) {
    const std::string at = "[[input]]\nstep = " + std::to_string(k) + "\nkind = ";
    scene += at + "\"throw\"\nid = " + std::to_string(1000 + k) + "\nposition = [" + std::to_string(20 + 2 * k) +
             ", 0.0, 5.0]\nvelocity = [0.0, 1.0, 0.0]\n";
    if (k > 30) scene += at + "\"remove\"\nid = " + std::to_string(1000 + k - 30) + '\n';
  }
  shop.write("busy.toml", scene);
  ASSERT_EQ(shop.run({"record", "busy.toml", "-o", "busy.tumble"}).exit, 0);
  const std::string log = shop.read("busy.tumble");
  const auto write_damaged = [&](const char* name, std::size_t at) {
    std::string copy = log;
    copy[at] = static_cast<char>(copy[at] ^ 0x55);
    shop.write(name, copy);
  };
  write_damaged("damaged.tumble", log.size() * 3 / 5);   // in the second chunk of three
  write_damaged("beheaded.tumble", log.size() * 1 / 5);  // in the first
}

/// The example of the documents and of --help.
TEST(Export, TheThrownCubeOfTheDocuments) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"record", "brick_wall", "--steps", "20", "-o", "brick_wall.tumble"}).exit, 0);
  const auto document = [](const char* name) {
    std::ostringstream text;
    text << std::ifstream(std::filesystem::path(TUMBLE_SOURCE_DIR) / "docs" / name).rdbuf();
    return text.str();
  };
  const std::string words = "brick_wall.tumble -o ball.csv --bodies ";
  for (const std::string& text :
       {document("exporting.md"), document("commands.md"), shop.run({"export", "--help"}).out}) {
    const std::size_t at = text.find(words);
    ASSERT_NE(at, std::string::npos) << text.substr(0, 300);
    const std::size_t body = at + words.size();
    const std::string bodies = text.substr(body, text.find(' ', body) - body);
    const Outcome run =
        shop.run({"export", "brick_wall.tumble", "-o", "ball.csv", "--bodies", bodies, "--steps", "0:20"});
    EXPECT_EQ(run.exit, 0) << run.err;
  }
}

TEST(Export, OfADamagedLogSaysWhatCanBeExported) {
  const Workshop shop;
  record_busy(shop);
  const Outcome run = shop.run({"export", "damaged.tumble", "-o", "a.npz"});
  EXPECT_EQ(run.exit, 3);
  const std::size_t at = run.err.find("and --steps 0:");
  ASSERT_NE(at, std::string::npos) << run.err;
  const std::string steps = run.err.substr(at + 12, run.err.find(' ', at + 12) - at - 12);
  EXPECT_EQ(shop.run({"export", "damaged.tumble", "-o", "a.npz", "--steps", steps, "--json"}).exit, 0);
  EXPECT_FALSE(shop.read("a.npz").empty());
  const Outcome none = shop.run({"export", "beheaded.tumble", "-o", "b.npz"});
  EXPECT_EQ(none.exit, 3);
  EXPECT_EQ(none.err.find("--steps"), std::string::npos) << none.err;
}

TEST(Export, ListsWhatOfTheSceneHasNoPlace) {
  const Workshop shop;
  shop.record_small("s");
  for (const char* file : {"a.csv", "a.npz", "a.glb", "a.mcap"}) {
    const Outcome run = shop.run({"export", "s.tumble", "-o", file, "--json"});
    ASSERT_EQ(run.exit, 0) << run.err;
    const std::string left_out = nlohmann::json::parse(run.out)["left_out"].dump();
    const bool is_scene = std::string(file) == "a.glb";  // which has a light
    for (const char* part : {"title, category", "the method and its parameters", is_scene ? "text" : "light"}) {
      EXPECT_NE(left_out.find(part), std::string::npos) << file << ' ' << part << ": " << left_out;
    }
  }
}

/// Bodies that came in lost steps have no sizes; those that went in lost steps have no states.
TEST(Export, BehindLostStepsOnlyKnownBodies) {
  const Workshop shop;
  record_busy(shop);
  ASSERT_EQ(shop.run({"recover", "damaged.tumble", "-o", "rest.tumble"}).exit, 3);
  Result<replay::LogReader> log = replay::LogReader::open(shop.path("rest.tumble"));
  ASSERT_TRUE(log.ok() && log->header().missing().size() == 1U);
  const std::uint64_t end = log->header().missing().front().end_step();
  for (const std::uint64_t first : {end, end + 7}) {
    const std::string range = std::to_string(first) + ":" + std::to_string(end + 40);
    for (const char* file : {"a.csv", "a.npz", "a.glb"}) {
      const Outcome run = shop.run({"export", "rest.tumble", "-o", file, "--steps", range, "--json"});
      ASSERT_EQ(run.exit, 3) << file << ": " << run.err;
      const nlohmann::json json = nlohmann::json::parse(run.out);
      EXPECT_NE(json["left_out"].dump().find("thrown in during lost steps"), std::string::npos) << json["left_out"];
    }
    ASSERT_EQ(shop.run({"import", "a.npz", "-o", "back.tumble"}).exit, 0);
    Result<replay::LogReader> back = replay::LogReader::open(shop.path("back.tumble"));
    ASSERT_TRUE(back.ok());
    for (std::uint64_t k = first; k <= end + 40; ++k) {
      const Result<const replay::StepRecord*> whole = log->read_step(k), part = back->read_step(k - first);
      ASSERT_TRUE(whole.ok() && part.ok());
      const auto &a = (*whole)->states, &b = (*part)->states;
      ASSERT_LE(b.size(), a.size());
      ASSERT_TRUE(k > end || b.size() < a.size());
      ASSERT_GE(b.size(), 64U);  // those of the pile
      for (std::size_t i = 0; i < b.size(); ++i) {
        const auto row = static_cast<std::size_t>(std::ranges::find(a.id, b.id[i]) - a.id.begin());
        ASSERT_LT(row, a.size()) << "body " << b.id[i] << " at step " << k;
        ASSERT_EQ(a.position[row], b.position[i]);
      }
    }
  }
}

TEST(Export, ALogWithoutStepsHasOneState) {
  const Workshop shop;
  shop.write("a.in.csv",
             "# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
             "orientation.z\n0,1,0,0,1,1,0,0,0\n");
  ASSERT_EQ(shop.run({"import", "a.in.csv", "-o", "a.tumble"}).exit, 0);
  for (const char* file : {"a.csv", "a.npz"}) {
    const Outcome run = shop.run({"export", "a.tumble", "-o", file, "--json"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["states"], 1);
  }
}

TEST(Export, BodiesAreChosenByName) {
  const Workshop shop;
  shop.write("m.csv",
             "# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
             "orientation.z\n0,hip,0,0,1,1,0,0,0\n0,knee,1,0,1,1,0,0,0\n1,hip,0,0,1,1,0,0,0\n1,knee,1,0,1,1,0,0,0\n");
  ASSERT_EQ(shop.run({"import", "m.csv", "-o", "m.tumble"}).exit, 0);
  const Outcome run = shop.run({"export", "m.tumble", "-o", "k.csv", "--bodies", "knee", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["bodies"], 1);
  EXPECT_NE(shop.read("k.csv").find(",knee,1,"), std::string::npos);
  expect_error(shop.run({"export", "m.tumble", "-o", "x.csv", "--bodies", "kne"}), 2, "names of bodies");
}

TEST(Export, ANameThatIsAlsoAnIdIsRefused) {
  const Workshop shop;
  std::string rows =
      "# dt: 0.01\nstep,id,name,position.x,position.y,position.z,orientation.w,orientation.x,"
      "orientation.y,orientation.z\n";
  for (const char* step : {"0", "1"}) {
    rows +=
        std::string(step) + ",1,2,0,0,1,1,0,0,0\n" + step + ",2,3-4,3,0,1,1,0,0,0\n" + step + ",5,5,6,0,1,1,0,0,0\n";
  }
  shop.write("m.csv", rows);
  const Outcome import = shop.run({"import", "m.csv", "-o", "m.tumble"});
  ASSERT_EQ(import.exit, 0) << import.err;
  expect_error(shop.run({"export", "m.tumble", "-o", "x.csv", "--bodies", "2"}), 2, "the name of body 1");
  expect_error(shop.run({"export", "m.tumble", "-o", "x.csv", "--bodies", "5,3-4"}), 2, "wanted 2-2 for that body");
  EXPECT_EQ(shop.run({"export", "m.tumble", "-o", "x.csv", "--bodies", "5,1-1"}).exit, 0);
}

/// numpy would hold another text.
TEST(Export, ATextThatIsNoUtf8HasNoPlaceInAnArchive) {
  const Workshop shop;
  shop.write("t.csv",
             "# escapes: percent\n# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
             "orientation.y,orientation.z,channel.word\n0,1,0,0,1,1,0,0,0,%c3%a9\n1,1,0,0,1,1,0,0,0,a%ff\n");
  ASSERT_EQ(shop.run({"import", "t.csv", "-o", "t.tumble"}).exit, 0);
  expect_error(shop.run({"export", "t.tumble", "-o", "t.npz"}), 2, "a text that is no UTF-8");
  EXPECT_EQ(shop.run({"export", "t.tumble", "-o", "t.npz", "--steps", "0:0"}).exit, 0);
  EXPECT_EQ(shop.run({"export", "t.tumble", "-o", "back.csv"}).exit, 0);
  const Outcome scene = shop.run({"export", "t.tumble", "-o", "t.mcap"});  // has bytes, too
  EXPECT_EQ(scene.exit, 0) << scene.err;
  EXPECT_EQ(scene.err, "");
  EXPECT_NE(scene.out.find("the kind of 1 text in channels, no UTF-8: bytes in their place"), std::string::npos)
      << scene.out;
}

/// numpy alone reads the archive; every number is the one of `dump`, to the bit.
TEST(Export, NumpyReadsTheArchive) {
  if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
    GTEST_SKIP() << "python3-numpy is missing; run tools/setup.sh --with export";
  }
  const Workshop shop;
  shop.record_small("a");
  ASSERT_EQ(shop.run({"export", "a.tumble", "-o", "a.npz"}).exit, 0);
  const Outcome dump = shop.run({"dump", "a.tumble", "--steps", "0:40", "--csv"});
  ASSERT_EQ(dump.exit, 0);
  shop.write("a.dump.csv", dump.out);
  const std::string script = TUMBLE_SOURCE_DIR "/tests/export/read_npz.py";
  const std::string command = "/usr/bin/python3 " + script + ' ' + shop.path("a.npz") + ' ' + shop.path("a.dump.csv");
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace tumble::test
