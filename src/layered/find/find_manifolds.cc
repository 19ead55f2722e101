#include "src/layered/find/find_manifolds.h"

#include <algorithm>
#include <span>
#include <string>

#include "src/layered/find/build_manifolds.h"
#include "src/layered/find/contact_memory.h"
#include "src/layered/find/join_lists.h"
#include "src/world/hash_on_the_way.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kWorthPairs = 1024;  // and bodies, that pay for one more worker

// The first body of a part; all parts get about one number of pairs and bodies.
BodyIndex first_body(const WorldState& state, unsigned part, unsigned parts) {
  const PairTable& pairs = state.pairs;
  const std::size_t n = state.bodies.size(), wanted = (pairs.size() + n) * part / parts;
  BodyIndex low = 0, high = static_cast<BodyIndex>(n);
  while (low < high) {
    const BodyIndex middle = low + (high - low) / 2;
    if (pairs_before(pairs, middle) + middle < wanted) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// Exchanges the lists of the scratch with those of the first worker, who then finds into the former without a copy.
void swap_first(Scratch& scratch) {
  std::swap(scratch.manifolds, scratch.manifolds_by[0].manifolds);
  std::swap(scratch.manifold_points, scratch.manifolds_by[0].points);
  std::swap(scratch.fast.pairs, scratch.manifolds_by[0].fast_pairs);
}

// Marks the bodies that a contact pressed at the end of the last step.
void mark_held(const ContactMemory& memory, Workers* workers, std::vector<std::uint8_t>& held) {
  for_ranges(workers, memory.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    std::size_t point = points_before(memory, begin);
    for (std::size_t k = begin; k < end; ++k) {
      bool pressed = false;
      for (const std::size_t past = point + memory.count[k]; point < past; ++point)
        pressed |= memory.impulse[point] > 0;
      if (!pressed) continue;
      if (memory.a[k] != kGround) mark(held[memory.a[k]]);
      mark(held[memory.b[k]]);
    }
  });
}

// Joins the lists of all workers in order of bodies; copies those of all but the first.
void join(Scratch& scratch, unsigned parts) {
  swap_first(scratch);
  for (unsigned part = 1; part < parts; ++part) {
    const std::vector<ContactPair>& found = scratch.manifolds_by[part].fast_pairs;
    scratch.fast.pairs.insert(scratch.fast.pairs.end(), found.begin(), found.end());
  }
  join_lists(std::span(scratch.manifolds_by).subspan(1, parts - 1), scratch.workers, scratch.manifolds,
             scratch.manifold_points);
}

void add_fast_pairs(const Scratch& scratch, Hasher& hasher) {
  for (const auto& [a, b] : scratch.fast.pairs) hasher.add(std::uint64_t{a} << 32U | b);
}

}  // namespace

Status find_manifolds(WorldState& state, Scratch& scratch, double dt_s) {
  Hasher* const hasher = take_hasher(scratch);
  const std::size_t work = state.pairs.size() + state.bodies.size();
  const unsigned parts = part_count(scratch.workers, work, kWorthPairs);
  if (scratch.manifolds_by.size() < parts) scratch.manifolds_by.resize(parts);
  swap_first(scratch);
  // What sleeps, or wakes in this step, rests on something. Where it began the session asleep, no impulse tells so.
  scratch.held = state.bodies.frozen;
  for (const BodyIndex i : scratch.waking.woken) scratch.held[i] = 1;
  mark_held(state.contact_memory, scratch.workers, scratch.held);
  for_parts(scratch.workers, parts, [&](unsigned part) {
    build_manifolds(state, scratch, dt_s, first_body(state, part, parts), first_body(state, part + 1, parts),
                    scratch.manifolds_by[part], hasher);
  });
  std::size_t found = 0;
  for (unsigned part = 0; part < parts; ++part) found += scratch.manifolds_by[part].manifolds.size();
  const std::size_t n = state.bodies.size(), most = manifolds_max(n);
  if (found > most) {
    return cannot_finish("found more than " + std::to_string(most) + " contacts of " + std::to_string(n) +
                         " bodies; so many stand inside one another: set them farther apart");
  }
  join(scratch, parts);
  if (hasher != nullptr) add_fast_pairs(scratch, *hasher);
  return {};
}

void hash_find_manifolds(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_manifolds(scratch, hasher);
  add_fast_pairs(scratch, hasher);
}

}  // namespace tumble::sim
