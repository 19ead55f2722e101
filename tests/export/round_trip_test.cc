// Round trips through the formats that `import` reads: the same bits come back.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/export/same_states.h"

namespace tumble::test {
namespace {

/// Every case is there, the steps are few; export_every_case_test takes all steps.
TEST(RoundTrip, EveryGoldenCase) {
  std::set<std::string> cases;
  for (const auto& folder : std::filesystem::directory_iterator(TUMBLE_SOURCE_DIR "/golden/cases")) {
    if (exists(folder.path() / "scene.toml")) cases.insert(folder.path().filename().string());
  }
  ASSERT_GT(cases.size(), 50U);
  std::size_t number = 0;
  for (const std::string& name : cases) {
    const Workshop shop;
    ASSERT_EQ(shop.run({"record", name, "-o", "a.tumble", "--steps", "6"}).exit, 0) << name;
    SCOPED_TRACE(name);
    expect_round_trip(shop, "a.tumble", ++number % 2 == 0 ? ".csv" : ".npz");
  }
}

TEST(RoundTrip, ThrownBodiesAndInputsThatChangeTheLengthOfAStep) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"record", "layered_inputs", "-o", "inputs.tumble"}).exit, 0);
  shop.record_small("small");
  for (const char* log : {"inputs.tumble", "small.tumble"}) {
    for (const char* ending : {".csv", ".npz"}) expect_round_trip(shop, log, ending);
  }
}

/// Values of pairs, of one body in most steps.
std::string pair_of(const char* body, int step, const std::string& value) {
  return body[0] == '7' && step % 4 != 1 ? "8=" + value : std::string();
}

/// Bodies that come, go and come back; channels of all kinds, with units, of pairs too; NaN; axes; names; shapes.
std::string imported() {
  std::string text =
      "# engine: robot\n# version: 2\n# up: y\n# handed: left\n# dt: 0.01\n# gravity: 0 -9.81 0\n"
      "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,size.x,size.y,"
      "size.z,mass,shape,channel.angle (rad),channel.count,channel.big,channel.word,world.seed,pair.force "
      "(N),pair.how\n";
  for (int k = 0; k < 12; ++k) {
    for (const char* body : {"hip", "knee", "7"}) {
      if (body[0] == 'k' && (k < 2 || (k > 5 && k < 8))) continue;
      const std::string turn = k % 2 == 0 ? "1,0,0,0" : "0.6,0,0.8,0";
      const std::string x = body[0] == '7' && k > 9 ? "nan(0x7ff8000000000123)" : "0.1" + std::to_string(k);
      const std::string angle = body[0] == '7' ? "" : (k == 3 ? "nan" : "0." + std::to_string(k + 1));
      const std::string shape = body[0] == 'h' ? "capsule-y" : (body[0] == 'k' ? "sphere" : "box");
      const std::string word = k % 3 == 0 ? "up" : "döwn";
      for (const std::string& cell :
           {std::to_string(k), std::string(body), x, std::string("1.7,-0.3"), turn, std::string("0.5,1.5,0.5,2"), shape,
            angle, std::to_string(k - 4), std::string("18446744073709551615"), word, std::to_string(k * 3),
            pair_of(body, k, "0." + std::to_string(k + 1) + ' ' + "9=nan(0x7ff8000000000321)"),
            pair_of(body, k, "a%20b%2c 12=")}) {
        text.append(cell).append(",");
      }
      text.back() = '\n';
    }
  }
  return text;
}

TEST(RoundTrip, AnImportedSessionWithChannels) {
  const Workshop shop;
  shop.write("mine.csv", imported());
  const Outcome made = shop.run({"import", "mine.csv", "-o", "mine.tumble"});
  ASSERT_EQ(made.exit, 0) << made.err;
  for (const char* ending : {".csv", ".npz"}) expect_round_trip(shop, "mine.tumble", ending);
}

TEST(RoundTrip, FloatsOfAnEngineStayFloats) {
  const Workshop shop;
  std::string text = imported();
  text.replace(text.find("# version: 2"), 12, "# precision: float32\n# length: cm");
  shop.write("mine.csv", text);
  ASSERT_EQ(shop.run({"import", "mine.csv", "-o", "mine.tumble"}).exit, 0);
  for (const char* ending : {".csv", ".npz"}) {
    expect_round_trip(shop, "mine.tumble", ending);
    const Result<replay::LogReader> back =
        replay::LogReader::open(shop.path("mine.tumble" + std::string(ending) + ".back.tumble"));
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->header().engine->precision_bits, 24U);
  }
}

TEST(RoundTrip, ANameWithBracketsIsNoUnit) {
  const Workshop shop;
  shop.write(
      "mine.csv",
      "# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
      "channel.load (left) (),world.t (s)\n0,1,0,0,1,1,0,0,0,3,4\n1,1,0,0,1,1,0,0,0,inf,-inf\n");
  ASSERT_EQ(shop.run({"import", "mine.csv", "-o", "mine.tumble"}).exit, 0);
  for (const char* ending : {".csv", ".npz"}) expect_round_trip(shop, "mine.tumble", ending);
  EXPECT_NE(shop.read("mine.tumble.csv").find(",inf,-inf\n"), std::string::npos);  // as every reader of tables knows it
}

TEST(RoundTrip, ImportSaysWhichStepsHaveNoBody) {
  const Workshop shop;
  shop.write(
      "mine.csv",
      "# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z\n"
      "0,1,0,0,1,1,0,0,0\n0,2,0,0,1,1,0,0,0\n1,1,0,0,1,1,0,0,0\n2,2,0,0,1,1,0,0,0\n");
  ASSERT_EQ(shop.run({"import", "mine.csv", "-o", "mine.tumble"}).exit, 0);
  ASSERT_EQ(shop.run({"export", "mine.tumble", "-o", "one.npz", "--bodies", "1"}).exit, 0);
  const Outcome back = shop.run({"import", "one.npz", "-o", "back.tumble"});
  ASSERT_EQ(back.exit, 0) << back.err;
  EXPECT_NE(back.err.find("1 step without a body at the end, left out"), std::string::npos) << back.err;
  const Outcome quiet = shop.run({"import", "one.npz", "-o", "back.tumble", "--quiet"});
  EXPECT_EQ(quiet.exit, 0);
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, back.err) << "--quiet hides no warning";
}

}  // namespace
}  // namespace tumble::test
