// Contacts of fast pairs are merged into the remembered ones in place: all are there once, in order, each with its own.
#include "src/layered/find/contact_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "src/base/rng.h"

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
  merge_contacts(memory, added);
  EXPECT_EQ(memory, wanted) << "seed " << seed << ", share " << share;
}

TEST(ContactMemory, MergedHoldsTheContactsOfBothInOrder) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const std::uint64_t share : {0U, 1U, 4U, 7U, 8U}) expect_merged(seed, share);
  }
}

}  // namespace
}  // namespace tumble::sim
