// Compiled once for each lane width: TUMBLE_LANES is the width, and the flags of the file are the instructions that it
// needs. src/kernels/CMakeLists.txt and tools/scripts/checks/determinism.sh list the widths. The headers included here
// keep every function to themselves; src/kernels/lanes/lane_vector.h says why.
#include "src/kernels/kernels.h"

#include "src/kernels/body_kernels_impl.h"
#include "src/kernels/box_tests_impl.h"
#include "src/kernels/contacts/contact_impacts_impl.h"
#include "src/kernels/contacts/contact_outcomes_impl.h"
#include "src/kernels/contacts/contact_prepare_impl.h"
#include "src/kernels/contacts/contact_renew_impl.h"
#include "src/kernels/contacts/contact_solve_impl.h"
#include "src/kernels/contacts/contact_visits_impl.h"
#include "src/kernels/contacts/contact_warm_start_impl.h"
#include "src/kernels/ground_collisions_impl.h"

#ifndef TUMBLE_LANES
#error "TUMBLE_LANES must be 1, 2, 4 or 8"
#endif

namespace tumble::sim {

#if (TUMBLE_LANES == 4 && !defined(__AVX2__)) || (TUMBLE_LANES == 8 && !defined(__AVX512F__))

template <>
const Kernels* compiled_kernels<TUMBLE_LANES>() {
  return nullptr;
}

#else

namespace {

// Calls handle(V{}, batch, lane) for kWidth lanes at a time. The last lanes of a batch go to the narrowest vector that
// holds them: one manifold takes longer in eight lanes than in one.
template <int kWidth, class Handle>
void for_pack_at(ContactBatch& batch, unsigned at, Handle handle) {
  const unsigned left = batch.used - at;
  if (kWidth == 1 || left == 1) {
    handle(VectorOf<1>::Type{}, batch, at);
  } else if (kWidth == 2 || left == 2) {
    handle(typename VectorOf < kWidth < 2 ? 1 : 2 > ::Type{}, batch, at);
  } else if (kWidth == 4 || left <= 4) {
    handle(typename VectorOf < kWidth < 4 ? 1 : 4 > ::Type{}, batch, at);
  } else {
    handle(typename VectorOf<kWidth>::Type{}, batch, at);
  }
}
template <int kWidth, class Handle>
void for_packs_of(ContactBatch& batch, Handle handle) {
  // A constant place costs no registers for the addresses of all columns.
  if constexpr (kWidth == kLanes) return for_pack_at<kWidth>(batch, 0, handle);
  for (unsigned at = 0; at < batch.used; at += kWidth) for_pack_at<kWidth>(batch, at, handle);
}

template <int kWidth, class Handle>
void for_packs(const ContactWork& work, Handle handle) {
  for (std::size_t k = 0; k < work.count; ++k) for_packs_of<kWidth>(work.batches[k], handle);
}

// Asks for the batch after number k, its points and bodies while k is solved. Batches of a wide layer, 5 kB each, do
// not stay in a core's second cache from one visit to the next.
inline void fetch_next(const ContactWork& work, std::size_t k) {
  constexpr std::size_t kWide = 100;
  if (work.count < kWide || k + 1 == work.count) return;
  const auto fetch = [](const void* from, std::size_t bytes) {
    const char* const at = static_cast<const char*>(from);
    for (std::size_t line = 0; line < bytes; line += sizeof(Lanes)) __builtin_prefetch(at + line, 1);
  };
  const ContactBatch& batch = work.batches[k];
  fetch(&work.batches[k + 1], sizeof(ContactBatch));
  fetch(work.points + batch.first + batch.count, batch.count * sizeof(PointBatch));
  const BatchSides& next = work.sides[k + 1];
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    fetch(work.bodies + next.a[lane] * kSolverBodyDoubles, 1);
    fetch(work.bodies + next.b[lane] * kSolverBodyDoubles, 1);
  }
}

template <int kWidth>
[[gnu::flatten]] void prepare_all(const ContactWork& work) {
  for_packs<kWidth>(work, [&](auto v, ContactBatch& batch, unsigned at) { prepare<decltype(v)>(work, batch, at); });
}
// Solves some lanes of a batch.
template <int kWidth>
void solve_lanes(const ContactWork& work, std::size_t k, Sweep sweep, unsigned lanes) {
  ContactBatch& batch = work.batches[k];
  PointBatch* const points = work.points + batch.first;
  const bool some = lanes != used_lanes(batch);
  KeptLanes kept;
  if (some) kept.keep(batch, points);
  for_packs_of<kWidth>(batch, [&](auto v, ContactBatch& of, unsigned at) { solve<decltype(v)>(work, of, at, sweep); });
  if (some) kept.put_back(batch, points, lanes);
}
// Makes some lanes of a batch bounce and others hold. Apart, so that the usual sweeps stay small.
template <int kWidth>
[[gnu::flatten, gnu::noinline, gnu::cold]] void solve_both(const ContactWork& work, std::size_t k, unsigned bounce,
                                                           unsigned hold) {
  solve_lanes<kWidth>(work, k, Sweep::kRestitution, bounce);
  const KeptOutcomes kept(work.outcomes + 2 * k * kLanes * kOutcomeDoubles);
  solve_lanes<kWidth>(work, k, Sweep::kHold, hold);
  kept.put_back(bounce);
}
// In kRestitution the lanes that do not bounce hold.
template <int kWidth>
void solve_due(const ContactWork& work, std::size_t k, Sweep sweep, unsigned due) {
  if (sweep == Sweep::kStop) {
    sweep = Sweep::kRestitution;
  } else if (sweep == Sweep::kRestitution) {
    const unsigned bounce = due & work.batches[k].bounces, hold = due & ~bounce;
    if (bounce != 0 && hold != 0) return solve_both<kWidth>(work, k, bounce, hold);
    if (bounce == 0) sweep = Sweep::kHold;
  }
  solve_lanes<kWidth>(work, k, sweep, due);
}
template <int kWidth>
[[gnu::flatten]] Due solve_all(const ContactWork& work, Sweep sweep) {
  bool any_due = false, any_settled = false;
  for (std::size_t k = 0; k < work.count; ++k) {
    const BatchSides& sides = work.sides[k];
    const std::uint8_t* const usual = sweep == Sweep::kPart ? sides.parting : sides.sweeps;
    const std::uint8_t* const sweeps = work.visit.bounces ? sides.turns : usual;
    unsigned due = due_lanes(work.visit, sides) & lanes_in_sweep(sweeps, work.visit.sweep);
    if (sweep == Sweep::kStop) due &= work.batches[k].met & ~unsigned{work.batches[k].bounces};
    if (due == 0 && work.leaves_old) {
      any_settled = true;
      continue;
    }
    fetch_next(work, k);
    const ContactBatch& batch = work.batches[k];
    if (due != 0) {
      solve_due<kWidth>(work, k, sweep, due);
      note_visit(work.visit, work.sides[k], due);
      any_due = true;
    }
    if (due == used_lanes(batch)) continue;
    any_settled = true;
    if (!work.leaves_old) clear_outcomes(work.outcomes + 2 * k * kLanes * kOutcomeDoubles, batch.used, due);
  }
  return !any_due ? Due::kNone : any_settled ? Due::kSome : Due::kAll;
}
template <int kWidth>
[[gnu::flatten]] void warm_start_all(const ContactWork& work) {
  for_packs<kWidth>(work, [&](auto v, ContactBatch& batch, unsigned at) { warm_start<decltype(v)>(work, batch, at); });
}
template <int kWidth>
[[gnu::flatten]] void move_on_all(const ContactWork& work) {
  for_packs<kWidth>(work, [&](auto v, ContactBatch& batch, unsigned at) { move_on<decltype(v)>(work, batch, at); });
}

template <int kWidth>
[[gnu::flatten]] void renew_all(const ContactWork& work) {
  for_packs<kWidth>(work, [&](auto v, ContactBatch& batch, unsigned at) { renew<decltype(v)>(work, batch, at); });
}

template <int kWidth>
[[gnu::flatten]] double find_all_overlaps(const ContactWork& work) {
  double deepest = 0;
  for (std::size_t k = 0; k < work.count; ++k) {
    deepest = larger(deepest, mark_overlaps<typename VectorOf<kWidth>::Type>(work, work.batches[k], work.sides[k]));
  }
  return deepest;
}

template <int kWidth>
[[gnu::flatten]] void begin_all_parting(const ContactWork& work) {
  for (std::size_t k = 0; k < work.count; ++k) {
    begin_parting<typename VectorOf<kWidth>::Type>(work, work.batches[k]);
  }
}

// Calls handle(V{}, impact, lane) for the impacts [begin, end).
template <int kWidth, class Handle>
void for_impacts(const ContactWork& work, std::size_t begin, std::size_t end, Handle handle) {
  for (std::size_t k = begin; k < end; ++k) {
    ImpactBatch& impact = work.impacts[k];
    for_packs_of<kWidth>(work.batches[impact.batch],
                         [&](auto v, ContactBatch& /*of*/, unsigned at) { handle(v, impact, at); });
  }
}

template <int kWidth>
[[gnu::flatten]] void begin_all_impacts(const ContactWork& work, std::size_t begin, std::size_t end,
                                        bool has_impulses) {
  for_impacts<kWidth>(work, begin, end, [&](auto v, ImpactBatch& impact, unsigned at) {
    begin_impact<decltype(v)>(work, impact, at, has_impulses);
  });
}
template <int kWidth>
[[gnu::flatten]] void end_all_impacts(const ContactWork& work, std::size_t begin, std::size_t end) {
  for_impacts<kWidth>(work, begin, end,
                      [&](auto v, ImpactBatch& impact, unsigned at) { end_impact<decltype(v)>(work, impact, at); });
}
template <int kWidth>
[[gnu::flatten]] void end_all_whole_impacts(const ContactWork& work, std::size_t begin, std::size_t end) {
  for_impacts<kWidth>(work, begin, end, [&](auto v, ImpactBatch& impact, unsigned at) {
    end_whole_impact<decltype(v)>(work, impact, at);
  });
}

template <int kWidth>
constexpr ContactKernels contact_kernels_of() {
  return {prepare_all<kWidth>,          solve_all<kWidth>,
          warm_start_all<kWidth>,       apply_outcomes<typename VectorOf<kWidth>::Type>,
          move_on_all<kWidth>,          renew_all<kWidth>,
          find_all_overlaps<kWidth>,    begin_all_parting<kWidth>,
          begin_all_impacts<kWidth>,    end_all_impacts<kWidth>,
          end_all_whole_impacts<kWidth>};
}

}  // namespace

template <>
const Kernels* compiled_kernels<TUMBLE_LANES>() {
  static constexpr Kernels kKernels = {body_kernels_of<TUMBLE_LANES>(), box_test_kernels_of<TUMBLE_LANES>(),
                                       contact_kernels_of<TUMBLE_LANES>(), ground_kernels_of<TUMBLE_LANES>()};
  return &kKernels;
}

#endif

}  // namespace tumble::sim
