#include "src/layered/islands/find_islands.h"

#include <algorithm>

#include "src/layered/islands/awake_links.h"
#include "src/world/for_bodies.h"
#include "src/world/islands.h"

namespace tumble::sim {
namespace {

void note(const Scratch& scratch, std::size_t bodies, Islands& islands, std::vector<BodyIndex>& of) {
  of.resize(bodies);
  for_bodies(scratch, bodies, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) of[i] = islands.of(i);
  });
}

}  // namespace

void find_islands(const WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
  Islands islands(scratch.island_links, bodies.size(), scratch.workers);
  const auto join = [&](BodyIndex a, BodyIndex b) {
    if (!at_rest(bodies, a) && !at_rest(bodies, b)) islands.join(a, b);
  };
  for_awake(scratch, [&](const ContactGraph::Link& link) { join(link.a, link.b); });
  note(scratch, bodies.size(), islands, scratch.islands.of);
  if (scratch.fast.none()) {
    scratch.islands.hit.resize(bodies.size());
    for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
      std::copy(scratch.islands.of.data() + begin, scratch.islands.of.data() + end, scratch.islands.hit.data() + begin);
    });
    return;
  }
  for (const auto& [a, b] : scratch.fast.pairs) join(a, b);
  note(scratch, bodies.size(), islands, scratch.islands.hit);
}

}  // namespace tumble::sim
