#pragma once

// What the manifolds of a layer have given to each body, for any number of lanes. lane_vector.h says who may include
// this.

#include "src/kernels/contacts/contact_lanes.h"

namespace tumble::sim {
namespace {

// Whether this visit has solved the manifold whose outcome is row `row`.
inline bool solved_now(const ContactWork& work, std::uint32_t row) {
  return work.sides[row / (2 * kLanes)].visited[row / 2 % kLanes] == work.visit.now;
}

// The sum of the outcomes of a body from double `at` of the rows on, of any size: where their magnitudes leave the grid
// of motions, the largest chooses a wider one.
template <class V>
[[gnu::noinline, gnu::cold]] V add_up_outcomes(const ContactWork& work, const BodyOutcomes& of, std::size_t at,
                                               Due due) {
  const auto outcome = [&](std::uint32_t e) {
    if (due == Due::kSome && !solved_now(work, work.entries[e])) return V{};
    return load<V>(work.outcomes + work.entries[e] * kOutcomeDoubles + at);
  };
  const V usual = V{} + kMotionMagic;
  V largest = V{}, magnitudes = V{}, sum = V{};
  for (std::uint32_t e = of.begin; e < of.end; ++e) {
    largest = larger(absolute(outcome(e)), largest);
    magnitudes += absolute(to_grid(usual, outcome(e)));
  }
  const double terms = of.end - of.begin < 4 ? 4.0 : static_cast<double>(of.end - of.begin);
  const V wider = fitting_magic(usual, largest * terms), magic = magnitudes < kMotionSumMax ? usual : wider;
  for (std::uint32_t e = of.begin; e < of.end; ++e) sum += to_grid(magic, outcome(e));
  return sum;
}

// Adds to every body of a layer its outcomes, rounded to the grid of motions: sums on a grid are exact in any order,
// here as long as the magnitudes of the outcomes add up to less than kMotionSumMax.
template <class V, Due kDue>
bool apply_due_outcomes(const ContactWork& work, const BodyOutcomes* of, std::size_t count) {
  constexpr std::size_t kAtOnce = sizeof(V) / sizeof(double), kParts = kOutcomeDoubles / kAtOnce;
  const V magic = V{} + kMotionMagic, limit = V{} + kMotionSumMax, still = V{} + work.visit.still;
  bool any_moves = false;
  for (std::size_t k = 0; k < count; ++k) {
    double* const body = work.bodies + of[k].body * kSolverBodyDoubles;
    V sum[kParts] = {}, magnitudes = V{};  // the latter of all parts together, which is no less than that of any
    bool any = kDue == Due::kAll;
    for (std::uint32_t e = of[k].begin; e < of[k].end; ++e) {
      if (kDue == Due::kSome && !solved_now(work, work.entries[e])) continue;
      any = true;
      const double* const row = work.outcomes + work.entries[e] * kOutcomeDoubles;
      for (std::size_t part = 0; part < kParts; ++part) {
        const V outcome = to_grid(magic, load<V>(row + part * kAtOnce));
        sum[part] += outcome;
        magnitudes += absolute(outcome);
      }
    }
    if (!any) continue;
    if (!all_below(magnitudes, limit)) [[unlikely]] {
      for (std::size_t part = 0; part < kParts; ++part)
        sum[part] = add_up_outcomes<V>(work, of[k], part * kAtOnce, kDue);
    }
    bool moves = false;
    for (std::size_t part = 0; part < kParts; ++part) {
      double* const motion = body + part * kAtOnce;
      store(motion, load<V>(motion) + sum[part]);
      moves |= any_above(absolute(sum[part]), still);
    }
    if (moves) work.visit.moved[of[k].body] = work.visit.now;
    any_moves |= moves;
  }
  return any_moves;
}

template <class V>
bool apply_outcomes(const ContactWork& work, const BodyOutcomes* of, std::size_t count, Due due) {
  return due == Due::kSome ? apply_due_outcomes<V, Due::kSome>(work, of, count)
                           : apply_due_outcomes<V, Due::kAll>(work, of, count);
}

}  // namespace
}  // namespace tumble::sim
