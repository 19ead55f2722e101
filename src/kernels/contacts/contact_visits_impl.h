#pragma once

// Which manifolds of a batch a visit solves, for any number of lanes. lane_vector.h says who may include this.

#include "src/kernels/contacts/contact_kernels.h"
#include "src/kernels/lanes/lane_vector.h"

namespace tumble::sim {
namespace {

inline unsigned used_lanes(const ContactBatch& batch) { return (1U << batch.used) - 1U; }

// Whether a manifold was solved since `first` and neither body has moved since. Numbers of visits, of one manifold or
// of each lane's.
template <class Number, class First>
auto settled(Number last, First first, Number moved_a, Number moved_b) {
  return (last >= first) & (moved_a < last) & (moved_b < last);
}

// The lanes whose manifold is due, a bit each.
inline unsigned due_lanes(const Visit& visit, const BatchSides& sides) {
#ifdef __AVX2__
  typedef std::int32_t Numbers
      __attribute__((vector_size(4 * kLanes)));  // NOLINT(modernize-use-using): GCC wants it so
  const auto moved_at = [&](const std::uint32_t* rows) {
    __m256i at;
    __builtin_memcpy(&at, rows, sizeof at);
    return reinterpret_cast<Numbers>(_mm256_i32gather_epi32(reinterpret_cast<const int*>(visit.moved), at, 4));
  };
  Numbers last;
  __builtin_memcpy(&last, sides.visited, sizeof last);
  const Numbers rest = settled(last, static_cast<std::int32_t>(visit.first), moved_at(sides.a), moved_at(sides.b));
  return ~static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(rest))) & 0xffU;
#else
  unsigned due = 0;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    const bool rests =
        settled(sides.visited[lane], visit.first, visit.moved[sides.a[lane]], visit.moved[sides.b[lane]]);
    due |= static_cast<unsigned>(!rests) << lane;
  }
  return due;
#endif
}

// The lanes that get more than `sweep` sweeps, a bit each. sweeps: of each lane, at most 127.
inline unsigned lanes_in_sweep(const std::uint8_t* sweeps, std::uint32_t sweep) {
#ifdef __AVX2__
  const __m128i more = _mm_cmpgt_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(sweeps)),
                                      _mm_set1_epi8(static_cast<char>(sweep)));
  return static_cast<unsigned>(_mm_movemask_epi8(more)) & 0xffU;
#else
  unsigned lanes = 0;
  for (unsigned lane = 0; lane < kLanes; ++lane) lanes |= static_cast<unsigned>(sweeps[lane] > sweep) << lane;
  return lanes;
#endif
}

inline void note_visit(const Visit& visit, BatchSides& sides, unsigned due) {
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    if ((due >> lane & 1U) != 0) sides.visited[lane] = visit.now;
  }
}

// What a visit changes in a batch, so that lanes that are not due keep it: a vector cannot leave out single lanes.
class KeptLanes {
 public:
  void keep(const ContactBatch& batch, const PointBatch* points) {
    for (unsigned k = 0; k < kFields; ++k) copy(fields_[k], batch.*kField[k]);
    for (unsigned k = 0; k < batch.count; ++k) {
      copy(impulse_[k], points[k].impulse);
      copy(peak_[k], points[k].peak);
    }
  }

  // Puts back the lanes outside `due`.
  void put_back(ContactBatch& batch, PointBatch* points, unsigned due) const {
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      if ((due >> lane & 1U) != 0) continue;
      for (unsigned k = 0; k < kFields; ++k) (batch.*kField[k]).of[lane] = fields_[k][lane];
      for (unsigned k = 0; k < batch.count; ++k) {
        points[k].impulse.of[lane] = impulse_[k][lane];
        points[k].peak.of[lane] = peak_[k][lane];
      }
    }
  }

 private:
  static constexpr unsigned kFields = 4;
  static constexpr Lanes ContactBatch::*kField[kFields] = {&ContactBatch::force1, &ContactBatch::force2,
                                                           &ContactBatch::twist, &ContactBatch::sliding};
  using Eight = double[kLanes];  // unlike Lanes, costs nothing where it is not used

  static void copy(Eight& to, const Lanes& from) { __builtin_memcpy(to, from.of, sizeof from.of); }

  Eight fields_[kFields], impulse_[kPointsMax], peak_[kPointsMax];
};

// The outcomes of a batch. rows: of the batch.
class KeptOutcomes {
 public:
  explicit KeptOutcomes(double* rows) : rows_(rows) { __builtin_memcpy(kept_, rows, sizeof kept_); }

  void put_back(unsigned lanes) const {
    constexpr std::size_t kDoubles = 2 * kOutcomeDoubles;  // of both bodies
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      if ((lanes >> lane & 1U) == 0) continue;
      __builtin_memcpy(rows_ + lane * kDoubles, kept_ + lane * kDoubles, kDoubles * sizeof(double));
    }
  }

 private:
  double* rows_;
  double kept_[2 * kOutcomeDoubles * kLanes];
};

// Zeros the outcomes of the lanes outside `due`. rows: of the batch.
inline void clear_outcomes(double* rows, unsigned used, unsigned due) {
  constexpr std::size_t kDoubles = 2 * kOutcomeDoubles;  // of both bodies
  for (unsigned lane = 0; lane < used; ++lane) {
    if ((due >> lane & 1U) == 0) __builtin_memset(rows + lane * kDoubles, 0, kDoubles * sizeof(double));
  }
}

// Marks the manifolds that do not overlap beyond the slop as visited; returns the deepest overlap beyond it, or 0.
template <class V>
double mark_overlaps(const ContactWork& work, const ContactBatch& batch, BatchSides& sides) {
  double deepest = 0;
  for (unsigned at = 0; at < kLanes; at += sizeof(V) / sizeof(double)) {
    const V slop = load<V>(batch.slop.of + at);
    V depth = V{};
    for (unsigned k = 0; k < batch.count; ++k) {
      depth = larger(depth, -(load<V>(work.points[batch.first + k].separation.of + at) + slop));
    }
    alignas(V) double depths[sizeof(V) / sizeof(double)];
    store(depths, depth);
    for (const double& one : depths) {
      const auto lane = at + static_cast<unsigned>(&one - depths);
      if (lane < batch.used) sides.visited[lane] = one > 0 ? 0 : work.visit.first;
      deepest = larger(deepest, one);
    }
  }
  return deepest;
}

}  // namespace
}  // namespace tumble::sim
