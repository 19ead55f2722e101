// Bad input of every kind: a clear message on stderr, the right exit status, nothing lost that was complete.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Words = std::vector<std::string>;

// Each of `parts` must be in the message, which begins with the command's name.
void expect_error(const Outcome& outcome, int exit, const std::string& command, const Words& parts) {
  EXPECT_EQ(outcome.exit, exit) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with(command + ": ")) << outcome.err;
  for (const std::string& part : parts) {
    EXPECT_NE(outcome.err.find(part), std::string::npos) << "wanted \"" << part << "\" in: " << outcome.err;
  }
}

TEST(BadUsage, UnknownCommandNamesTheNearest) {
  const Workshop shop;
  expect_error(shop.run({"recrod"}), 2, "tumble", {"\"recrod\"", "did you mean \"record\"", "tumble help"});
  expect_error(shop.run({"help", "xyzzy"}), 2, "tumble", {"\"xyzzy\""});
  EXPECT_EQ(shop.run({}).exit, 2);
}

TEST(BadUsage, OptionsNameWhatWasFoundAndWanted) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  const auto record = [&](const Words& more) {
    Words words = {"record", "s.toml"};
    words.insert(words.end(), more.begin(), more.end());
    return shop.run(words);
  };
  expect_error(shop.run({"record"}), 2, "tumble record", {"SCENE is required", "--help"});
  expect_error(record({"--frob"}), 2, "tumble record", {"--frob"});
  expect_error(record({"another"}), 2, "tumble record", {"another"});
  expect_error(record({"--steps", "3", "--seconds", "2"}), 2, "tumble record", {"--seconds", "--steps"});
  expect_error(record({"--steps", "-3"}), 2, "tumble record", {"--steps", "\"-3\"", "from 1"});
  EXPECT_EQ(record({"--steps", "-3"}).err.find("for a file of that name"), std::string::npos) << "a number is no file";
  expect_error(record({"--steps", "1e3"}), 2, "tumble record", {"\"1e3\"", "whole number"});
  expect_error(record({"--seconds", "nan"}), 2, "tumble record", {"--seconds", "\"nan\"", "above 0"});
  expect_error(record({"--threads", "0"}), 2, "tumble record", {"--threads", "\"0\"", "1 to 256"});
  expect_error(record({"--states", "few"}), 2, "tumble record", {"--states", "\"few\"", "every:N"});
  expect_error(record({"--hashes", "few"}), 2, "tumble record", {"--hashes", "\"few\"", "every:N"});
  expect_error(record({"--set", "grid"}), 2, "tumble record", {"--set grid", "key=value"});
  expect_error(record({"--set", "box.3.mass=1"}), 2, "tumble record", {"--set box.3.mass=1", "found number 3"});
  expect_error(record({"--set", "box.1.mass=-1"}), 2, "tumble record", {"--set box.1.mass=-1", "found -1", "a mass"});
  EXPECT_FALSE(std::filesystem::exists(shop.path("s.tumble"))) << "a refused session must not leave a log";
}

TEST(BadUsage, ADashIsNoOutput) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  shop.write("a.csv",
             "# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
             "orientation.z\n0,1,0,0,5,1,0,0,0\n");
  EXPECT_EQ(shop.run({"record", "s.toml", "--quiet"}).exit, 0);
  for (const Words& command : {Words{"record", "s.toml", "-o", "-"}, Words{"import", "a.csv", "-o", "-"},
                               Words{"measure", "s.tumble", "--series", "-"}}) {
    expect_error(shop.run(command), 2, "tumble " + command.front(), {": -: is no name of an output"});
    EXPECT_FALSE(std::filesystem::exists(shop.path("-"))) << command.front();
  }
  EXPECT_EQ(shop.run({"import", "a.csv", "-o", "./-"}).exit, 0);
}

TEST(BadUsage, WhatIsToBeImportedIsSaidToBe) {
  const Workshop shop;
  shop.write("a.csv", "# dt: 0.01\nstep,id,position.x\n0,1,0\n");
  shop.write("b.csv", "step,id,position.x\n0,1,0\n");
  shop.write("a.npz", std::string("PK\x03\x04") + "arrays");
  shop.write("a.tumblestream", std::string("\x89tumblestream\r\n\x1a") + "more");
  shop.write("page.md", "# A page\nsome: words\n");
  for (const std::string file : {"a.csv", "b.csv", "a.npz", "a.tumblestream"}) {
    for (const Words& command : {Words{"diff", file, file}, Words{"replay", file}, Words{"measure", file}}) {
      expect_error(shop.run(command), 2, "tumble " + command.front(), {file + ": is no log yet: 'tumble import FILE'"});
    }
  }
  expect_error(shop.run({"info", "page.md"}), 2, "tumble info", {"page.md: is not a log"});
  expect_error(shop.run({"recover", "a.csv", "-o", "r.tumble"}), 2, "tumble recover", {"'tumble import FILE'"});
  expect_error(shop.run({"import", "a.csv", "--map-file", "."}), 2, "tumble import", {".: is a folder; name a file"});
}

TEST(BadScene, ErrorsNameFileLineKeyFoundAndWanted) {
  const Workshop shop;
  shop.write("s.toml", "[world]\nmethod = \"thesis\"\n[[box]]\nmass = -2.0\n");
  expect_error(shop.run({"record", "s.toml"}), 2, "tumble record", {"s.toml:4:", "mass", "found -2", "wanted"});
  shop.write("t.toml", "[world]\ngravitty = [0, 0, -1]\n");
  expect_error(shop.run({"record", "t.toml"}), 2, "tumble record", {"t.toml:2:", "gravitty"});
  shop.write("u.toml", "[world\n");
  expect_error(shop.run({"record", "u.toml"}), 2, "tumble record", {"u.toml:1:"});
}

TEST(BadScene, WhatIsNoSceneIsSaidToBe) {
  const Workshop shop;
  shop.record_small("s");
  std::filesystem::create_directories(shop.path("folder"));
  expect_error(shop.run({"record", "s.tumble"}), 2, "tumble record",
               {"s.tumble: is a log", "wanted a scene", "--from"});
  expect_error(shop.run({"record", "folder"}), 2, "tumble record", {"folder: found a folder, wanted a scene file"});
}

TEST(BadScene, UnknownNamesPointToTheList) {
  const Workshop shop;
  expect_error(shop.run({"record", "tilted_gird"}), 2, "tumble record",
               {"did you mean \"tilted_grid\"", "tumble scenes"});
  expect_error(shop.run({"record", "./none.toml"}), 2, "tumble record", {"./none.toml", "no such file"});
  expect_error(shop.run({"record", shop.path("")}), 2, "tumble record", {"a folder"});
}

TEST(BadOutput, IsNamedAndNothingElseIsTouched) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  expect_error(shop.run({"record", "s.toml", "-o", "none/x.tumble"}), 2, "tumble record", {"none/x.tumble"});
  expect_error(shop.run({"record", "s.toml", "-o", "."}), 2, "tumble record", {"folder"});
  expect_error(shop.run({"record", "s.toml", "-o", "s.toml"}), 2, "tumble record", {"s.toml", "is the scene itself"});
  EXPECT_EQ(shop.read("s.toml"), kSmallScene) << "the scene must not be overwritten";
  expect_error(shop.run({"record", "s.toml", "-o", "/dev/full"}), 4, "tumble record", {"No space left"});
  shop.record_small("r");
  expect_error(shop.run({"measure", "r.tumble", "--series", "none/x.csv"}), 2, "tumble measure", {"none/x.csv"});
  expect_error(shop.run({"measure", "r.tumble", "--series", "/dev/full"}), 4, "tumble measure", {"/dev/full"});
  for (const Words& words : {Words{"diff", "r.tumble", "r.tumble", "--plot", "none/x.svg"},
                             {"bench", "memory", "--scene", "s.toml", "--save", "none/x.json"},
                             {"measure", "r.tumble", "--series", "none/x.csv"}}) {
    const Outcome outcome = shop.run(words);
    expect_error(outcome, 2, "tumble " + words[0], {words.end()[-2] + ": none/x", "No such file or directory"});
    EXPECT_EQ(outcome.out, "") << "asked before the work";
  }
}

// Root may write anywhere, so the program runs as somebody else then.
std::string as_another() {
  return ::geteuid() == 0 ? "exec setpriv --reuid=65534 --regid=65534 --clear-groups \"$0\" \"$@\"; " : "";
}

TEST(BadOutput, AFileThatMayNotBeWrittenIsNamedBeforeTheWork) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  shop.record_small("r");
  std::filesystem::permissions(shop.path(""), std::filesystem::perms::all);
  const std::string other = as_another();
  if (!other.empty() && shop.run_after(other, {"--version"}).exit != 0) GTEST_SKIP() << "no setpriv";
  for (const Words& words : {Words{"diff", "r.tumble", "r.tumble", "--plot", "x.svg"},
                             {"export", "r.tumble", "-o", "x.npz"},
                             {"render", "r.tumble", "--step", "1", "-o", "x.png"}}) {
    const std::string& file = words.back();
    shop.write(file, "");
    std::filesystem::permissions(shop.path(file), std::filesystem::perms(0444));
    const Outcome outcome = shop.run_after(other, words);
    expect_error(outcome, 2, "tumble " + words[0],
                 {words.end()[-2] + ": " + file + ": cannot be written: Permission denied"});
    EXPECT_EQ(outcome.out, "") << "asked before the work";
  }
}

TEST(BadOutput, BlessingAFolderThatMayNotBeWrittenIsRefusedAtOnce) {
  const Workshop shop;
  namespace fs = std::filesystem;
  fs::create_directories(shop.path("suite/cases/fall"));
  shop.write("suite/cases/fall/scene.toml", kSmallScene);
  shop.write("suite/cases/fall/metrics.toml", "[[metric]]\nname = \"lost\"\nmax = 0\nwhy = \"nothing falls\"\n");
  fs::permissions(shop.path(""), fs::perms::all);
  fs::permissions(shop.path("suite"), fs::perms::all);
  fs::permissions(shop.path("suite/cases/fall"), fs::perms(0555));
  const std::string other = as_another();
  if (!other.empty() && shop.run_after(other, {"--version"}).exit != 0) GTEST_SKIP() << "no setpriv";
  const Words bless = {"bless", "--suite", "suite", "--all", "--reason", "new"};
  expect_error(shop.run_after(other, bless), 2, "tumble bless",
               {"suite/cases/fall: cannot be written: Permission denied; nothing was blessed"});
  fs::permissions(shop.path("suite/cases/fall"), fs::perms::all);
  fs::permissions(shop.path("suite/cases/fall/metrics.toml"), fs::perms(0444));
  expect_error(shop.run_after(other, bless), 2, "tumble bless",
               {"suite/cases/fall/metrics.toml: cannot be written: Permission denied; nothing was blessed"});
  fs::permissions(shop.path("suite/cases/fall"), fs::perms(0555));
  Words dry = bless;
  dry.emplace_back("--dry-run");
  EXPECT_EQ(shop.run_after(other, dry).exit, 0) << "it writes nothing";
  fs::permissions(shop.path("suite/cases/fall"), fs::perms::all);
  fs::permissions(shop.path("suite/cases/fall/metrics.toml"), fs::perms::all);
  const Outcome blessed = shop.run_after(other, bless);
  EXPECT_EQ(blessed.exit, 0) << blessed.err;
}

TEST(BadLog, WhatIsNoLogIsBadInput) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  shop.record_small("good");
  for (const std::string command : {"info", "replay", "measure"}) {
    const std::string who = "tumble " + command;
    expect_error(shop.run({command, "none.tumble"}), 2, who, {"none.tumble", "No such file"});
    expect_error(shop.run({command, "."}), 2, who, {"folder"});
    expect_error(shop.run({command, "s.toml"}), 2, who, {"s.toml", "not a log", "'tumble record FILE'"});
  }
  expect_error(shop.run({"dump", "s.toml", "--step", "0"}), 2, "tumble dump", {"not a log"});
  expect_error(shop.run({"diff", "good.tumble", "s.toml"}), 2, "tumble diff", {"s.toml", "not a log"});
}

TEST(BadLog, FutureVersionsAreBadInput) {
  const Workshop shop;
  shop.record_small("s");
  std::string bytes = shop.read("s.tumble");
  bytes[16] = 99;                                // the major version, at the same place in every version;
  bytes[70] = static_cast<char>(bytes[70] ^ 1);  // what follows may be anything there
  shop.write("s.tumble", bytes);
  for (const std::string command : {"info", "replay", "measure"}) {
    expect_error(shop.run({command, "s.tumble"}), 2, "tumble " + command, {"99"});
  }
}

TEST(BadLog, EmptyAndHeadlessFilesAreDamaged) {
  const Workshop shop;
  shop.record_small("s");
  shop.write("empty.tumble", "");
  shop.write("head.tumble", shop.read("s.tumble").substr(0, 60));
  for (const std::string command : {"info", "replay", "measure"}) {
    expect_error(shop.run({command, "empty.tumble"}), 3, "tumble " + command, {"empty"});
    expect_error(shop.run({command, "head.tumble"}), 3, "tumble " + command, {"head.tumble"});
  }
}

// A session of several chunks, cut inside the last one.
void write_torn(const Workshop& shop, const std::string& name) {
  shop.record_small("s", {"--steps", "600", "--set", "world.freezing=false"});
  const std::string bytes = shop.read("s.tumble");
  shop.write(name, bytes.substr(0, bytes.size() * 3 / 4));
}

TEST(BadLog, TornTailIsStatusThreeAndTheWholePartIsUsed) {
  const Workshop shop;
  write_torn(shop, "torn.tumble");
  const Outcome replayed = shop.run({"replay", "torn.tumble", "--json"});
  expect_error(replayed, 3, "tumble replay", {"torn.tumble", "torn", "complete up to byte"});
  EXPECT_NE(replayed.out.find("\"identical\": true"), std::string::npos) << replayed.out;
  const Outcome measured = shop.run({"measure", "torn.tumble", "--json"});
  expect_error(measured, 3, "tumble measure", {"torn"});
  EXPECT_NE(measured.out.find("final_hash"), std::string::npos);
  const Outcome dumped = shop.run({"dump", "torn.tumble", "--step", "1", "--csv"});
  expect_error(dumped, 3, "tumble dump", {"torn"});
  EXPECT_EQ(std::ranges::count(dumped.out, '\n'), 3);
  const Outcome info = shop.run({"info", "torn.tumble", "--json"});
  expect_error(info, 3, "tumble info", {"torn"});
  EXPECT_NE(info.out.find("\"torn\": true"), std::string::npos);
  const Outcome diffed = shop.run({"diff", "s.tumble", "torn.tumble", "--json"});
  expect_error(diffed, 3, "tumble diff", {"torn"});
  EXPECT_NE(diffed.out.find("\"field\": \"steps\""), std::string::npos) << "the shorter one: " << diffed.out;
}

TEST(BadLog, FlippedByteIsDamageAndNamedByItsPlace) {
  const Workshop shop;
  shop.record_small("s");
  const std::string good = shop.read("s.tumble");
  for (const std::size_t place : {std::size_t{200}, good.size() / 2, good.size() - 40}) {
    std::string bytes = good;
    bytes[place] = static_cast<char>(bytes[place] ^ 0x10);
    shop.write("bad.tumble", bytes);
    expect_error(shop.run({"info", "bad.tumble"}), 3, "tumble info", {"bad.tumble", "byte"});
    expect_error(shop.run({"replay", "bad.tumble"}), 3, "tumble replay", {"bad.tumble"});
  }
}

TEST(BadSteps, AreNamedWithTheRangeThereIs) {
  const Workshop shop;
  shop.record_small("s");
  const auto dump = [&](const Words& more) {
    Words words = {"dump", "s.tumble"};
    words.insert(words.end(), more.begin(), more.end());
    return shop.run(words);
  };
  expect_error(dump({"--step", "41"}), 2, "tumble dump", {"no step 41", "0 to 40"});
  expect_error(dump({"--steps", "30:50"}), 2, "tumble dump", {"no step 50", "0 to 40"});
  expect_error(dump({"--steps", "5:3"}), 2, "tumble dump", {"\"5:3\"", "A:B"});
  expect_error(dump({"--steps", "5"}), 2, "tumble dump", {"\"5\"", "A:B"});
  expect_error(dump({}), 2, "tumble dump", {"--step K"});
  expect_error(dump({"--step", "1", "--steps", "1:2"}), 2, "tumble dump", {"--step", "--steps"});
  expect_error(dump({"--step", "1", "--csv", "--json"}), 2, "tumble dump", {"--csv", "--json"});
  expect_error(dump({"--step", "4", "--body", "3"}), 2, "tumble dump", {"no body 3 at step 4"});
}

TEST(BadTolerance, IsNamedWithTheFieldsThereAre) {
  const Workshop shop;
  shop.record_small("s");
  const auto diff = [&](const std::string& tolerance) {
    return shop.run({"diff", "s.tumble", "s.tumble", "--tolerance", tolerance});
  };
  expect_error(diff("position"), 2, "tumble diff", {"--tolerance", "\"position\"", "FIELD=V"});
  expect_error(diff("position=abc"), 2, "tumble diff", {"\"position=abc\"", "FIELD=V"});
  expect_error(diff("colour=1"), 2, "tumble diff", {"colour", "position, orientation, velocity or spin"});
  expect_error(diff("spin=-1"), 2, "tumble diff", {"spin=-1", "from 0"});
  EXPECT_EQ(diff("spin=0.5").exit, 0);
}

}  // namespace
}  // namespace tumble::test
