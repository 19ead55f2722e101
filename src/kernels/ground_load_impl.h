#pragma once

// Corners that share a load on the ground, for any number of lanes: the operations of share_load.cc and patch_radius in
// src/thesis, in their order. lane_vector.h says who may include this.

#include "src/kernels/ground_meeting_impl.h"

namespace tumble::sim {
namespace {

// The corners of each contact's patch, from the collision point; a lane with fewer corners than others repeats its
// first one.
template <class V>
class LanePatch {
 public:
  LanePatch(const GroundCollisions& work, std::size_t at) {
    for (unsigned lane = 0; lane < kWidth; ++lane) {
      const unsigned count = work.patch_end[at + lane] - begin_of(work, at + lane);
      count_[lane] = count;
      most_ = count > most_ ? count : most_;
    }
  }

  [[nodiscard]] V counts() const { return load<V>(count_); }

  void take_corners(const GroundCollisions& work, std::size_t at) {
    for (unsigned lane = 0; lane < kWidth; ++lane) {
      const unsigned begin = begin_of(work, at + lane), count = work.patch_end[at + lane] - begin;
      for (unsigned k = 0; k < kCorners && k < most_; ++k) {
        const double* const from = work.patch + std::size_t{3} * (begin + (k < count ? k : 0));
        for (int axis = 0; axis < 3; ++axis) corner_[k][axis][lane] = from[axis];
      }
    }
  }

  // As patch_radius().
  [[nodiscard]] V radius(const Space<V>& normal) const {
    const V zero = V{} + 0.0, count = counts();
    V sum = zero;
    for (unsigned k = 0; k < kCorners && k < most_; ++k) {
      const V distance = on_grid(length(along_plane(corner(k), normal)), kPlaceMagic);
      sum = sum + (count > static_cast<double>(k) ? distance : zero);
    }
    return sum / count;
  }

  // As reaches().
  [[nodiscard]] MaskOf<V> reaches(const Space<V>& point, const Space<V>& normal) const {
    const Space<V> across = cross(normal, point);
    const V distance = dot(point, point);
    V along[kCorners], beside[kCorners];
    for (unsigned k = 0; k < kCorners && k < most_; ++k) {
      along[k] = dot(corner(k), point);
      beside[k] = dot(corner(k), across);
    }
    MaskOf<V> reached = MaskOf<V>{};
    for (unsigned p = 0; p < most_; ++p) {
      for (unsigned q = 0; q < most_; ++q) {
        const V px = along[p], py = beside[p], qx = along[q], qy = beside[q];
        const auto apart = (py <= 0.0) & (qy >= 0.0);
        const auto on_line = (py == qy) & (px >= distance);
        const auto cut = (py != qy) & (px * qy - qx * py >= distance * (qy - py));
        reached = reached | (apart & (on_line | cut));
      }
    }
    return reached;
  }

 private:
  static constexpr unsigned kWidth = sizeof(V) / sizeof(double);
  static constexpr unsigned kCorners = 8;  // of a box; named in the loops, since compilers do not know it of most_

  static unsigned begin_of(const GroundCollisions& work, std::size_t k) { return k == 0 ? 0 : work.patch_end[k - 1]; }
  [[nodiscard]] Space<V> corner(unsigned k) const {
    return {load<V>(corner_[k][0]), load<V>(corner_[k][1]), load<V>(corner_[k][2])};
  }

  alignas(64) double count_[kWidth] = {};
  alignas(64) double corner_[kCorners][3][kWidth] = {};
  unsigned most_ = 0;
};

// A part along the tangent and one along normal × tangent.
template <class V>
struct LaneInPlane {
  V t, u;
  [[nodiscard]] V times(const LaneInPlane& other) const { return t * other.t + u * other.u; }
};

// As Tilting.
template <class V>
struct LaneTilting {
  Space<V> inverse_inertia, t, u, t_of, u_of;
  V tt, tu, uu;

  LaneTilting(const LaneBody<V>& body, const Space<V>& normal, const Space<V>& tangent, const Space<V>& normal_of)
      : inverse_inertia(body.inverse_inertia),
        t(tangent),
        u(cross(normal, t)),
        t_of(to_body(body.frame.axes, t)),
        u_of(cross(normal_of, t_of)),
        tt(weighted(t_of, t_of, inverse_inertia)),
        tu(weighted(t_of, u_of, inverse_inertia)),
        uu(weighted(u_of, u_of, inverse_inertia)) {}

  [[nodiscard]] LaneInPlane<V> part_of(const Space<V>& spin) const { return {dot(spin, t), dot(spin, u)}; }
  [[nodiscard]] LaneInPlane<V> given_by(const Space<V>& turn) const {
    return {weighted(t_of, turn, inverse_inertia), weighted(u_of, turn, inverse_inertia)};
  }
  [[nodiscard]] LaneInPlane<V> ended_by(const LaneInPlane<V>& tilt) const {
    const V determinant = tt * uu - tu * tu;
    return {-(tilt.t * uu - tilt.u * tu) / determinant, -(tilt.u * tt - tilt.t * tu) / determinant};
  }
  [[nodiscard]] Space<V> shift_of(const LaneInPlane<V>& torque, V normal_impulse) const {
    return divided(u * torque.t - t * torque.u, normal_impulse);
  }
};

// As SharedLoad; `found`: in which lanes there is one.
template <class V>
struct LaneLoad {
  MaskOf<V> found;
  Space<V> shift;
  LaneImpulses<V> impulses;
};

// spin: of the ground seen from the body; normal_of: the normal in the axes of the body.
template <class V>
LaneLoad<V> share_load(const LaneBody<V>& body, const LaneEncounter<V>& met, const LaneMeeting<V>& meeting,
                       const LanePatch<V>& patch, const Space<V>& normal, const Space<V>& spin,
                       const Space<V>& normal_of) {
  const V zero = V{} + 0.0;
  const Space<V> none = {zero, zero, zero};
  Space<V> tangent = met.tangent;
  MaskOf<V> slipless = meeting.slip == 0.0, still = MaskOf<V>{};
  LaneImpulses<V> at_rest = {zero, zero, zero};
  if (any(slipless)) {
    at_rest = impulses_of(meeting, met.pull, body, true);
    const Space<V> turning = scaled(met.by_normal, body.inverse_inertia);
    const Space<V> given = to_world(body.frame.axes, turning) * at_rest.normal;
    const Space<V> tilt = along_plane(spin + given, normal);
    const V speed = length(tilt);
    still = slipless & (speed <= kSlipMin);
    tangent = chosen(slipless, divided(cross(tilt, normal), speed), tangent);
  }
  LaneMeeting<V> m = meeting;
  const LaneTilting<V> tilting(body, normal, tangent, normal_of);
  const LaneInPlane<V> by_normal = tilting.given_by(met.by_normal);
  const LaneInPlane<V> end = tilting.ended_by(tilting.part_of(spin)), end_normal = tilting.ended_by(by_normal);
  m.approach = m.approach + end.times(by_normal);
  m.normal_yield = m.normal_yield + end_normal.times(by_normal);
  const auto approaches = (m.approach >= 0.0) == 0;
  const auto slips = m.slip > 0.0;
  const LaneInPlane<V> by_friction = tilting.given_by(met.by_tangent);
  LaneInPlane<V> end_friction = tilting.ended_by(by_friction);
  end_friction = {slips ? end_friction.t : zero, slips ? end_friction.u : zero};
  m.slip = slips ? larger(zero, m.slip + end.times(by_friction)) : m.slip;
  m.tangent_yield = slips ? m.tangent_yield + end_friction.times(by_friction) : m.tangent_yield;
  const LaneImpulses<V> found = impulses_of(m, met.pull, body, true);
  const LaneInPlane<V> torque = {end.t + (end_normal.t * found.normal - end_friction.t * found.friction),
                                 end.u + (end_normal.u * found.normal - end_friction.u * found.friction)};
  const Space<V> shift = tilting.shift_of(torque, found.normal);
  const MaskOf<V> moves = dot(shift, shift) > 0.0, reached = patch.reaches(shift, normal);
  const MaskOf<V> inside = (moves == 0) | reached;
  LaneLoad<V> load;
  load.found = still | (approaches & inside);
  load.shift = chosen(still, none, on_grid(shift, kPlaceMagic));
  load.impulses = {still ? at_rest.normal : found.normal, still ? at_rest.friction : found.friction,
                   still ? at_rest.twist : found.twist};
  return load;
}

}  // namespace
}  // namespace tumble::sim
