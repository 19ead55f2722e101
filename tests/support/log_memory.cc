#include "tests/support/log_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tumble/sim/step.h"

namespace tumble::replay {

Result<std::size_t> MemorySink::write_some(std::span<const std::byte> bytes) {
  const std::uint64_t room = disk_->capacity - std::min<std::uint64_t>(disk_->capacity, disk_->bytes.size());
  const std::size_t count = std::min({bytes.size(), disk_->write_max, static_cast<std::size_t>(room)});
  if (count == 0) return cannot_finish("No space left on device");
  disk_->bytes.insert(disk_->bytes.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

Status MemorySink::sync() {
  if (disk_->sync_fails) return cannot_finish("Input/output error");
  return {};
}

Status MemorySource::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (offset > bytes_.size() || bytes.size() > bytes_.size() - offset)
    return damaged("memory.tumble: read past its end");
  if (!bytes.empty()) std::memcpy(bytes.data(), bytes_.data() + offset, bytes.size());
  return {};
}

sim::SceneDef small_scene(std::uint64_t steps, sim::Method method) {
  sim::SceneDef scene;
  scene.world.method = sim::Method::kThesis;
  scene.name = "small";
  scene.world.method = method;
  scene.steps = steps;
  for (std::uint64_t i = 0; i < 3; ++i) {
    sim::BoxDef box;
    box.id = 10 + i;
    box.size = {1, 1 + 0.25 * static_cast<double>(i), 1};
    box.position = {0.25 * static_cast<double>(i), 0, 0.5 + 1.125 * static_cast<double>(i)};
    box.frozen = i == 0;
    if (!box.frozen) box.spin = {0.5, 1, -0.25};
    scene.boxes.push_back(box);
  }
  return scene;
}

sim::SceneDef scene_with_inputs(std::uint64_t steps, sim::Method method) {
  sim::SceneDef scene = small_scene(steps, method);
  sim::BoxDef thrown;
  thrown.id = 5;  // before the others, so that every row moves
  thrown.position = {-6, 0, 2};
  thrown.velocity = {12, 0, 1};
  thrown.origin.kind = sim::Origin::Kind::kInput;
  sim::BoxDef late = thrown;
  late.id = 99;
  late.position = {6, 1, 3};
  late.velocity = {-9, 0, 0};
  scene.inputs = {
      {3, sim::Throw{thrown}},
      {3, sim::Push{11, {1, 0, 2}, true, {0, 0, 0}}},
      {5, sim::SetDt{1.0 / 100}},
      {7, sim::Push{12, {0, 1, 0}, false, {0.5, 0, 3}}},
      {9, sim::Wake{10}},
      {11, sim::SetVelocity{11, {0, 1, 3}, {1, 2, 3}}},
      {13, sim::SetGravity{{0.5, 0, -8}}},
      {17, sim::Remove{12}},
      {17, sim::Throw{late}},
      {21, sim::SetDt{1.0 / 30}},
  };
  return scene;
}

Bytes record_to_memory(const sim::SceneDef& scene, const RecordOptions& options, std::uint64_t flush_every) {
  const auto disk = std::make_shared<Disk>();
  auto recorder = Recorder::start(std::make_unique<MemorySink>(disk), scene, options);
  EXPECT_TRUE(recorder.ok()) << recorder.error().message;
  if (!recorder.ok()) return {};
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    const Status stepped = (*recorder)->step();
    EXPECT_TRUE(stepped.ok()) << stepped.error().message;
    if (k % flush_every != 0) continue;
    EXPECT_TRUE((*recorder)->flush().ok());
  }
  EXPECT_TRUE((*recorder)->finish().ok());
  return disk->bytes;
}

Result<LogReader> open_memory(Bytes bytes) { return LogReader::open(std::make_unique<MemorySource>(std::move(bytes))); }

std::vector<BodyStates> simulate(const sim::SceneDef& scene) {
  Result<sim::World> world = sim::create_world(scene);
  EXPECT_TRUE(world.ok());
  std::vector<BodyStates> states(scene.steps + 1);
  copy_visible(world->bodies(), states[0]);
  std::size_t next = 0;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    for (; next < scene.inputs.size() && scene.inputs[next].step == k; ++next) {
      EXPECT_TRUE(sim::apply(*world, scene.inputs[next].command).ok());
    }
    EXPECT_TRUE(sim::step(*world).ok());
    copy_visible(world->bodies(), states[k]);
  }
  return states;
}

}  // namespace tumble::replay
