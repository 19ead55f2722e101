// Phases feed hashers while they write; the words are those of their hash functions.
#include <gtest/gtest.h>

#include <map>
#include <span>
#include <string>
#include <vector>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"

namespace tumble::sim {
namespace {

using test::advance;

/// Compares the words that phases feed on the way with those of their hash functions, called when they are done.
class BothWays : public Observer {
 public:
  Hasher* phase_begins() override { return on_the_way_.phase_begins(); }
  void phase_done(std::uint32_t substep, std::size_t phase, const World& world) override {
    if (world.scratch().fed_hasher != nullptr) ++fed_[phase_table(world.state().def.method).phases[phase].name];
    on_the_way_.phase_done(substep, phase, world);
    afterwards_.phase_done(substep, phase, world);
    EXPECT_EQ(on_the_way_.words(), afterwards_.words())
        << "step " << world.state().step + 1 << ", " << phase_table(world.state().def.method).phases[phase].name;
  }
  void clear() {
    on_the_way_.clear();
    afterwards_.clear();
  }
  [[nodiscard]] const std::map<std::string, int>& fed() const { return fed_; }

 private:
  PhaseHashes on_the_way_, afterwards_;
  std::map<std::string, int> fed_;  // by phase, how often
};

TEST(PhaseHashes, AreTheSameOnTheWayAndAfterwards) {
  SceneDef hit = test::wall(5, 6);
  test::add_thrown_cube(hit);
  SceneDef spinning = test::on_ground();
  spinning.boxes = {test::cube(1, {0, 0, 0.6})};
  spinning.boxes[0].spin = {20, 3, 1};
  BothWays both;
  for (SceneDef& scene : std::vector{hit, spinning, test::tumble_of_boxes(3, 5), test::plates_and_bars(12, 5)}) {
    for (const std::uint32_t substeps : {1U, 2U}) {
      scene.world.method = Method::kLayered;
      scene.world.substeps = substeps;
      World world = test::made(scene);
      for (int k = 0; k < 40; ++k) {
        both.clear();
        advance(world, &both);
      }
    }
  }
  for (const char* phase : {"find_near_pairs", "find_manifolds", "prepare_manifolds", "part_overlaps",
                            "integrate_positions", "bounce_contacts", "finish_motion"}) {
    EXPECT_GT(both.fed().contains(phase) ? both.fed().at(phase) : 0, 0) << phase;
  }
}

// Long input is hashed with the widest instructions that the machine has, and in one piece without.
TEST(PhaseHashes, AreTheSameWithAnyInstructions) {
  std::vector<std::uint8_t> bytes(100'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i >> 3U);
  for (const std::size_t count : {0U, 3U, 240U, 256U, 257U, 1024U, 5000U, 99'999U}) {
    Hasher hasher;
    hasher.add(std::span(bytes).first(count / 3));
    hasher.add(std::span(bytes).first(count).subspan(count / 3));
    EXPECT_EQ(hasher.digest(), hash_bytes(std::as_bytes(std::span(bytes).first(count)))) << count;
  }
}

TEST(Counters, ContactsOfMethodLayeredAreThePointsThatWereSolved) {
  SceneDef scene = test::tower(3);
  scene.world.method = Method::kLayered;
  World world = test::made(scene);
  EXPECT_EQ(advance(world).contacts, 12U) << "four corners under each of three cubes";
}

}  // namespace
}  // namespace tumble::sim
