#pragma once

// For the tests that change what a phase writes, one field at a time: the hash of the phase has to notice.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"

namespace tumble::sim {

/// A field that a phase writes, and a change of it: by a bit that no later phase would round away.
struct Field {
  const char* phase;
  const char* name;
  std::function<void(World& world)> change;
};

/// After each phase, once in a step: tries all of its fields on a copy of the world.
class Changer : public Observer {
 public:
  explicit Changer(std::vector<Field> fields) : fields_(std::move(fields)) {}

  void phase_done(std::uint32_t /*substep*/, std::size_t phase, const World& world) override {
    const Phase& of = phase_table(world.state().def.method).phases[phase];
    for (const Field& field : fields_) {
      if (std::string(field.phase) != of.name) continue;
      World other = world;
      field.change(other);
      EXPECT_NE(hash(of, other), hash(of, world)) << field.phase << ": " << field.name;
      ++tried_[std::string(field.phase) + ' ' + field.name];
    }
  }
  void expect_all_tried() const { EXPECT_EQ(tried_.size(), fields_.size()); }

 private:
  static Hash128 hash(const Phase& phase, const World& world) {
    Hasher hasher;
    phase.hash(world.state(), world.scratch(), hasher);
    return hasher.digest();
  }

  std::vector<Field> fields_;
  std::map<std::string, int> tried_;
};

/// Uneven boxes in a heap, in their step 61: one that ends with a bounce, and has a past to carry along.
inline void try_all(Method method, const std::vector<Field>& fields) {
  SceneDef scene = test::tumble_of_boxes(3, 5);
  scene.world.method = method;
  World world = test::made(scene);
  for (int k = 0; k < 40; ++k) test::advance(world);
  Changer changer(fields);
  test::advance(world, &changer);
  changer.expect_all_tried();
}

}  // namespace tumble::sim
