#include "golden/hunt/judge/mechanics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "golden/hunt/judge/bounds.h"
#include "replay/measure/measure_overlap.h"

namespace tumble::hunt {

using sim::Bodies;
using sim::BodyId;
using sim::BodyIndex;
using sim::cross;
using sim::dot;
using sim::length;
using sim::Vec3;

sim::BoxFrame frame_of(const Bodies& bodies, BodyIndex i) {
  return {bodies.position[i], axes_of(bodies.orientation[i]), bodies.half_extent[i]};
}

Vec3 moments_of(const Bodies& bodies, BodyIndex i) {
  const Vec3 h = bodies.half_extent[i];
  const double x = h.x() * h.x(), y = h.y() * h.y(), z = h.z() * h.z(), third = bodies.mass[i] / 3;
  return {third * (y + z), third * (x + z), third * (x + y)};
}

Vec3 spin_momentum(const Bodies& bodies, BodyIndex i) {
  const sim::Axes axes = axes_of(bodies.orientation[i]);
  const Vec3 spin = to_body(axes, bodies.spin[i]), moments = moments_of(bodies, i);
  return to_world(axes, {spin.x() * moments.x(), spin.y() * moments.y(), spin.z() * moments.z()});
}

double spin_energy(const Bodies& bodies, BodyIndex i) { return 0.5 * dot(spin_momentum(bodies, i), bodies.spin[i]); }

double half_diagonal(const Bodies& bodies, BodyIndex i) { return length(bodies.half_extent[i]); }

Momentum momentum_of(const Bodies& bodies, const std::vector<BodyId>& ids) {
  Momentum sum;
  for (const BodyId id : ids) {
    const auto i = bodies.find(id);
    if (!i) continue;
    const Vec3 momentum = bodies.velocity[*i] * bodies.mass[*i];
    sum.linear += momentum;
    sum.angular += cross(bodies.position[*i], momentum) + spin_momentum(bodies, *i);
    sum.first += bodies.position[*i] * bodies.mass[*i];
    sum.mass += bodies.mass[*i];
  }
  return sum;
}

std::vector<TouchingGroup> groups_of(const Trace& trace, std::size_t step) {
  const Bodies &begun = trace.begun(step).bodies, &after = trace.after(step).bodies;
  std::vector<BodyIndex> of(begun.size());
  std::iota(of.begin(), of.end(), BodyIndex{0});
  const auto leader = [&](BodyIndex i) {
    while (of[i] != i) i = of[i];
    return i;
  };
  std::vector<std::uint8_t> fixed(begun.size(), 0);
  const auto moves = [&](BodyIndex i) {
    const auto j = after.find(begun.id[i]);
    return begun.moves(i) && j && after.moves(*j);
  };
  for (BodyIndex i = 0; i < begun.size(); ++i) fixed[i] = moves(i) ? 0 : 1;
  for (const Meeting& meeting : trace.steps[step].met) {
    const auto a = begun.find(meeting.first), b = begun.find(meeting.second);
    if (!b) continue;
    // A body on the ground passes on what it gets, so all that it touches is one group with it.
    if (!a || begun.is_static[*a] != 0) {
      fixed[leader(*b)] = 1;
    } else if (begun.is_static[*b] != 0) {
      fixed[leader(*a)] = 1;
    } else {
      const BodyIndex one = leader(*a), other = leader(*b);
      fixed[other] |= fixed[one];
      of[one] = other;
    }
  }
  std::map<BodyIndex, TouchingGroup> groups;
  for (BodyIndex i = 0; i < begun.size(); ++i) {
    if (begun.is_static[i] != 0) continue;
    TouchingGroup& group = groups[leader(i)];
    group.bodies.push_back(begun.id[i]);
    group.fixed = group.fixed || fixed[i] != 0 || fixed[leader(i)] != 0;
  }
  std::vector<TouchingGroup> out;
  out.reserve(groups.size());
  for (auto& [row, group] : groups) out.push_back(std::move(group));
  return out;
}

bool is_parted(const sim::WorldState& state, const std::vector<BodyId>& ids) {
  for (const BodyId id : ids) {
    const auto i = state.bodies.find(id);
    if (!i) continue;
    const sim::BoxFrame frame = frame_of(state.bodies, *i);
    const double thin = frame.half_extent.minCoeff();
    if (state.def.ground && replay::ground_penetration(frame) > std::min(kPartedDepth, kPartedPart * thin)) return true;
    for (BodyIndex j = 0; j < state.bodies.size(); ++j) {
      if (j == *i) continue;
      const double depth = std::min(kPartedDepth, kPartedPart * std::min(thin, state.bodies.half_extent[j].minCoeff()));
      if (replay::overlap_depth(frame, frame_of(state.bodies, j)) > depth) return true;
    }
  }
  return false;
}

std::vector<Overlap> overlaps_of(const sim::WorldState& state) {
  const Bodies& bodies = state.bodies;
  std::vector<Overlap> found;
  const auto add = [&found](double depth, BodyId a, BodyId b, double thinnest) {
    if (depth > 0) found.push_back({depth, a, b, thinnest});
  };
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    const double edge = 2 * bodies.half_extent[i].minCoeff();
    const sim::BoxFrame frame = frame_of(bodies, i);
    if (state.def.ground && bodies.is_static[i] == 0) {
      add(replay::ground_penetration(frame), kGroundId, bodies.id[i], edge);
    }
    for (BodyIndex j = i + 1; j < bodies.size(); ++j) {
      if (bodies.is_static[i] != 0 && bodies.is_static[j] != 0) continue;
      const double reach = half_diagonal(bodies, i) + half_diagonal(bodies, j);
      if (length(bodies.position[j] - bodies.position[i]) >= reach) continue;
      const double thinnest = std::min(edge, 2 * bodies.half_extent[j].minCoeff());
      add(replay::overlap_depth(frame, frame_of(bodies, j)), bodies.id[i], bodies.id[j], thinnest);
    }
  }
  return found;
}

Overlap worst_overlap(const sim::WorldState& state) {
  Overlap worst;
  for (const Overlap& one : overlaps_of(state)) {
    if (worst.thinnest == 0 || one.depth * worst.thinnest > worst.depth * one.thinnest) worst = one;
  }
  return worst;
}

bool begins_apart(const Trace& trace, double depth) {
  if (worst_overlap(trace.states[0]).depth > depth) return false;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    for (const sim::Command& input : trace.steps[k].inputs) {
      if (std::holds_alternative<sim::Throw>(input) && worst_overlap(trace.begun(k)).depth > depth) return false;
    }
  }
  return true;
}

}  // namespace tumble::hunt
