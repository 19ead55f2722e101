#include "src/layered/find/find_manifolds.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "src/layered/find/build_manifolds.h"
#include "src/layered/find/contact_memory.h"
#include "src/layered/find/join_lists.h"
#include "src/world/hash_on_the_way.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kWorthPairs = 1024;  // and bodies, that pay for one more worker

constexpr std::size_t kBlocksAPart = 32;    // of bodies: parts consist of whole blocks
constexpr std::uint64_t kContactWork = 12;  // of a contact that is built or followed; of a body or a pair 1

// The range of bodies of a block.
Worker::Share block(std::size_t bodies, std::size_t k, std::size_t blocks) {
  return {bodies * k / blocks, bodies * (k + 1) / blocks};
}

// About what it takes to build the manifolds of some bodies: they mostly have as many contacts as in the last step.
// Contacts may lie side by side, beside bodies that sleep or fall, so to count bodies and pairs does not do.
std::uint64_t work_of(const WorldState& state, std::span<const ContactPair> fast, const Worker::Share& of) {
  const Bodies& bodies = state.bodies;
  const ContactMemory& memory = state.contact_memory;
  const auto first = static_cast<BodyIndex>(of.begin), end = static_cast<BodyIndex>(of.end);
  std::uint64_t contacts = 0;
  const std::size_t past = contacts_before(memory, {end, 0});
  for (std::size_t k = contacts_before(memory, {first, 0}); k < past; ++k) {
    const bool moves = (memory.a[k] != kGround && bodies.moves(memory.a[k])) || bodies.moves(memory.b[k]);
    contacts += moves ? 1U : 0U;
  }
  const auto fast_before = [&](BodyIndex i) { return std::ranges::lower_bound(fast, ContactPair(i, 0)); };
  contacts += static_cast<std::uint64_t>(fast_before(end) - fast_before(first));
  return (of.end - of.begin) + (pairs_before(state.pairs, end) - pairs_before(state.pairs, first)) +
         kContactWork * contacts;
}

// The first body of a part, so that all parts have about as much work. work: by block.
BodyIndex first_body(std::span<const std::uint64_t> work, std::size_t bodies, unsigned part, unsigned parts) {
  const std::uint64_t wanted = std::accumulate(work.begin(), work.end(), std::uint64_t{0}) * part / parts;
  std::size_t k = 0;
  for (std::uint64_t before = 0; k < work.size() && before < wanted; ++k) before += work[k];
  return static_cast<BodyIndex>(block(bodies, k, work.size()).begin);
}

// Calls visit(part, first, end) for the bodies [first, end) of each part, by several workers at a time.
template <class Visit>
void for_bodies(const WorldState& state, Scratch& scratch, unsigned parts, Visit visit) {
  const std::size_t n = state.bodies.size();
  if (parts == 1) return visit(0U, BodyIndex{0}, static_cast<BodyIndex>(n));
  std::vector<std::uint64_t>& work = scratch.work;
  work.resize(kBlocksAPart * parts);
  const std::vector<ContactPair>& fast = scratch.manifolds_by[0].fast_pairs;  // of the last step, until it is built
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share own = worker.share(work.size());
    for (std::size_t k = own.begin; k < own.end; ++k) work[k] = work_of(state, fast, block(n, k, work.size()));
    worker.meet();
    visit(worker.part, first_body(work, n, worker.part, parts), first_body(work, n, worker.part + 1, parts));
  });
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
  for_bodies(state, scratch, parts, [&](unsigned part, BodyIndex first, BodyIndex end) {
    build_manifolds(state, scratch, dt_s, first, end, scratch.manifolds_by[part], hasher);
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
