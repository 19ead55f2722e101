// Contacts of fast pairs are written between the others: all are there once, in order, each with its own.
#include "src/layered/find/contact_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "src/base/rng.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::sim {
namespace {

constexpr BodyIndex kBodies = 12;

// A contact of the pair, with numbers that no other contact has.
void append(ContactMemory& memory, const ContactPair& pair, std::uint32_t points) {
  const double own = 1000.0 * pair.first + (pair.second == kGround ? 0 : pair.second);
  const bool ground = pair.second == kGround;
  memory.a.push_back(ground ? kGround : pair.first);
  memory.b.push_back(ground ? pair.first : pair.second);
  memory.count.push_back(points);
  memory.friction.push_back(Vec3(own, own + 0.25, own + 0.5));
  memory.twist.push_back(-own);
  for (std::uint32_t k = 0; k < points; ++k) {
    memory.feature.push_back(k);
    memory.impulse.push_back(own + 0.01 * k);
  }
}

// Manifolds of which so much is remembered.
struct Found {
  std::vector<Manifold> manifolds;
  std::vector<ManifoldPoint> points;
};
Found found_as(const ContactMemory& memory) {
  Found found;
  for (std::size_t k = 0; k < memory.size(); ++k) {
    Manifold& m = found.manifolds.emplace_back();
    m.a = memory.a[k];
    m.b = memory.b[k];
    m.first = static_cast<std::uint32_t>(found.points.size());
    m.count = memory.count[k];
    m.asleep = true;  // then d is what friction is remembered
    m.d = memory.friction[k];
    m.twist = memory.twist[k];
    for (std::uint32_t at = 0; at < m.count; ++at) {
      ManifoldPoint& point = found.points.emplace_back();
      point.feature = memory.feature[m.first + at];
      point.impulse = memory.impulse[m.first + at];
    }
  }
  return found;
}

// Of each pair of bodies some are remembered, some added and some not there. share: of 8, that are added.
void expect_merged(std::uint64_t seed, std::uint64_t share) {
  ContactMemory memory, added, wanted;
  for (BodyIndex lower = 0; lower < kBodies; ++lower) {
    for (BodyIndex upper = lower + 1; upper <= kBodies; ++upper) {
      const ContactPair pair(lower, upper == kBodies ? kGround : upper);
      const std::uint64_t drawn = random_bits(seed, lower, upper);
      if (drawn % 16 >= 12) continue;
      const auto points = static_cast<std::uint32_t>(1 + drawn / 16 % 4);
      append(drawn / 64 % 8 < share ? added : memory, pair, points);
      append(wanted, pair, points);
    }
  }
  Found found = found_as(memory);
  for (const unsigned workers : {1U, 3U}) {
    WorkerThreads threads(workers, Split::kEverything);
    ContactMemory written;
    remember_contacts(found.manifolds, found.points, &added, {}, &threads, written);
    EXPECT_EQ(written, wanted) << "seed " << seed << ", share " << share << ", written by " << workers;
  }
}

TEST(ContactMemory, MergedHoldsTheContactsOfBothInOrder) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const std::uint64_t share : {0U, 1U, 4U, 7U, 8U}) expect_merged(seed, share);
  }
}

}  // namespace
}  // namespace tumble::sim
