#include "src/thesis/share_load.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "src/base/check.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// Whether the convex hull of the corners, seen along the normal, reaches as far as a point of the plane. Every two
// corners on either side of the line to the point span a segment that cuts the line; the hull ends at the farthest cut.
bool reaches(std::span<const Vec3> patch, const Vec3& point, const Vec3& normal) {
  constexpr std::size_t kCornersMax = 8;
  SIM_DCHECK(patch.size() <= kCornersMax, patch.size());
  const Vec3 across = cross(normal, point);
  const double distance = dot(point, point);  // lengths along the line are measured in lengths of `point`
  std::array<double, kCornersMax> along, beside;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    along[k] = dot(patch[k], point);
    beside[k] = dot(patch[k], across);
  }
  for (std::size_t p = 0; p < patch.size(); ++p) {
    if (beside[p] > 0) continue;
    for (std::size_t q = 0; q < patch.size(); ++q) {
      const double px = along[p], py = beside[p], qx = along[q], qy = beside[q];
      if (qy < 0) continue;
      if (py == qy ? px >= distance : px * qy - qx * py >= distance * (qy - py)) return true;
    }
  }
  return false;
}

// A part along the tangent and one along normal × tangent.
struct InPlane {
  double t = 0, u = 0;
  [[nodiscard]] double times(const InPlane& other) const { return t * other.t + u * other.u; }
};

// A body that touches an immovable one along a whole patch, and tilts about axes in the plane of it.
class Tilting {
 public:
  // normal_of: the normal in the axes of the body.
  Tilting(const ContactBody& body, const Vec3& normal, const Vec3& tangent, const Vec3& normal_of)
      : inverse_inertia_(body.inverse_inertia),
        t_(tangent),
        u_(cross(normal, t_)),
        t_of_(to_body(body.axes, t_)),
        u_of_(cross(normal_of, t_of_)),
        tt_(weighted(t_of_, t_of_, inverse_inertia_)),
        tu_(weighted(t_of_, u_of_, inverse_inertia_)),
        uu_(weighted(u_of_, u_of_, inverse_inertia_)) {}

  // The tilting that a spin is.
  [[nodiscard]] InPlane part_of(const Vec3& spin) const { return {dot(spin, t_), dot(spin, u_)}; }
  // The tilting that an angular impulse in the axes of the body gives.
  [[nodiscard]] InPlane given_by(const Vec3& turn) const {
    return {weighted(t_of_, turn, inverse_inertia_), weighted(u_of_, turn, inverse_inertia_)};
  }
  // The angular impulse in the plane that ends a tilting.
  [[nodiscard]] InPlane ended_by(const InPlane& tilt) const {
    const double determinant = tt_ * uu_ - tu_ * tu_;
    return {-(tilt.t * uu_ - tilt.u * tu_) / determinant, -(tilt.u * tt_ - tilt.t * tu_) / determinant};
  }
  // The shift, m, of a normal impulse that gives an angular impulse.
  [[nodiscard]] Vec3 shift_of(const InPlane& torque, double normal_impulse) const {
    return (u_ * torque.t - t_ * torque.u) / normal_impulse;
  }

 private:
  const Vec3& inverse_inertia_;
  Vec3 t_, u_;
  Vec3 t_of_, u_of_;  // in the axes of the body
  double tt_, tu_, uu_;
};

}  // namespace

std::optional<SharedLoad> share_load(const Touch& touch, const Meeting& meeting) {
  const bool of_a = touch.a.inverse_mass != 0;  // the other body is immovable
  const ContactBody& body = of_a ? touch.a : touch.b;
  const auto own = [&](const Turns& turns) -> const Vec3& { return of_a ? turns.a : turns.b; };
  const Vec3& normal = touch.normal;
  const Vec3 spin = touch.b.spin - touch.a.spin;
  Vec3 tangent = touch.met.tangent;
  if (meeting.slip == 0) {
    const Impulses found = impulses_of(meeting, touch.material);
    const Vec3 turning = own(touch.met.by_normal).cwiseProduct(body.inverse_inertia);
    const Vec3 given = to_world(body.axes, turning) * found.normal;
    const Vec3 tilt = along_plane(spin + given, normal);
    const double speed = length(tilt);
    if (speed <= kSlipMin) return SharedLoad{Vec3::Zero(), found};
    tangent = cross(tilt, normal) / speed;
  }
  Meeting m = meeting;
  const Tilting tilting(body, normal, tangent, own(m.normals));
  const InPlane by_normal = tilting.given_by(own(touch.met.by_normal));
  const InPlane end = tilting.ended_by(tilting.part_of(spin)), end_normal = tilting.ended_by(by_normal);
  InPlane end_friction;
  m.approach += end.times(by_normal);
  m.normal_yield += end_normal.times(by_normal);
  if (m.approach >= 0) return std::nullopt;
  if (m.slip > 0) {
    const InPlane by_friction = tilting.given_by(own(touch.met.by_tangent));
    end_friction = tilting.ended_by(by_friction);
    m.slip = std::max(0.0, m.slip + end.times(by_friction));
    m.tangent_yield += end_friction.times(by_friction);
  }
  const Impulses found = impulses_of(m, touch.material);
  const InPlane torque = {end.t + (end_normal.t * found.normal - end_friction.t * found.friction),
                          end.u + (end_normal.u * found.normal - end_friction.u * found.friction)};
  const Vec3 shift = tilting.shift_of(torque, found.normal);
  if (dot(shift, shift) > 0 && !reaches(touch.patch, shift, normal)) return std::nullopt;
  return SharedLoad{PositionGrid::round(shift), found};
}

}  // namespace tumble::sim
