#include "src/layered/order/find_hits.h"

#include <cmath>

#include "src/layered/order/contact_graph.h"
#include "src/layered/order/contact_motion.h"
#include "src/world/for_bodies.h"

namespace tumble::sim {
namespace {

constexpr double kAlongOneNormal = 0.99;  // contacts of two bodies along one normal need no more than one sweep

using Link = ContactGraph::Link;

// Bodies of which both are slower do not close at kBounceMin anywhere.
void mark_fast(const Bodies& bodies, Scratch& scratch, double dt_s) {
  std::vector<std::uint8_t>& fast = scratch.islands.fast;
  fast.resize(bodies.size());
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      const Vec3 v = bodies.velocity[i];
      const double turning = scratch.turning[i] / dt_s;
      fast[i] = bodies.moves(i) && 2 * (dot(v, v) + turning * turning) > 0.25 * kBounceMin * kBounceMin ? 1 : 0;
    }
  });
}

// Whether another contact of the layer shares the mass of body i, and is not of the same two bodies along one normal.
bool is_shared(const Scratch& scratch, std::size_t k, BodyIndex i) {
  const ContactGraph& graph = scratch.graph;
  const Link& link = graph.links[k];
  const BodyIndex other = i == link.a ? link.b : link.a;
  return any_end(graph, i, [&](const ContactEnd& end) {
    if (end.manifold == k || graph.links[end.manifold].layer != link.layer) return false;
    const double along = dot(scratch.manifolds[k].n, scratch.manifolds[end.manifold].n);
    return end.other != other || std::fabs(along) < kAlongOneNormal;
  });
}

}  // namespace

void find_hits(const WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
  IslandScratch& own = scratch.islands;
  mark_fast(bodies, scratch, state.def.dt);
  fill_bodies(scratch, bodies.size(), own.hits, kNotHit);
  const auto fast = [&](BodyIndex i) { return i != kGround && own.fast[i] != 0; };
  const auto in_part = [&](std::size_t k, BodyIndex i) { return moves(bodies, i) && is_shared(scratch, k, i); };
  for_manifolds(scratch, scratch.graph.links.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Link& link = scratch.graph.links[k];
      if (!link.awake || !(fast(link.a) || fast(link.b))) continue;
      if (!closes_by(bodies, scratch, scratch.manifolds[k], kBounceMin)) continue;
      const std::uint8_t hit = in_part(k, link.a) || in_part(k, link.b) ? kSharedHit : kHitAlone;
      shared::raise(own.hits[own.hit[mover_of(bodies, link)]], hit);
    }
  });
}

}  // namespace tumble::sim
