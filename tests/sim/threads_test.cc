#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::sim {
namespace {

constexpr std::array<unsigned, 6> kCounts = {1, 2, 3, 4, 7, 16};

TEST(WorkerThreads, CallEveryPartOnceEveryRound) {
  for (const unsigned count : kCounts) {
    WorkerThreads workers(count);
    ASSERT_EQ(workers.count(), count);
    for (unsigned round = 0; round < 300; ++round) {
      std::array<std::atomic<unsigned>, 16> calls{};
      const unsigned parts = 1 + round % count;
      for_parts(&workers, parts, [&](unsigned part) { calls[part].fetch_add(1); });
      for (unsigned part = 0; part < calls.size(); ++part) ASSERT_EQ(calls[part].load(), part < parts ? 1U : 0U);
    }
  }
}

TEST(WorkerThreads, RangesCoverEverythingOnce) {
  WorkerThreads workers(7, Split::kEverything);
  for (std::size_t n = 0; n < 40; ++n) {
    std::vector<std::atomic<int>> seen(n);
    for_ranges(&workers, n, 1000, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) seen[k].fetch_add(1);
    });
    for (const std::atomic<int>& times : seen) ASSERT_EQ(times.load(), 1);
  }
}

// Each worker sees what the others wrote before they met, and hears what any of them said.
TEST(WorkerThreads, MeetAsOftenAsTheyLike) {
  for (const unsigned count : kCounts) {
    WorkerThreads workers(count);
    for (unsigned parts = 1; parts <= count; ++parts) {
      std::array<unsigned, 16> written{};
      std::atomic<unsigned> wrong = 0;
      work_together(&workers, parts, [&](const Worker& worker) {
        for (unsigned k = 1; k <= 100; ++k) {
          written[worker.part] = k;
          const bool says = k % 3 == 0 && k % worker.parts == worker.part;
          if (worker.meet(says) != (k % 3 == 0)) wrong.fetch_add(1);
          for (unsigned part = 0; part < worker.parts; ++part) wrong.fetch_add(written[part] == k ? 0 : 1);
          worker.meet();
        }
      });
      EXPECT_EQ(wrong.load(), 0U) << parts << " of " << count;
    }
  }
}

// A worker that waits for a post sees what the other wrote before it.
TEST(WorkerThreads, SeeWhatWasWrittenBeforeAPost) {
  for (const unsigned count : {2U, 3U, 7U}) {
    WorkerThreads workers(count);
    for (int round = 0; round < 3; ++round) {  // numbers begin anew in every round
      std::array<std::uint32_t, 16> written{};
      std::atomic<unsigned> wrong = 0;
      work_together(&workers, count, [&](const Worker& worker) {
        for (std::uint32_t k = 1; k <= 200; ++k) {
          const unsigned before = (worker.part + count - 1) % count;
          shared::write(written[worker.part], k);
          worker.post(k);
          if (worker.await(before, k) < k || shared::read(written[before]) < k) wrong.fetch_add(1);
        }
      });
      EXPECT_EQ(wrong.load(), 0U) << count;
    }
  }
}

TEST(WorkerThreads, SharesCoverEverythingOnce) {
  for (std::size_t n = 0; n < 40; ++n) {
    for (unsigned parts = 1; parts <= 7; ++parts) {
      for (unsigned of = 1; of <= parts; ++of) {
        std::size_t next = 0;
        for (unsigned part = 0; part < parts; ++part) {
          const Worker::Share share = Worker{nullptr, part, parts}.share(n, of);
          if (share.begin == share.end) continue;
          EXPECT_EQ(share.begin, next);
          next = share.end;
        }
        EXPECT_EQ(next, n);
      }
    }
  }
}

// Groups of any sizes, empty ones among them: each group is one worker's, and no worker has more than its part of the
// items but for one group.
TEST(WorkerThreads, SharesOfGroupsCoverThemOnce) {
  const std::vector<std::vector<std::uint32_t>> starts = {
      {0}, {0, 0}, {0, 5}, {0, 0, 1, 1, 3, 3}, {0, 10, 11, 12, 13}, {0, 1, 2, 3, 13}, {0, 3, 6, 9, 12, 15, 18, 21}};
  for (const std::vector<std::uint32_t>& start : starts) {
    for (unsigned parts = 1; parts <= 9; ++parts) {
      std::size_t next = 0;
      for (unsigned part = 0; part < parts; ++part) {
        const Worker::Share share = Worker{nullptr, part, parts}.share_groups(start);
        ASSERT_EQ(share.begin, next);
        ASSERT_LE(share.begin, share.end);
        next = share.end;
        std::uint32_t largest = 0;
        for (std::size_t k = share.begin; k < share.end; ++k) largest = std::max(largest, start[k + 1] - start[k]);
        EXPECT_LE(start[share.end] - start[share.begin], start.back() / parts + 1 + largest);
      }
      EXPECT_EQ(next, start.size() - 1);
    }
  }
}

TEST(WorkerThreads, SmallWorkIsNotSplit) {
  WorkerThreads workers(4);
  EXPECT_EQ(part_count(&workers, 99, 100), 1U);
  EXPECT_EQ(part_count(&workers, 250, 100), 2U);
  EXPECT_EQ(part_count(&workers, 100000, 100), 4U);
  EXPECT_EQ(part_count(nullptr, 100000, 100), 1U);
}

std::vector<std::uint64_t> hashes_of(const SceneDef& scene, Workers* workers, int steps) {
  Result<World> world = create_world(scene);
  EXPECT_TRUE(world.ok());
  world->use(workers);
  std::vector<std::uint64_t> all = test::phase_words_of(*world, steps);
  const Hash128 end = continuation_hash(world->state());
  all.insert(all.end(), {end.high, end.low});
  return all;
}

TEST(Threads, SessionsOfAnyNumberHaveTheSamePhaseHashes) {
  SceneDef heap = test::pile(3);
  test::jitter(heap, 0.01, 7);
  for (SceneDef scene : {heap, test::tumble_of_boxes(3, 3), test::wall(3, 4)}) {
    scene.world.method = Method::kLayered;
    scene.world.substeps = 1;
    const std::vector<std::uint64_t> one = hashes_of(scene, nullptr, 24);
    for (const unsigned count : {2U, 3U}) {
      WorkerThreads workers(count, Split::kEverything);
      EXPECT_EQ(one, hashes_of(scene, &workers, 24)) << count << " threads";
    }
  }
  heap.world.method = Method::kLayered;
  heap.world.substeps = 2;
  const std::vector<std::uint64_t> one = hashes_of(heap, nullptr, 6);
  for (const unsigned count : kCounts) {  // more than there are processors: each meeting takes long
    WorkerThreads workers(count, Split::kEverything);
    EXPECT_EQ(one, hashes_of(heap, &workers, 6)) << count << " threads";
  }
}

// Bars make islands hard, which then have layers of their own; a heap at rest falls asleep and is hit.
TEST(Threads, HardIslandsAndSleepersAreTheSameToo) {
  SceneDef bars = test::plates_and_bars(12, 5);
  SceneDef sleepers = test::pyramid(4);
  sleepers.world.freeze_time = 0.1;
  SceneDef slope = test::ramp(6, 3);
  for (SceneDef* scene : {&bars, &sleepers, &slope}) {
    scene->world.method = Method::kLayered;
    scene->world.substeps = 2;
    const std::vector<std::uint64_t> one = hashes_of(*scene, nullptr, 24);
    WorkerThreads workers(3, Split::kEverything);
    EXPECT_EQ(one, hashes_of(*scene, &workers, 24));
  }
}

// Columns that land bounce with what lies on them, and so does what falls on a stack.
TEST(Threads, WhatBouncesWithOthersIsTheSameToo) {
  SceneDef scene = test::on_ground();
  scene.world.method = Method::kLayered;
  scene.world.ground_material.restitution = 0.7;
  for (std::uint32_t k = 0; k < 27; ++k) {
    const std::uint32_t column = k % 9, level = k / 9;
    const bool falls = column < 5 || level == 2;
    const double above = falls ? 0.8 : 0.0;
    BoxDef box = test::cube(k + 1, {1.5 * column, 0.01 * k, 0.5 + level + above});
    if (falls) box.velocity = Vec3(0, 0, -5);
    box.material = scene.world.ground_material;
    scene.boxes.push_back(box);
  }
  for (const std::uint32_t substeps : {1U, 4U}) {
    scene.world.substeps = substeps;
    const std::vector<std::uint64_t> one = hashes_of(scene, nullptr, 40);
    for (const unsigned count : {2U, 3U, 7U}) {
      WorkerThreads workers(count, Split::kEverything);
      EXPECT_EQ(one, hashes_of(scene, &workers, 40)) << count << " threads";
    }
  }
}

TEST(Threads, MethodThesisIsTheSameToo) {
  SceneDef heap = test::pile(3);
  heap.world.method = Method::kThesis;
  WorkerThreads workers(3, Split::kEverything);
  EXPECT_EQ(hashes_of(heap, nullptr, 40), hashes_of(heap, &workers, 40));
}

}  // namespace
}  // namespace tumble::sim
