// Archives of arrays as numpy writes them: to the bit, stored or compressed; what differs is found, what is wrong is
// said.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "replay/arrays/array_table.h"
#include "replay/import/csv/import_csv.h"
#include "replay/log/byte_memory.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"

namespace tumble::replay {
namespace {

// tests/data/robot.npz and robot_packed.npz, by numpy 1.24: savez() and savez_compressed() of two bodies over 30 steps
// with angle (30, 2) of float32, seed (30,) of uint64 and ctrl (30, 3).
std::string file_text(const std::string& name) {
  std::ifstream file(std::string(TUMBLE_SOURCE_DIR) + "/tests/data/" + name, std::ios::binary);
  EXPECT_TRUE(file.good()) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Array> robot() {
  Result<std::vector<Array>> arrays = read_npz(file_text("robot.npz"), "robot.npz");
  EXPECT_TRUE(arrays.ok()) << arrays.error().message;
  return *std::move(arrays);
}

Result<LogReader> import(const std::vector<Array>& arrays, const ArrayOptions& options = {}) {
  const Result<std::string> text = table_of_arrays(arrays, "t.npz", options);
  if (!text.ok()) return text.error();
  const MemoryFile file = std::make_shared<std::vector<std::byte>>();
  const auto sink = [&]() -> Result<std::unique_ptr<ByteSink>> {
    return std::unique_ptr<ByteSink>(std::make_unique<MemoryByteSink>(file, "t.tumble"));
  };
  const Result<LogSummary> summary = import_csv(*text, "t.npz", sink, {{"dt: 0.01"}, {}, {}, {}});
  if (!summary.ok()) return summary.error();
  return LogReader::open(std::make_unique<MemoryByteSource>(file, "t.tumble"));
}

Array& of_name(std::vector<Array>& arrays, const std::string& name) {
  return *std::ranges::find(arrays, name, &Array::name);
}

TEST(ImportArrays, StoredAndCompressedAreOneSession) {
  const Result<std::vector<Array>> packed = read_npz(file_text("robot_packed.npz"), "robot_packed.npz");
  ASSERT_TRUE(packed.ok()) << packed.error().message;
  std::vector<Array> plain = robot(), other = *packed;
  std::erase_if(plain, [](const Array& a) { return a.name == "dt"; });
  std::erase_if(other, [](const Array& a) { return a.name == "dt"; });
  Result<LogReader> a = import(plain), b = import(other);
  ASSERT_TRUE(a.ok()) << a.error().message;
  ASSERT_TRUE(b.ok()) << b.error().message;
  EXPECT_TRUE(diff_logs(*a, *b)->identical());
  EXPECT_EQ(a->last_step(), 29U);
  EXPECT_EQ(to_string(*a->header().engine), "robot");
  const StepRecord& step = **a->read_step(12);
  const std::size_t seed = a->header().declared.find("seed");
  EXPECT_EQ(step.extras.values(seed).bits.at(0), (1ULL << 63U) + 7);
  EXPECT_EQ(a->bodies().name(step.states.id[0]).size() + a->bodies().name(step.states.id[1]).size(), 7U);
}

TEST(ImportArrays, AJointASeedAndAControlThatDifferAreFound) {
  const auto difference = [](const std::string& name, std::size_t byte) {
    std::vector<Array> changed = robot();
    of_name(changed, name).data[byte] ^= 1;
    Result<LogReader> a = import(robot()), b = import(changed);
    EXPECT_TRUE(a.ok() && b.ok());
    return *diff_logs(*a, *b)->first;
  };
  const Divergence angle = difference("angle", std::size_t{12} * 2 * 4 + 4);
  EXPECT_EQ(angle.field, "channel.angle");
  EXPECT_EQ(angle.step, 12U);
  EXPECT_TRUE(angle.body.has_value());
  const Divergence seed = difference("seed", std::size_t{17} * 8);
  EXPECT_EQ(seed.field, "channel.seed");
  EXPECT_EQ(seed.step, 17U);
  const Divergence control = difference("ctrl", (std::size_t{20} * 3 + 1) * 8);
  EXPECT_EQ(control.field, "channel.ctrl.1");
  EXPECT_EQ(control.step, 20U);
}

TEST(ImportArrays, QposTakesTheNamesOfItsModel) {
  const char* model = R"(<mujoco><default><default class="rail"><joint type="slide"/></default></default>
    <worldbody><body name="torso"><freejoint name="root"/>
      <body name="leg"><joint name="hip" type="ball"/><joint class="rail"/><!-- <joint/> -->
        <body name="foot"><joint name="knee"/></body></body></body></worldbody></mujoco>)";
  const Result<std::vector<MujocoJoint>> joints = read_mujoco_joints(model, "m.xml");
  ASSERT_TRUE(joints.ok()) << joints.error().message;
  ASSERT_EQ(joints->size(), 4U);
  EXPECT_EQ((*joints)[0].kind, MujocoJoint::Kind::kFree);
  EXPECT_EQ((*joints)[2].kind, MujocoJoint::Kind::kSlide);
  EXPECT_EQ((*joints)[2].name, "joint 2");
  Array qpos;
  qpos.name = "qpos";
  qpos.shape = {2, 13};
  for (int i = 0; i < 26; ++i) {
    const double value = i % 13 == 3 ? 1 : (i % 13 > 3 && i % 13 < 7 ? 0 : 0.5 * i);
    qpos.data.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  Result<LogReader> log = import({qpos}, {false, *joints});
  ASSERT_TRUE(log.ok()) << log.error().message;
  const Declared& declared = log->header().declared;
  EXPECT_EQ(declared.channels.size(), 13U);
  ASSERT_LT(declared.find("qpos.knee"), 13U);
  EXPECT_LT(declared.find("qpos.hip.3"), 13U);
  EXPECT_EQ(
      std::get<double>((*log->read_step(1))->extras.values(declared.find("qpos.knee")).value(0, ChannelKind::kFloat64)),
      12.5);
  EXPECT_EQ((*log->read_step(1))->states.position[0], sim::Vec3(6.5, 7, 7.5));
  EXPECT_EQ(log->bodies().bodies().begin()->second.name, "torso");
  qpos.shape = {2, 12};
  qpos.data.resize(2 * 12 * 8);
  EXPECT_NE(import({qpos}, {false, *joints}).error().message.find("wanted (2, 13), as the joints of --model give"),
            std::string::npos);
}

TEST(ImportArrays, ErrorsNameTheArray) {
  const auto error_of = [](const std::vector<Array>& arrays) {
    const Result<LogReader> log = import(arrays);
    return log.ok() ? "no error" : log.error().message;
  };
  std::vector<Array> arrays = robot();
  of_name(arrays, "velocity").shape = {30, 3, 2};
  EXPECT_NE(error_of(arrays).find("t.npz: array velocity: found the shape (30, 3, 2), wanted (30, 2, 3)"),
            std::string::npos);
  arrays = robot();
  of_name(arrays, "ctrl").shape = {3, 30};
  EXPECT_NE(error_of(arrays).find("array ctrl: found the shape (3, 30), wanted 30 steps first"), std::string::npos);
  std::erase_if(arrays, [](const Array& a) { return a.name == "position"; });
  EXPECT_NE(error_of(arrays).find("found no positions of bodies"), std::string::npos);
  EXPECT_FALSE(read_mujoco_joints("<mujoco/>", "m.xml").ok());
  EXPECT_FALSE(read_mujoco_joints("no xml", "m.xml").ok());
}

template <class Number>
Array array_of(const std::string& name, Array::Kind kind, const std::vector<Number>& numbers) {
  Array array;
  array.name = name;
  array.kind = kind;
  array.item_bytes = sizeof(Number);
  array.shape = {numbers.size()};
  array.data.assign(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  return array;
}

TEST(ImportArrays, ThreeNumbersOfAKeyAreALineOfTheHeader) {
  std::vector<Array> arrays = robot();
  arrays.push_back(array_of("gravity", Array::Kind::kFloat, std::vector<double>{0, 0.5, -1.625}));
  Result<LogReader> moon = import(arrays);
  ASSERT_TRUE(moon.ok()) << moon.error().message;
  EXPECT_EQ(moon->header().scene.world.gravity, sim::Vec3(0, 0.5, -1.625));
  for (const Channel& channel : moon->header().declared.channels) EXPECT_NE(channel.name, "gravity");
}

TEST(ImportArrays, MessagesNameStepAndBodyAndNoLine) {
  const auto said = [](const Array& more) {
    std::vector<Array> arrays = robot();
    std::erase_if(arrays, [&](const Array& a) { return a.name == more.name || a.name == "body_names"; });
    arrays.push_back(more);
    const Result<LogReader> log = import(arrays);
    return log.ok() ? "no error" : log.error().message;
  };
  const auto numbers = [](const std::string& name, const std::vector<double>& values) {
    return array_of(name, Array::Kind::kFloat, values);
  };
  EXPECT_TRUE(said(numbers("mass", {1, -1})).starts_with("t.npz: step 0, body ")) << said(numbers("mass", {1, -1}));
  EXPECT_TRUE(said(array_of("id", Array::Kind::kUnsigned, std::vector<std::uint64_t>{4, 4}))
                  .starts_with("t.npz: step 0: found body"));
  std::vector<double> clock(30);
  for (std::size_t k = 0; k < clock.size(); ++k) clock[k] = k == 7 ? 1 : 0.01 * static_cast<double>(k);
  EXPECT_TRUE(said(numbers("time", clock)).starts_with("t.npz: ")) << said(numbers("time", clock));
  EXPECT_EQ(said(numbers("time", clock)).find("npz:1"), std::string::npos) << said(numbers("time", clock));
}

/// The robot with numbers for its bodies, and a force between them in steps 3 and 4.
std::vector<Array> robot_with_pairs() {
  using Wholes = std::vector<std::uint64_t>;
  std::vector<Array> arrays = robot();
  std::erase_if(arrays, [](const Array& a) { return a.name == "id" || a.name == "name" || a.name == "body_names"; });
  arrays.push_back(array_of("id", Array::Kind::kUnsigned, Wholes{7, 9}));
  arrays.push_back(array_of("pair.force", Array::Kind::kFloat, std::vector<double>{1.5, 2.5, 3.5}));
  arrays.push_back(array_of("step.pair.force", Array::Kind::kUnsigned, Wholes{4, 3, 3}));
  arrays.push_back(array_of("a.pair.force", Array::Kind::kUnsigned, Wholes{7, 9, 7}));
  arrays.push_back(array_of("b.pair.force", Array::Kind::kUnsigned, Wholes{9, 12, 9}));
  Array unit;
  unit.name = "unit.pair.force";
  unit.kind = Array::Kind::kBytes;
  unit.item_bytes = 1;
  unit.data = "N";
  arrays.push_back(unit);
  return arrays;
}

TEST(ImportArrays, ValuesOfPairsAreRowsInAnyOrder) {
  Result<LogReader> log = import(robot_with_pairs());
  ASSERT_TRUE(log.ok()) << log.error().message;
  const Declared& declared = log->header().declared;
  const std::size_t force = declared.find("force");
  ASSERT_LT(force, declared.channels.size());
  EXPECT_EQ(declared.channels[force].unit, "N");
  const ChannelValues third = (*log->read_step(3))->extras.values(force);
  ASSERT_EQ(third.size(), 2U);
  EXPECT_EQ(third.keys[0], (ChannelKey{7, 9}));
  EXPECT_EQ(std::get<double>(third.value(0, ChannelKind::kFloat64)), 3.5);
  EXPECT_EQ(third.keys[1], (ChannelKey{9, 12}));
  EXPECT_EQ((*log->read_step(4))->extras.values(force).size(), 1U);
  EXPECT_EQ((*log->read_step(5))->extras.values(force).size(), 0U);
}

TEST(ImportArrays, WrongPairsAndUnitsAreRefused) {
  const auto expect_error = [](const std::string& name, const std::string& part, const auto& damage) {
    std::vector<Array> arrays = robot_with_pairs();
    damage(of_name(arrays, name));
    const Result<LogReader> log = import(arrays);
    ASSERT_FALSE(log.ok()) << part;
    EXPECT_NE(log.error().message.find(part), std::string::npos) << log.error().message;
  };
  expect_error("a.pair.force", "array a.pair.force: found none", [](Array& a) { a.name = "_a"; });
  expect_error("step.pair.force", "row 0: found step 99", [](Array& a) { a.data[0] = 99; });
  expect_error("a.pair.force", "row 0: found body 99", [](Array& a) { a.data[0] = 99; });
  expect_error("b.pair.force", "found the shape (2), wanted numbers of (3)", [](Array& a) {
    a.shape = {2};
    a.data.resize(16);
  });
  expect_error("id", "wanted an array id of numbers", [](Array& a) {
    a.kind = Array::Kind::kBytes;
    a.item_bytes = 1;
    a.data = "ab";
  });
  expect_error("unit.pair.force", "array unit.pair.force: wanted one text", [](Array& a) { a.data = "\n"; });
  expect_error("unit.pair.force", "array unit.pair.force: wanted one text", [](Array& a) { a.shape = {1}; });
}

TEST(ImportArrays, DamagedArchivesAreRefusedAndNothingWorse) {
  for (const char* name : {"robot.npz", "robot_packed.npz"}) {
    const std::string whole = file_text(name);
    std::mt19937_64 random(7);
    std::size_t refused = 0;
    for (int k = 0; k < 400; ++k) {
      std::string hurt = whole;
      if (k % 4 == 0) hurt.resize(random() % whole.size());
      for (int n = 0; k % 4 != 0 && n < 1 + k % 3; ++n)
        hurt[random() % hurt.size()] ^= static_cast<char>(1U << random() % 8);
      refused += read_npz(hurt, name).ok() ? 0U : 1U;
    }
    EXPECT_GT(refused, 250U) << name;
  }
  EXPECT_NE(read_npz("PK", "t.npz").error().message.find("t.npz: is no archive"), std::string::npos);
}

TEST(ImportArrays, OfTwoArraysOfOneMeaningTheOneThatIsReadIsSaid) {
  std::vector<Array> arrays = robot_with_pairs();
  std::vector<std::string> warnings;
  ArrayOptions options;
  options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
  ASSERT_TRUE(import(arrays, options).ok());
  EXPECT_TRUE(warnings.empty());
  Array more = of_name(arrays, "position");
  more.name = "pos";
  arrays.push_back(more);
  ASSERT_TRUE(import(arrays, options).ok());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0],
            "t.npz: arrays position and pos have one meaning: position is read, and pos is kept as a channel; "
            "call it _pos to pass over it");
}

std::string npy(const std::string& type, const std::string& shape, const std::string& data) {
  const std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
  return "\x93NUMPY\x01" + std::string(1, '\0') + static_cast<char>(header.size()) + std::string(1, '\0') + header +
         data;
}

// 2^32 · 2^32 elements of one byte are 0 bytes in 64 bits: an empty array seemed to hold them.
TEST(ImportArrays, AShapeWhoseSizeOverflowsIsRefused) {
  for (const char* shape : {"(4294967296, 4294967296, 3)", "(4294967296, 1, 4294967297)"}) {
    EXPECT_FALSE(read_npy(npy("|u1", shape, ""), "position").ok()) << shape;
  }
  Result<Array> none = read_npy(npy("|u1", "(4294967296, 0, 3)", ""), "position");
  ASSERT_TRUE(none.ok()) << none.error().message;
  const Result<std::string> table = table_of_arrays({*none}, "t.npz", {});
  ASSERT_FALSE(table.ok());
  EXPECT_EQ(table.error().message, "t.npz: found 4294967296 steps of 0 bodies, wanted one of each");
}

TEST(ImportArrays, TwoArraysOfOneNameAreAnError) {
  std::string twice = file_text("robot.npz");
  for (std::size_t at = 0; (at = twice.find("ctrl.npy")) != std::string::npos;) twice.replace(at, 4, "seed");
  const Result<std::vector<Array>> arrays = read_npz(twice, "t.npz");
  ASSERT_FALSE(arrays.ok());
  EXPECT_EQ(arrays.error().message, "t.npz: array \"seed\": found twice in the archive, wanted once");
}

}  // namespace
}  // namespace tumble::replay
