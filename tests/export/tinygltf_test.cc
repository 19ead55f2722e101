// glTF read back by tinygltf: every pose of every step is the float of the log's.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "tests/support/program.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {
namespace {

std::vector<float> floats_of(const tinygltf::Model& model, int accessor) {
  const tinygltf::Accessor& about = model.accessors.at(static_cast<std::size_t>(accessor));
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(about.bufferView));
  const auto width = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(about.type)));
  std::vector<float> floats(about.count * width);
  const std::vector<unsigned char>& bytes = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
  EXPECT_LE(view.byteOffset + about.byteOffset + floats.size() * 4, bytes.size());
  std::memcpy(floats.data(), bytes.data() + view.byteOffset + about.byteOffset, floats.size() * 4);
  return floats;
}

/// Floats of a path by the id of the body.
std::map<std::uint64_t, std::vector<float>> tracks(const tinygltf::Model& model, const std::string& path) {
  std::map<std::uint64_t, std::vector<float>> by_body;
  const tinygltf::Animation& animation = model.animations.at(0);
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    if (channel.target_path != path) continue;
    const tinygltf::Node& node = model.nodes.at(static_cast<std::size_t>(channel.target_node));
    const auto id = static_cast<std::uint64_t>(node.extras.Get("id").GetNumberAsInt());
    const int output = animation.samplers.at(static_cast<std::size_t>(channel.sampler)).output;
    by_body.emplace(id, floats_of(model, output));
  }
  return by_body;
}

TEST(Gltf, TinygltfReadsEveryPose) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"record", "layered_inputs", "-o", "a.tumble"}).exit, 0);
  ASSERT_EQ(shop.run({"export", "a.tumble", "-o", "a.glb"}).exit, 0);
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string error, warning;
  ASSERT_TRUE(reader.LoadBinaryFromFile(&model, &error, &warning, shop.path("a.glb"))) << error;
  EXPECT_TRUE(error.empty() && warning.empty()) << error << warning;
  EXPECT_EQ(model.cameras.size(), 1U);
  EXPECT_EQ(model.lights.size(), 1U);
  const auto translations = tracks(model, "translation"), rotations = tracks(model, "rotation"),
             scales = tracks(model, "scale");
  Result<replay::LogReader> log = replay::LogReader::open(shop.path("a.tumble"));
  ASSERT_TRUE(log.ok());
  std::size_t compared = 0;
  for (std::uint64_t k = 0; k <= log->last_step(); ++k) {
    const Result<const replay::StepRecord*> step = log->read_step(k);
    ASSERT_TRUE(step.ok());
    const replay::BodyStates& states = (*step)->states;
    for (std::size_t i = 0; i < states.size(); ++i, ++compared) {
      const std::vector<float>& at = translations.at(states.id[i]);
      const std::vector<float>& turn = rotations.at(states.id[i]);
      EXPECT_EQ(at[3 * k], static_cast<float>(states.position.x[i]));
      EXPECT_EQ(at[3 * k + 1], static_cast<float>(states.position.y[i]));
      EXPECT_EQ(at[3 * k + 2], static_cast<float>(states.position.z[i]));
      EXPECT_NEAR(turn[4 * k + 3], states.orientation.w[i], 1e-6);
      EXPECT_NEAR(turn[4 * k], states.orientation.x[i], 1e-6);
    }
  }
  EXPECT_GT(compared, 1000U);
  EXPECT_FALSE(scales.empty());  // the body that is thrown in
}

TEST(Gltf, RefusesWhatIsNotFiniteWithBodyAndStep) {
  const Workshop shop;
  shop.write("m.csv",
             "# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
             "orientation.z\n0,hip,0,0,1,1,0,0,0\n0,knee,1,0,1,1,0,0,0\n1,hip,0,0,1,1,0,0,0\n1,knee,1,inf,1,1,0,0,0\n");
  ASSERT_EQ(shop.run({"import", "m.csv", "-o", "m.tumble"}).exit, 0);
  const Outcome run = shop.run({"export", "m.tumble", "-o", "m.glb"});
  EXPECT_EQ(run.exit, 2);
  EXPECT_NE(run.err.find("(knee) at step 1: position.y is inf"), std::string::npos) << run.err;
  EXPECT_TRUE(shop.names_with("m.glb").empty());
  EXPECT_EQ(shop.run({"export", "m.tumble", "-o", "m.glb", "--bodies", "hip"}).exit, 0);
  EXPECT_EQ(shop.run({"export", "m.tumble", "-o", "m.glb", "--steps", "0:0"}).exit, 0);
}

}  // namespace
}  // namespace tumble::test
