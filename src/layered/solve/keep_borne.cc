#include "src/layered/solve/keep_borne.h"

#include <algorithm>

#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// An impulse that stopped a body in one step throws it in the next, through the friction and the turn that it causes
// before the sweeps take it back. A point that met was hit, so of its impulse only the load counts. A contact that
// passes a hit on has not met anything: there an impulse counts as borne up to twice what the step began with or what
// the contact bears, and a new contact may bear some weights of the lighter body.
// Of an impulse beyond that, so much stays: the braking of a heap or of a heavy body goes on for several steps, and
// bodies would sink into one another if each step began it anew. A bounce has ended it.
constexpr double kKept = 0.5;

// The sum of value(point), no value negative.
template <class Value>
double exact_sum(const ContactLane& contact, std::span<const ManifoldPoint> points, Value value) {
  const double usual = contact.batch.impulse_magic.of[contact.lane];
  double largest = 0, sum = 0;
  for (const ManifoldPoint& point : points) {
    largest = std::max(largest, value(point));
    sum += to_grid(usual, value(point));
  }
  const double terms = std::max(4.0, static_cast<double>(points.size()));  // as fitting_magic wants it
  const double magic = fitting_magic(usual, largest * terms);
  if (magic == usual) return sum;
  sum = 0;
  for (const ManifoldPoint& point : points) sum += to_grid(magic, value(point));
  return sum;
}

void scale(std::span<ManifoldPoint> points, double part) {
  for (ManifoldPoint& point : points) point.impulse *= part;
}

}  // namespace

double impulse_of(const ContactLane& contact, std::span<const ManifoldPoint> points) {
  return exact_sum(contact, points, [](const ManifoldPoint& point) { return point.impulse; });
}

bool grew(const ContactLane& contact, double before, std::span<const ManifoldPoint> points) {
  const PointBatch* solved = contact.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if ((solved++)->approach.of[contact.lane] < -kRestingSpeed) return true;
  }
  return !(impulse_of(contact, points) <= kBornePart * before);
}

void keep_borne(const ContactLane& contact, double before, double weight, Manifold& m,
                std::span<ManifoldPoint> points) {
  const double all = impulse_of(contact, points);
  if (all == 0) return;
  const PointBatch* solved = contact.points;
  for (ManifoldPoint& point : points) {
    const bool met = (solved++)->approach.of[contact.lane] < -kRestingSpeed;
    if (met) point.impulse = std::min(point.impulse, point.load);
  }
  double kept = impulse_of(contact, points);
  const double load = exact_sum(contact, points, [](const ManifoldPoint& point) { return point.load; });
  const double braking = contact.bounced ? 0 : kKept * kept;
  const double borne = std::max({kBornePart * before, kBornePart * load, kBorneWeights * weight, braking});
  if (kept > borne) {
    scale(points, borne / kept);
    kept = borne;
  }
  if (kept == all) return;
  const double part = kept / all;
  m.force1 *= part;
  m.force2 *= part;
  m.twist *= part;
}

}  // namespace tumble::sim
