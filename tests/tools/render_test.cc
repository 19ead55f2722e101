// `tumble render` as a person runs it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/support/pictures.h"
#include "tests/support/program.h"
#include "tumble/render/png.h"

namespace tumble::test {
namespace {

// An environment variable for the programs run while it lives.
class Setting {
 public:
  Setting(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    setenv(name, value, 1);
  }
  ~Setting() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

class ToolsRender : public testing::Test {
 protected:
  void SetUp() override { shop_.record_small("s"); }

  render::PngFile drawn(std::vector<std::string> more, const std::string& name = "x.png") {
    std::vector<std::string> arguments = {"render", "s.tumble", "--size", size_, "--samples", "1", "-o", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = shop_.run(arguments);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    const auto read = render::read_png(shop_.path(name));
    EXPECT_TRUE(read.ok()) << read.error().message;
    return read.ok() ? *read : render::PngFile{};
  }

  /// Step 1 of an imported session; rows: those of its two steps.
  render::Image drawn_table(const std::string& name, const std::string& rows, std::string& said) {
    shop_.write(name + ".csv",
                "# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
                "orientation.z,velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z\n" +
                    rows);
    EXPECT_EQ(shop_.run({"import", name + ".csv"}).exit, 0);
    const Outcome outcome =
        shop_.run({"render", name + ".tumble", "--step", "1", "--size", size_, "--samples", "1", "-o", name + ".png"});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    said = outcome.err;
    return render::read_png(shop_.path(name + ".png"))->image;
  }

  std::string size_ = "96x64";
  Workshop shop_;
};

TEST_F(ToolsRender, ABodyWithoutANumberIsNotDrawnAndNamed) {
  const std::string start = "0,1,0,0,0.5,1,0,0,0,0,0,0,0,0,0\n0,2,2,0,0.5,1,0,0,0,0,0,0,0,0,0\n";
  const std::string rest = "1,1,0,0,0.5,1,0,0,0,0,0,0,0,0,0\n";
  std::string said;
  const render::Image without = drawn_table("without", start + rest, said);
  EXPECT_EQ(said, "");
  const render::Image spins = drawn_table("spins", start + rest + "1,2,2,0,0.5,1,0,0,0,0,0,0,0,nan,0\n", said);
  EXPECT_NE(said.find("step 1: body 2 is not drawn, because its spin.y is nan"), std::string::npos) << said;
  EXPECT_EQ(spins, without);
  EXPECT_EQ(drawn_table("far", start + rest + "1,2,2,0,inf,1,0,0,0,0,0,0,0,0,0\n", said), without);
}

TEST_F(ToolsRender, SaysInThePictureWhatItShows) {
  const render::PngFile file = drawn({"--step", "12", "--effects", "-bloom"});
  EXPECT_EQ(file.image.width, 96);
  EXPECT_EQ(file.image.height, 64);
  const std::map<std::string, std::string> text(file.text.begin(), file.text.end());
  EXPECT_EQ(text.at("Scene"), "s");
  EXPECT_EQ(text.at("Step"), "12");
  EXPECT_EQ(text.at("Effects"), "specular,shadow,dof,motion");
  EXPECT_EQ(text.at("State hash").size(), 32U);
  EXPECT_NE(drawn({"--step", "13"}).image, file.image) << "another step, the same picture";
}

// Every one is a process of its own: a driver reads its settings once, and two backends in a process cross over.
TEST_F(ToolsRender, GivesTheSamePixelsWhateverDrawsThem) {
  const render::Image expected = drawn({"--step", "20"}).image;
  EXPECT_EQ(drawn({"--step", "20"}).image, expected) << "from run to run";
  for (const char* threads : {"0", "1", "2"}) {
    const Setting setting("LP_NUM_THREADS", threads);
    EXPECT_EQ(drawn({"--step", "20"}).image, expected) << threads << " threads";
  }
  for (const char* width : {"128", "256"}) {
    const Setting setting("LP_NATIVE_VECTOR_WIDTH", width);
    EXPECT_EQ(drawn({"--step", "20"}).image, expected) << "vectors of " << width << " bits";
  }
  EXPECT_EQ(drawn({"--step", "20", "--gl", "osmesa"}).image, expected) << "OSMesa";
  EXPECT_EQ(drawn({"--step", "20", "--gl", "egl"}).image, expected) << "EGL";
}

TEST_F(ToolsRender, NumbersPicturesByTheirStep) {
  const Outcome outcome =
      shop_.run({"render", "s.tumble", "--steps", "10:30", "--every", "10", "--size", "32x32", "-o", "frames"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(shop_.path("frames"))) ++count;
  EXPECT_EQ(count, 3U);
  for (const char* name : {"frames/frame_0010.png", "frames/frame_0020.png", "frames/frame_0030.png"}) {
    EXPECT_TRUE(std::filesystem::exists(shop_.path(name))) << name;
  }
}

TEST_F(ToolsRender, CallsAPictureAfterItsLog) {
  ASSERT_EQ(shop_.run({"render", "s.tumble", "--step", "7", "--size", "32x32"}).exit, 0);
  EXPECT_TRUE(std::filesystem::exists(shop_.path("s_0007.png")));
}

TEST_F(ToolsRender, MakesMoviesOfBothKindsAndSlowMotion) {
  const Outcome mp4 = shop_.run({"render", "s.tumble", "-o", "s.mp4", "--size", "64x48", "--samples", "1", "--json"});
  ASSERT_EQ(mp4.exit, 0) << mp4.err;
  EXPECT_EQ(nlohmann::json::parse(mp4.out)["pictures"], 21) << "40 steps of 1/60 s at 30 frames a second";
  EXPECT_EQ(shop_.read("s.mp4").substr(4, 4), "ftyp");
  shop_.record_small("float", {"--set", "world.dt=0.01666666753590107"});
  const Outcome of_float = shop_.run({"render", "float.tumble", "-o", "f.mp4", "--size", "32x32", "--samples", "1"});
  EXPECT_NE(of_float.out.find("0 to 40 in 21 pictures"), std::string::npos) << of_float.out;
  const Outcome webm = shop_.run({"render", "s.tumble", "-o", "s.webm", "--size", "64x48", "--samples", "1", "--steps",
                                  "0:4", "--speed", "0.25", "--json"});
  ASSERT_EQ(webm.exit, 0) << webm.err;
  EXPECT_EQ(nlohmann::json::parse(webm.out)["pictures"], 9) << "every other frame lies between two states";
  EXPECT_EQ(shop_.read("s.webm").substr(0, 4), "\x1A\x45\xDF\xA3");
  EXPECT_TRUE(shop_.names_with(".part").empty());
}

TEST_F(ToolsRender, SaysThatMoviesNeedFfmpeg) {
  const Setting path("PATH", "");
  const Outcome outcome = shop_.run({"render", "s.tumble", "-o", "s.mp4", "--size", "64x48"});
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_NE(outcome.err.find("ffmpeg"), std::string::npos) << outcome.err;
}

TEST_F(ToolsRender, ReportsAMovieThatCannotBeWritten) {
  const Outcome outcome = shop_.run({"render", "s.tumble", "-o", "no/such/folder/s.mp4", "--size", "64x48"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_NE(outcome.err.find("s.mp4"), std::string::npos) << outcome.err;
}

TEST_F(ToolsRender, ColoursWhatDiffersFromAnotherLog) {
  size_ = "480x320";
  shop_.record_small("same");
  shop_.record_small("other", {"--set", "world.gravity=[0, 0, -4]"});  // its boxes are still high above those of s
  const auto orange = [](int r, int g, int b) { return r > 120 && r > g + 50 && g > b + 20; };
  const auto blue = [](int r, int g, int b) { return b > 120 && b > r + 60 && b > g + 30; };
  const auto at_30 = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"--step", "30", "--effects", "shadow"};
    words.insert(words.end(), more.begin(), more.end());
    return drawn(words).image;
  };
  const render::Image alone = at_30({}), both = at_30({"--compare", "other.tumble"});
  EXPECT_EQ(at_30({"--compare", "same.tumble"}), alone);
  EXPECT_EQ(count_pixels(alone, blue), 0U);
  EXPECT_GT(count_pixels(both, blue), 200U);
  EXPECT_GT(count_pixels(both, orange), count_pixels(alone, orange) + 200U);
}

TEST_F(ToolsRender, ShowsBoundsContactsVelocitiesAndFreezing) {
  size_ = "480x360";
  const render::Image plain = drawn({"--step", "30"}).image;
  const auto contact = [](int r, int g, int b) { return r > 230 && g < 90 && b > 90 && b < 160; };
  const auto arrow = [](int r, int g, int b) { return r > 240 && g > 200 && b < 30; };
  EXPECT_EQ(count_pixels(plain, contact) + count_pixels(plain, arrow), 0U);
  EXPECT_GT(count_pixels(drawn({"--step", "30", "--show", "contacts"}).image, contact), 0U);
  EXPECT_GT(count_pixels(drawn({"--step", "30", "--show", "velocities"}).image, arrow), 0U);
  const auto bound = [](int r, int g, int b) { return b > 220 && r < 60 && g < 120; };
  EXPECT_EQ(count_pixels(plain, bound), 0U);
  EXPECT_GT(count_pixels(drawn({"--step", "30", "--show", "bounds"}).image, bound), 500U);
  EXPECT_GT(difference(plain, drawn({"--step", "30", "--show", "freezing"}).image).far_off, 50U);
}

// A build of another version takes other steps, whose contacts would be drawn over the states of the log.
TEST_F(ToolsRender, DrawsNoContactsOfAnotherSession) {
  const std::string older = TUMBLE_SOURCE_DIR "/tests/data/format_1.3_methods_10_layered.tumble";
  EXPECT_EQ(shop_.run({"render", older, "--size", "96x64", "-o", "x.png"}).exit, 0);
  const Outcome outcome = shop_.run({"render", older, "--size", "96x64", "--show", "contacts", "-o", "x.png"});
  EXPECT_EQ(outcome.exit, 4) << outcome.out;
  EXPECT_NE(outcome.err.find("this build computes another state of step 40"), std::string::npos) << outcome.err;
}

TEST_F(ToolsRender, SaysThatTheOtherLogIsTorn) {
  const std::string whole = shop_.read("s.tumble");
  shop_.write("torn.tumble", whole.substr(0, whole.size() - 20));
  const Outcome outcome =
      shop_.run({"render", "s.tumble", "--compare", "torn.tumble", "--step", "3", "--size", "96x64"});
  EXPECT_EQ(outcome.exit, 3);
  EXPECT_NE(outcome.err.find("torn.tumble: torn"), std::string::npos) << outcome.err;
}

TEST_F(ToolsRender, TakesAnotherCamera) {
  const render::Image scenes = drawn({"--step", "12"}).image;
  EXPECT_EQ(drawn({"--step", "12", "--camera", "position=12,-16,8", "--camera", "target=0,0,2"}).image, scenes)
      << "the camera of a scene without one";
  const render::Image near = drawn({"--step", "12", "--camera", "position=3,-6,3"}).image;
  EXPECT_GT(difference(near, scenes).far_off, 500U);
  EXPECT_EQ(drawn({"--step", "12", "--camera", "position=3,-6,3", "--camera", "focus=6.782329983125268"}).image, near)
      << "the distance to the target is in focus";
  EXPECT_NE(drawn({"--step", "12", "--camera", "position=3,-6,3", "--camera", "focus=40"}).image, near);
}

TEST_F(ToolsRender, TakesTheCameraOfAnImportedTable) {
  shop_.write("t.csv",
              "# dt: 0.01\n# up: y\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
              "orientation.z,velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z\n0,1,0,0.5,0,1,0,0,0,0,0,0,0,0,0\n");
  const auto make_log = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"import", "t.csv", "-o", "s.tumble"};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  };
  ASSERT_EQ(make_log({}).exit, 0);
  const render::Image moved = drawn({"--camera", "position=3,-6,3", "--camera", "target=0,0,1"}).image;
  EXPECT_NE(drawn({}).image, moved);
  const Outcome outcome = make_log({"--header", "camera.position: 3 3 6", "--header", "camera.target: 0 1 0"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(drawn({}).image, moved) << "in the table's axes";
  const Outcome wrong = make_log({"--header", "camera.fov: 500"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_NE(wrong.err.find("camera fov: found 500, wanted a number from 1 to 170"), std::string::npos) << wrong.err;
}

TEST_F(ToolsRender, IsSharpWhereTheCameraLooksUnlessTheSceneSaysMore) {
  const std::vector<std::string> close = {"--set", "camera.position=[3, -6, 3]", "--set", "camera.target=[0, 0, 1]"};
  const auto picture = [&](std::vector<std::string> more) {
    more.insert(more.begin(), close.begin(), close.end());
    shop_.record_small("s", more);
    return drawn({"--step", "0"}).image;
  };
  const render::Image sharp = picture({"--set", "camera.blur=0"});
  EXPECT_EQ(picture({}), picture({"--set", "camera.focus=7"}));
  EXPECT_LT(difference(picture({}), sharp).far_off, difference(picture({"--set", "camera.focus=18"}), sharp).far_off);
}

TEST_F(ToolsRender, RefusesWhatItCannotDo) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--step", "41"}, "holds steps 0 to 40"},
      {{"--steps", "5:1"}, "wanted"},
      {{"--steps", "0:4"}, "wanted -o"},
      {{"--steps", "0:4", "-o", "x.png"}, "one .png holds one picture"},
      {{"--size", "640"}, "as in 640x480"},
      {{"--size", "9x9"}, "as in 640x480"},
      {{"--size", "99999x480"}, "as in 640x480"},
      {{"--effects", "glitter"}, "unknown word"},
      {{"--pass", "seventh"}, "wanted one of depth"},
      {{"--show", "hidden"}, "bounds, contacts, freezing or velocities"},
      {{"--gl", "vulkan"}, "auto, osmesa or egl"},
      {{"--samples", "5"}, "from 1 to 4"},
      {{"--step", "3", "--speed", "0.5"}, "excludes"},
      {{"--speed", "0"}, "above 0"},
      {{"--size", "65x48", "-o", "s.mp4"}, "even width and height"},
      {{"--compare", "missing.tumble"}, "missing.tumble"},
      {{"-o", "s.tumble"}, "FOLDER/ for pictures"},
      {{"-o", "s.toml"}, "FOLDER/ for pictures"},
      {{"-o", "x.gif"}, "FILE.mp4 or FILE.webm"},
      {{"-o", "x.JPG"}, "wanted FILE.png for a picture"},
      {{"-o", "x.PNG"}, "wanted FILE.png for a picture"},
      {{"--camera", "zoom=2"}, "position, target, fov, focus or blur"},
      {{"--camera", "position"}, "wanted KEY=VALUE"},
      {{"--camera", "position=1,2"}, "three coordinates"},
      {{"--camera", "position=3-8-4"}, "three coordinates"},
      {{"--camera", "position=3,,8,4"}, "three coordinates"},
      {{"--camera", "position=3,8,4,"}, "three coordinates"},
      {{"--speed", "1e-300", "-o", "s.mp4"}, "found more than 1000000 frames"},
      {{"--speed", "1e-322", "-o", "s.mp4"}, "found more than 1000000 frames"},
      {{"--camera", "position=0,0,2", "--camera", "target=0,0,2"}, "no direction to look in"},
      {{"-o", "no/such/x.png"}, "cannot be written"},
      {{"-o", "/dev/null"}, "is no folder to draw into"},
  };
  for (const auto& [more, phrase] : cases) {
    std::vector<std::string> arguments = {"render", "s.tumble"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = shop_.run(arguments);
    EXPECT_EQ(outcome.exit, 2) << phrase;
    EXPECT_NE(outcome.err.find(phrase), std::string::npos) << phrase << " is not in: " << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
}  // namespace tumble::test
