#include "src/thesis/split_mass.h"

#include <algorithm>
#include <bit>
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

// The energies of what bodies that changed gain together.
void find_energies_together(const WorldState& state, Scratch& scratch) {
  SplitScratch& split = scratch.split;
  for (const BodyIndex i : split.several) {
    if (split.changed[i] == 0) continue;
    split.count[i] = 0;
    split.sum[i] = 0;
    split.together[i] =
        gain_energy(state.bodies, scratch.frames[i], i, scratch.gains[i].velocity, scratch.gains[i].spin);
    // As many terms as contacts, each below twice the power of two, are exact on this grid.
    split.magic[i] = power_of_two(split.together[i]) * (3.0 * static_cast<double>(std::bit_ceil(split.contacts[i])));
  }
}

// Adds the energy of one gain of a body. Energies above `together` count as that much: then no body needs more parts.
void add_energy(SplitScratch& split, BodyIndex i, double energy) {
  if (split.changed[i] == 0 || energy <= 0) return;
  ++split.count[i];
  split.sum[i] += to_grid(split.magic[i], std::min(energy, split.together[i]));
}

// Sums the energies of the gains one by one, for bodies that changed.
void sum_energies(const Contacts& contacts, SplitScratch& split) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    add_energy(split, contacts.a[k], split.energy[2 * k]);
    if (contacts.b[k] != kGround) add_energy(split, contacts.b[k], split.energy[2 * k + 1]);
  }
}

void list_raised(const Contacts& contacts, SplitScratch& split) {
  split.again.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex b = contacts.b[k];
    const bool raised = split.raised[contacts.a[k]] != 0 || (b != kGround && split.raised[b] != 0);
    if (raised) split.again.push_back(static_cast<std::uint32_t>(k));
  }
}

}  // namespace

double gain_energy(const Bodies& bodies, const BoxFrame& frame, BodyIndex i, const Vec3& velocity, const Vec3& spin) {
  const Vec3 turn = to_body(frame.axes, spin);
  return bodies.mass[i] * dot(velocity, velocity) + dot(turn, turn.cwiseProduct(bodies.inertia[i]));
}

void reset_parts(const Contacts& contacts, std::size_t bodies, SplitScratch& split) {
  split.parts.assign(bodies, 1);
  split.raised.assign(bodies, 0);
  split.changed.assign(bodies, 0);
  split.contacts.assign(bodies, 0);
  split.count.assign(bodies, 0);
  split.together.resize(bodies);
  split.sum.resize(bodies);
  split.magic.resize(bodies);
  split.again.resize(contacts.size());
  split.several.clear();
  const auto count = [&](BodyIndex i) {
    if (++split.contacts[i] == 2) split.several.push_back(i);
  };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    split.again[k] = static_cast<std::uint32_t>(k);
    count(contacts.a[k]);
    if (contacts.b[k] != kGround) count(contacts.b[k]);
  }
}

bool raise_parts(const WorldState& state, Scratch& scratch, int round) {
  SplitScratch& split = scratch.split;
  if (split.several.empty()) return false;
  find_energies_together(state, scratch);
  sum_energies(scratch.contacts, split);
  bool any = false;
  for (const BodyIndex i : split.several) {
    split.raised[i] = 0;
    if (split.changed[i] == 0) continue;
    split.changed[i] = 0;
    if (split.parts[i] >= split.count[i]) continue;  // one collision, or all that there can be
    if (split.together[i] <= split.parts[i] * kMore * split.sum[i]) continue;
    split.parts[i] =
        round < kRounds ? std::min<double>(split.together[i] / split.sum[i], split.count[i]) : split.count[i];
    split.raised[i] = 1;
    any = true;
  }
  if (any) list_raised(scratch.contacts, split);
  return any;
}

}  // namespace tumble::sim
