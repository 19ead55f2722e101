#include "src/thesis/split_mass.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// Rounds in which the parts follow the gains. Each lowers the impulses of raised bodies, which may then cancel less of
// their neighbours' gains.
constexpr int kRounds = 4;
// Less than this above 1 is rounding.
constexpr double kMore = 1 + 0x1p-20;

// Calls visit(body, energy) for each side of each collision with an impulse.
template <class Visit>
void for_each_gain(const Contacts& contacts, const SplitScratch& split, Visit visit) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (split.energy[2 * k] > 0) visit(contacts.a[k], split.energy[2 * k]);
    if (split.energy[2 * k + 1] > 0) visit(contacts.b[k], split.energy[2 * k + 1]);
  }
}

// Sums the energies of the gains one by one, for bodies with several.
void sum_energies(const Contacts& contacts, std::size_t bodies, SplitScratch& split) {
  split.count.assign(bodies, 0);
  split.largest.assign(bodies, 0);
  split.sum.assign(bodies, 0);
  for_each_gain(contacts, split, [&](BodyIndex i, double energy) {
    ++split.count[i];
    split.largest[i] = std::max(split.largest[i], energy);
  });
  for_each_gain(contacts, split, [&](BodyIndex i, double energy) {
    const double magic =
        power_of_two(split.largest[i]) * 0x1.8p22;  // 2²⁰ terms are exact on a grid of 2⁻³⁰ of the largest
    split.sum[i] += (energy + magic) - magic;
  });
}

}  // namespace

double gain_energy(const Bodies& bodies, const BoxFrame& frame, BodyIndex i, const Vec3& velocity, const Vec3& spin) {
  const Vec3 turn = to_body(frame.axes, spin);
  const Vec3& inverse = bodies.inverse_inertia[i];
  const double mass = bodies.inverse_mass[i];
  return dot(velocity, velocity) +
         ((turn.x() * turn.x() * (mass / inverse.x()) + turn.y() * turn.y() * (mass / inverse.y())) +
          turn.z() * turn.z() * (mass / inverse.z()));
}

void reset_parts(const Contacts& contacts, std::size_t bodies, SplitScratch& split) {
  split.parts.assign(bodies, 1);
  split.raised.assign(bodies, 0);
  split.contacts.assign(bodies, 0);
  std::uint32_t most = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    most = std::max(most, ++split.contacts[contacts.a[k]]);
    if (contacts.b[k] != kGround) most = std::max(most, ++split.contacts[contacts.b[k]]);
  }
  split.several = most > 1;
}

bool raise_parts(const WorldState& state, Scratch& scratch, int round) {
  SplitScratch& split = scratch.split;
  if (!split.several) return false;
  const std::size_t n = state.bodies.size();
  sum_energies(scratch.contacts, n, split);
  bool any = false;
  for (BodyIndex i = 0; i < n; ++i) {
    split.raised[i] = 0;
    if (split.parts[i] >= split.count[i]) continue;  // one collision, or all that there can be
    const double together =
        gain_energy(state.bodies, scratch.frames[i], i, scratch.velocity_gain[i], scratch.spin_gain[i]);
    const double needed = together / split.sum[i];
    if (!(needed > split.parts[i] * kMore)) continue;
    split.parts[i] = round < kRounds ? needed : split.count[i];
    split.raised[i] = 1;
    any = true;
  }
  return any;
}

}  // namespace tumble::sim
