// A warm step allocates nothing. Warm means: the world has made the same steps before. So a stretch of steps is made,
// the state put back, the stretch made again (some buffers change places from step to step, so both have grown then),
// the state put back once more, and of the third time every allocation counts. What grows in the first, because there
// are more contacts than ever before, is growth that no engine is spared.
#include "tests/support/allocations.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "src/world/memory_use.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::sim {
namespace {

struct Stretch {
  const char* name;
  SceneDef scene;
  int first = 0;  ///< steps made before
  int steps = 0;
};

/// Piles at rest, a tower, a grid whose rows land and fall apart, a tumble, thrown things that wake what sleeps, thin
/// plates with bars; each with one substep and with several.
std::vector<Stretch> stretches() {
  SceneDef awake = test::pile(3), heap = test::pile(3), hit = test::wall(3, 4), grid = test::tilted_grid(6);
  awake.world.freezing = false;
  test::jitter(heap, 0.05, 5);
  test::freeze_all(hit);
  test::add_thrown_cube(hit);
  std::vector<Stretch> all = {{"pile that rests", awake, 90, 20},
                              {"pile that goes to sleep", heap, 40, 120},
                              {"tower", test::tower(8), 30, 20},
                              {"tilted grid", grid, 30, 60},
                              {"tumble", test::tumble_of_boxes(3, 3), 20, 60},
                              {"wall that is hit", hit, 0, 60},
                              {"ramp", test::ramp(6, 2), 20, 60},
                              {"plates and bars", test::plates_and_bars(6, 3), 30, 60}};
  for (std::size_t k = 0, n = all.size(); k < n; ++k) {
    all[k].scene.world.substeps = 1;
    all.push_back(all[k]);
    all.back().scene.world.substeps = 4;
  }
  return all;
}

/// Two threads, one of which may come late: it goes on after a meeting only when the other one waits for it or has
/// finished, and so has done all that it could take over.
class LateWorkers : public Workers {
 public:
  static constexpr unsigned kNobody = 2;
  void set_late(unsigned part) { late_ = part; }

  [[nodiscard]] unsigned count() const override { return threads_.count(); }
  [[nodiscard]] std::size_t worth(std::size_t least) const override { return threads_.worth(least); }
  void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) override {
    parts_ = parts;
    for (Place& place : places_) place.meetings = 0;
    const auto work = [&](unsigned part) {
      places_[part].works = true;
      task(context, part);
      places_[part].works = false;
    };
    for_parts(&threads_, parts, work);
  }
  bool meet(unsigned part, bool any) override {
    Place &own = places_[part], &other = places_[1 - part];
    own.works = false;
    const bool met = threads_.meet(part, any);
    own.works = true;
    ++own.meetings;
    while (part == late_ && parts_ == 2 && (other.meetings < own.meetings || other.works)) std::this_thread::yield();
    return met;
  }
  void post(unsigned part, std::uint32_t number) override { threads_.post(part, number); }
  std::uint32_t await(unsigned part, unsigned other, std::uint32_t number) override {
    places_[part].works = false;
    const std::uint32_t last = threads_.await(part, other, number);
    places_[part].works = true;
    return last;
  }

 private:
  struct Place {
    std::atomic<std::uint32_t> meetings = 0;  // of the round
    std::atomic<bool> works = false;
  };
  WorkerThreads threads_{2, Split::kEverything};
  unsigned parts_ = 0, late_ = kNobody;
  Place places_[2];
};

void make_steps(World& world, int steps, Observer* observer) {
  for (int k = 0; k < steps; ++k) (void)test::advance(world, observer);
}

/// Which phase asked for memory, for a message.
class Culprits : public Observer {
 public:
  void phase_done(std::uint32_t /*substep*/, std::size_t phase, const World& world) override {
    const std::uint64_t now = test::allocations();
    const std::string name = std::string(" ") + phase_table(world.state().def.method).phases[phase].name;
    if (now != before_ && !names_.ends_with(name)) names_ += name;
    before_ = test::allocations();
  }
  [[nodiscard]] const std::string& names() const { return names_; }

 private:
  std::uint64_t before_ = test::allocations();
  std::string names_;
};

void expect_none(const Stretch& stretch, Method method, Observer* observer, LateWorkers* workers) {
  SceneDef scene = stretch.scene;
  scene.world.method = method;
  World world = test::made(scene);
  world.use(workers);
  make_steps(world, stretch.first, observer);
  const WorldState start = world.state();
  make_steps(world, stretch.steps, observer);
  const Hash128 end = continuation_hash(world.state());
  world.mutable_state() = start;
  make_steps(world, stretch.steps, observer);
  for (const unsigned late : {LateWorkers::kNobody, 0U, 1U}) {
    if (workers != nullptr) workers->set_late(late);
    world.mutable_state() = start;
    const std::uint64_t before = test::allocations();
    make_steps(world, stretch.steps, observer);
    const std::uint64_t made = test::allocations() - before;
    EXPECT_EQ(continuation_hash(world.state()), end) << "late: " << late;
    if (made > 0) {
      Culprits culprits;  // of threads these may be none: who came late has its memory now
      world.mutable_state() = start;
      make_steps(world, stretch.steps, &culprits);
      ADD_FAILURE() << made << " allocations in " << stretch.steps << " steps, late: " << late
                    << "; in the same steps once more:" << culprits.names();
    }
    if (workers == nullptr) return;
  }
  workers->set_late(LateWorkers::kNobody);
}

void expect_none_in_all(Method method, Observer* observer, LateWorkers* workers) {
  for (const Stretch& stretch : stretches()) {
    if (workers != nullptr && stretch.scene.world.substeps > 1) continue;  // takes long where processors are shared
    SCOPED_TRACE(std::string(stretch.name) + ", substeps: " + std::to_string(stretch.scene.world.substeps));
    expect_none(stretch, method, observer, workers);
  }
}

class Allocations : public testing::TestWithParam<Method> {};

TEST_P(Allocations, WarmStepsMakeNone) { expect_none_in_all(GetParam(), nullptr, nullptr); }

TEST_P(Allocations, WarmStepsMakeNoneWithPhaseHashes) {
  PhaseHashes hashes;
  expect_none_in_all(GetParam(), &hashes, nullptr);
}

TEST_P(Allocations, WarmStepsMakeNoneOnTwoThreads) {
  LateWorkers workers;
  expect_none_in_all(GetParam(), nullptr, &workers);
}

// Vectors that memory_use forgets would show: nothing else is held. malloc rounds up a little, and what it maps by
// whole pages.
TEST_P(Allocations, MemoryUseTellsAllThatAWorldHolds) {
  ASSERT_EQ(mallopt(M_MMAP_THRESHOLD, 32 << 20), 1);
  SceneDef scene = test::pile(12);
  scene.world.method = GetParam();
  const std::int64_t before = test::bytes_held();
  World world = test::made(scene);
  make_steps(world, 20, nullptr);
  const auto held = static_cast<double>(test::bytes_held() - before);
  double told = static_cast<double>(sizeof(Scratch));  // the vectors themselves; memory_use counts their contents
  for (const MemoryPart& part : memory_use(world)) told += static_cast<double>(part.bytes);
  EXPECT_LE(told, held);
  EXPECT_GT(told + 2000, held);
}

INSTANTIATE_TEST_SUITE_P(Both, Allocations, testing::Values(Method::kThesis, Method::kLayered),
                         [](const auto& method) { return method.param == Method::kThesis ? "Thesis" : "Layered"; });

TEST(CountingAllocations, SeesNewAndMalloc) {
  const std::uint64_t before = test::allocations();
  std::vector<double> some(10);
  EXPECT_EQ(test::allocations(), before + 1);
  struct alignas(128) Wide {
    double of[16];
  };
  std::vector<Wide> wide(3);
  EXPECT_EQ(test::allocations(), before + 2);
  void* volatile block = std::malloc(wide.size());
  EXPECT_EQ(test::allocations(), before + 3);
  std::free(block);
}

}  // namespace
}  // namespace tumble::sim
