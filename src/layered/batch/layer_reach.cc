#include "src/layered/batch/layer_reach.h"

#include <algorithm>

#include "src/layered/order/contact_graph.h"
#include "src/world/for_bodies.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kLayersAPart = 64;
constexpr std::size_t kManyLayers = 64;  // to look at fewer takes no longer than to find out who shares bodies

using Reach = VisitScratch::Reach;

void extend(Reach& reach, const Reach& by) {
  if (reach.begin == reach.end) {
    reach = by;
    return;
  }
  reach = {std::min(reach.begin, by.begin), std::max(reach.end, by.end)};
}

void find_reach_of_bodies(Scratch& scratch) {
  std::vector<Reach>& reach_of_body = scratch.visits.reach_of_body;
  reach_of_body.resize(scratch.in_contact.size());
  for_bodies(scratch, reach_of_body.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      Reach& reach = reach_of_body[i] = {};
      for_ends(scratch.graph, i, [&](const ContactEnd& contact) {
        const std::uint32_t layer = scratch.graph.links[contact.manifold].layer;
        extend(reach, {layer, layer + 1});
      });
    }
  });
}

}  // namespace

void find_layer_reach(Scratch& scratch) {
  VisitScratch& visits = scratch.visits;
  const ContactBatches& all = scratch.contact_batches;
  const std::size_t layers = all.touched_start.size();
  if (layers < kManyLayers) {
    visits.reach.assign(layers, {0, static_cast<std::uint32_t>(layers)});
    return;
  }
  find_reach_of_bodies(scratch);
  visits.reach.resize(layers);
  for_ranges(scratch.workers, layers, kLayersAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t layer = begin; layer < end; ++layer) {
      Reach& reach = visits.reach[layer] = {};
      for (std::uint32_t k = all.touched_start[layer]; k < all.touched_end[layer]; ++k) {
        extend(reach, visits.reach_of_body[all.touched[k].body]);
      }
    }
  });
}

}  // namespace tumble::sim
