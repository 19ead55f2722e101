#include "src/layered/solve/contact_batches.h"

#include <algorithm>
#include <cstddef>

#include "src/layered/batch/share_sweeps.h"
#include "src/layered/solve/keep_borne.h"
#include "src/math/grid.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

static_assert(sizeof(SolverBody) == kSolverBodyDoubles * sizeof(double));
static_assert(offsetof(SolverBody, inverse_mass) == 6 * sizeof(double));
static_assert(offsetof(SolverBody, inverse_inertia) == 7 * sizeof(double));
static_assert(offsetof(SolverBody, lent) == 13 * sizeof(double));
static_assert(VelocityGrid::kLimit == kMotionSumMax);
static_assert(sizeof(Outcome) == kOutcomeDoubles * sizeof(double));

std::uint8_t with_lane(std::uint8_t lanes, unsigned lane) { return static_cast<std::uint8_t>(lanes | 1U << lane); }

bool met_fast(const ContactWork& work, const ContactBatch& batch, unsigned lane) {
  for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
    if (work.points[k].approach.of[lane] <= -bounce_min(batch)) return true;
  }
  return false;
}

void store_contact(const ContactBatches& all, std::uint32_t place, Manifold& m, std::span<ManifoldPoint> points) {
  const ContactBatch& batch = all.batches[place / kLanes];
  const unsigned lane = place % kLanes;
  m.force1 = batch.force1.of[lane];
  m.force2 = batch.force2.of[lane];
  m.twist = batch.twist.of[lane];
  std::size_t at = batch.first;
  for (ManifoldPoint& point : points) {
    point.impulse = all.points[at].impulse.of[lane];
    point.separation = all.points[at].separation.of[lane];
    ++at;
  }
}

// An impulse that stopped an impact carries nothing: the next substep must not start from it.
void forget_impact(const ContactBatches& all, std::uint32_t place, Manifold& m, std::span<ManifoldPoint> points) {
  const PointBatch* batch = all.points.data() + all.batches[place / kLanes].first;
  bool met = false;
  for (ManifoldPoint& point : points) {
    if (batch++->approach.of[place % kLanes] >= -kRestingSpeed) continue;
    point.impulse = 0;
    met = true;
  }
  if (met) m.force1 = m.force2 = m.twist = 0;
}

ContactLane contact_at(const Scratch& scratch, const ContactBatches& all, std::uint32_t place) {
  const ContactBatch& batch = all.batches[place / kLanes];
  const bool bounced = all.sides[place / kLanes].visited[place % kLanes] > scratch.visits.bounces;
  return {batch, all.points.data() + batch.first, place % kLanes, bounced};
}

// N·s, of the lighter body for a substep.
double weight_of(const Scratch& scratch, const Manifold& m, double fall) {
  const auto inverse_mass = [&](BodyIndex i) { return i == kGround ? 0.0 : scratch.solver_bodies[i].inverse_mass; };
  return fall / std::max(inverse_mass(m.a), inverse_mass(m.b));
}

ContactWork work_on(ContactBatches& all, Scratch& scratch, double substep_s) {
  return {all.batches.data(),
          all.sides.data(),
          all.batches.size(),
          all.points.data(),
          all.impacts.data(),
          reinterpret_cast<double*>(scratch.solver_bodies.data()),
          reinterpret_cast<double*>(scratch.outcomes.data()),
          all.entries.data(),
          substep_s,
          kPushPart,
          {},
          false,
          0};
}

void add_stored(const Manifold& m, std::span<const ManifoldPoint> points, GatheredNumbers& numbers) {
  double* const of_manifold = numbers.next(3);
  of_manifold[0] = m.force1, of_manifold[1] = m.force2, of_manifold[2] = m.twist;
  for (const ManifoldPoint& point : points) {
    double* const of_point = numbers.next(2);
    of_point[0] = point.impulse, of_point[1] = point.separation;
  }
}

}  // namespace

bool mark_bounces(const ContactWork& work) {
  bool any = false;
  for (ContactBatch& batch : std::span(work.batches, work.count)) {
    batch.met = batch.bounces = 0;
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      if (!met_fast(work, batch, lane)) continue;
      batch.met = with_lane(batch.met, lane);
      if (batch.restitution.of[lane] > 0) batch.bounces = with_lane(batch.bounces, lane);
    }
    any |= batch.met != 0;
  }
  return any;
}

void list_impacts(ContactBatches& all, bool any) {
  all.impacts.clear();
  if (!any) return;
  for (std::uint32_t k = 0; k < all.batches.size(); ++k) {
    if (all.batches[k].met == 0) continue;
    all.batches[k].impact = static_cast<std::uint32_t>(all.impacts.size());
    all.impacts.emplace_back().batch = k;
  }
}

void store_contacts(Scratch& scratch, Hasher* hasher, double fall) {
  const ContactBatches& all = scratch.contact_batches;
  const auto store_one = [&](std::uint32_t manifold, std::uint32_t place) {
    Manifold& m = scratch.manifolds[manifold];
    const ContactLane contact = contact_at(scratch, all, place);
    const std::span<ManifoldPoint> points = points_of(scratch, m);
    const double before = impulse_of(contact, points);
    store_contact(all, place, m, points);
    if (grew(contact, before, points)) keep_borne(contact, before, weight_of(scratch, m, fall), m, points);
  };
  if (hasher == nullptr) {
    return for_shared_batches(scratch, [&](std::size_t begin, std::size_t end) {
      for (auto k = static_cast<std::uint32_t>(begin); k < end; ++k) {
        const ContactBatch& batch = all.batches[k];
        for (unsigned lane = 0; lane < batch.used; ++lane) {
          store_one(all.order[batch.members + lane], k * kLanes + lane);
        }
      }
    });
  }
  const auto store = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) store_one(scratch.layered[k], all.place[scratch.layered[k]]);
  };
  GatheredNumbers numbers(hasher);
  for_hashed_ranges(hasher, nullptr, scratch.layered.size(), kManifoldsAPart, kManifoldsABlock, store,
                    [&](std::size_t begin, std::size_t end) { add_stored_contacts(scratch, begin, end, numbers); });
}

void add_stored_contacts(const Scratch& scratch, std::size_t begin, std::size_t end, GatheredNumbers& numbers) {
  for (std::size_t k = begin; k < end; ++k) {
    const Manifold& m = scratch.manifolds[scratch.layered[k]];
    add_stored(m, points_of(scratch, m), numbers);
  }
}

void add_stored_fast_contacts(const FastContacts& fast, GatheredNumbers& numbers) {
  if (fast.none()) return;
  for (const Manifold& m : fast.found.manifolds) add_stored(m, points_of(fast.found, m), numbers);
}

void store_fast_contacts(Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  for_ranges(scratch.workers, fast.found.manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Manifold& m = fast.found.manifolds[k];
      const std::uint32_t place = fast.batches.place[k];
      store_contact(fast.batches, place, m, points_of(fast.found, m));
      forget_impact(fast.batches, place, m, points_of(fast.found, m));
    }
  });
}

bool keep_borne_of_fast(Scratch& scratch, double fall) {
  FastContacts& fast = scratch.fast;
  std::uint8_t any = 0;
  for_ranges(scratch.workers, fast.found.manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Manifold& m = fast.found.manifolds[k];
      const ContactLane contact = contact_at(scratch, fast.batches, fast.batches.place[k]);
      const std::span<ManifoldPoint> points = points_of(fast.found, m);
      // What brakes goes on as it is: with half, towers that fall as one throw their top back.
      if (!contact.bounced) continue;
      keep_borne(contact, 0, weight_of(scratch, m, fall), m, points);
      mark(any);
    }
  });
  return any != 0;
}

ContactWork all_contacts(Scratch& scratch, double substep_s) {
  return work_on(scratch.contact_batches, scratch, substep_s);
}
ContactWork fast_contacts(Scratch& scratch, double substep_s) {
  return work_on(scratch.fast.batches, scratch, substep_s);
}

ContactWork part_of(const ContactWork& work, std::size_t begin, std::size_t end) {
  ContactWork part = work;
  part.batches += begin;
  part.sides += begin;
  part.count = end - begin;
  part.outcomes += begin * kLanes * 2 * kOutcomeDoubles;
  return part;
}

ContactWork contacts_of_layer(const Scratch& scratch, const ContactWork& all, std::size_t layer) {
  ContactWork work = all;
  const std::uint32_t begin = scratch.contact_batches.layer_start[layer];
  work.batches += begin;
  work.sides += begin;
  work.count = scratch.contact_batches.layer_start[layer + 1] - begin;
  return work;
}

}  // namespace tumble::sim
