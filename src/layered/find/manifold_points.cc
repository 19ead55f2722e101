#include "src/layered/find/manifold_points.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim {
namespace {

constexpr double kEdgeTolerance = 1e-3;  // of the smallest half extent of the two faces
constexpr double kParallel = 1e-12;

unsigned bit(double sign, int at) { return sign > 0 ? 1U << static_cast<unsigned>(at) : 0U; }

// The number of a corner, from its sides along `axis` and the two axes after it.
unsigned corner_of(int axis, double side, double side1, double side2) {
  return bit(side, axis) | bit(side1, (axis + 1) % 3) | bit(side2, (axis + 2) % 3);
}

// The number of an edge along `axis`, from its sides along the two axes after it.
unsigned edge_of(int axis, double side1, double side2) {
  return 4U * static_cast<unsigned>(axis) + bit(side1, 0) + bit(side2, 1);
}

// A vector in the reference face's frame: u, v in the face, w out of it.
struct InFace {
  double u, v, w;
};

// The reference face and an incident face over it, in the frame of the reference face.
//
// Textbooks clip the incident face with the sides of the reference face in turn (Sutherland and Hodgman 1974). The
// result depends on the order of the sides where corners lie on sides, and a corner that moves by one bit may become
// another kind of point. Here the three kinds of vertices of the intersection of two rectangles are found
// independently, with a tolerance that makes a corner near a side count as one kind only: incident corners first, and
// near those neither a reference corner nor a crossing.
class FacePair {
 public:
  FacePair(const ManifoldSide& side, int axis, const Manifold& m)
      : side_(side),
        axis_(axis),
        sign_(dot(side.d, side.reference->axes[axis]) < 0 ? -1.0 : 1.0),
        k1_((axis + 1) % 3),
        k2_((axis + 2) % 3),
        half_u_(side.reference->half_extent[k1_]),
        half_v_(side.reference->half_extent[k2_]),
        m_(m),
        centre_u_(dot(side.d, m.t1)),
        centre_v_(dot(side.d, m.t2)) {}

  void add_points(int incident_axis, LargeVector<ManifoldPoint>& points) {
    set_incident(incident_axis);
    earlier_ = points.size();
    const int inside = add_incident_corners(points);
    if (inside == 4) return;
    add_reference_corners(points);
    add_crossings(points);
  }

 private:
  InFace in_face(const Vec3& v) const { return {dot(v, m_.t1), dot(v, m_.t2), dot(v, m_.n)}; }

  void set_incident(int f) {
    const BoxFrame& b = *side_.incident;
    f_ = f;
    facing_ = dot(b.axes[f], m_.n) > 0 ? -1.0 : 1.0;
    j1_ = (f + 1) % 3;
    j2_ = (f + 2) % 3;
    half1_ = b.half_extent[j1_];
    half2_ = b.half_extent[j2_];
    c_ = in_face(side_.d + b.axes[f] * (facing_ * b.half_extent[f]));
    c_.w -= side_.reference->half_extent[axis_];
    e1_ = in_face(b.axes[j1_] * half1_);
    e2_ = in_face(b.axes[j2_] * half2_);
    tolerance_ = kEdgeTolerance * std::min(std::min(half_u_, half_v_), std::min(half1_, half2_));
  }

  void add(double u, double v, double w, Feature feature, LargeVector<ManifoldPoint>& points) const {
    if (w > side_.margin) return;
    for (std::size_t k = m_.first; k < earlier_; ++k) {
      if (points[k].feature == feature) return;  // shared by two tied incident faces
    }
    ManifoldPoint& point = points.emplace_back(ManifoldPoint{});
    point.p = u - centre_u_;
    point.q = v - centre_v_;
    point.separation = w;
    point.feature = feature;
  }

  int add_incident_corners(LargeVector<ManifoldPoint>& points) const {
    int inside = 0;
    for (const double s1 : {-1.0, 1.0}) {
      for (const double s2 : {-1.0, 1.0}) {
        const double u = c_.u + (s1 * e1_.u + s2 * e2_.u), v = c_.v + (s1 * e1_.v + s2 * e2_.v);
        if (std::fabs(u) > half_u_ + 2 * tolerance_ || std::fabs(v) > half_v_ + 2 * tolerance_) continue;
        ++inside;
        const unsigned corner = corner_of(f_, facing_, s1, s2);
        add(u, v, c_.w + (s1 * e1_.w + s2 * e2_.w), corner_feature(!side_.reference_is_lower_row, corner), points);
      }
    }
    return inside;
  }

  // Adds the corners of the reference face inside the incident face, except those at an incident corner. s, t: place of
  // the corner in units of the incident face's half edges.
  void add_reference_corners(LargeVector<ManifoldPoint>& points) const {
    const double det = e1_.u * e2_.v - e1_.v * e2_.u;
    if (std::fabs(det) <= kParallel) return;
    for (const double s1 : {-1.0, 1.0}) {
      for (const double s2 : {-1.0, 1.0}) {
        const double u = s1 * half_u_ - c_.u, v = s2 * half_v_ - c_.v;
        const double s = (u * e2_.v - v * e2_.u) / det, t = (e1_.u * v - e1_.v * u) / det;
        const double beyond1 = std::fabs(s) * half1_ - half1_, beyond2 = std::fabs(t) * half2_ - half2_;
        const bool inside = beyond1 < 2 * tolerance_ && beyond2 < 2 * tolerance_;
        if (!inside || (beyond1 > -tolerance_ && beyond2 > -tolerance_)) continue;
        const unsigned corner = corner_of(axis_, sign_, s1, s2 * sign_);
        add(s1 * half_u_, s2 * half_v_, c_.w + (s * e1_.w + t * e2_.w),
            corner_feature(side_.reference_is_lower_row, corner), points);
      }
    }
  }

  void add_crossings(LargeVector<ManifoldPoint>& points) const {
    for (const double s : {-1.0, 1.0}) {
      add_edge_crossings(c_, e2_, s, e1_, half1_, edge_of(j1_, s, facing_), points);
      add_edge_crossings(c_, e1_, s, e2_, half2_, edge_of(j2_, facing_, s), points);
    }
  }

  // Adds the crossings of one incident edge with the four sides of the reference face. The edge lies `s` half edges
  // `across` from the face's centre and runs along `along`.
  void add_edge_crossings(const InFace& c, const InFace& across, double s, const InFace& along, double half,
                          unsigned incident_edge, LargeVector<ManifoldPoint>& points) const {
    const InFace base = {c.u + s * across.u, c.v + s * across.v, c.w + s * across.w};
    for (const double r : {-1.0, 1.0}) {
      if (std::fabs(along.u) > kParallel) {
        const double t = (r * half_u_ - base.u) / along.u, v = base.v + t * along.v;
        if (crosses(t, half, v, half_v_)) {
          add(r * half_u_, v, base.w + t * along.w, crossing(edge_of(k2_, sign_, r), incident_edge), points);
        }
      }
      if (std::fabs(along.v) > kParallel) {
        const double t = (r * half_v_ - base.v) / along.v, u = base.u + t * along.u;
        if (crosses(t, half, u, half_u_)) {
          add(u, r * half_v_, base.w + t * along.w, crossing(edge_of(k1_, r * sign_, sign_), incident_edge), points);
        }
      }
    }
  }

  bool crosses(double t, double half, double other, double other_half) const {
    return std::fabs(t) * half < half - tolerance_ && std::fabs(other) < other_half - tolerance_;
  }

  Feature crossing(unsigned reference_edge, unsigned incident_edge) const {
    return side_.reference_is_lower_row ? crossing_feature(reference_edge, incident_edge)
                                        : crossing_feature(incident_edge, reference_edge);
  }

  const ManifoldSide& side_;
  int axis_;
  double sign_;
  int k1_, k2_;
  double half_u_, half_v_;
  const Manifold& m_;
  double centre_u_, centre_v_;

  std::size_t earlier_ = 0;  // points of all manifolds before those of this incident face
  int f_ = 0, j1_ = 0, j2_ = 0;
  double facing_ = 1, half1_ = 0, half2_ = 0, tolerance_ = 0;
  InFace c_{}, e1_{}, e2_{};
};

}  // namespace

void face_manifold(const ManifoldSide& side, int axis, Manifold& m, LargeVector<ManifoldPoint>& points) {
  const BoxFrame& a = *side.reference;
  const BoxFrame& b = *side.incident;
  const double sign = dot(side.d, a.axes[axis]) < 0 ? -1.0 : 1.0;
  m.n = a.axes[axis] * sign;
  m.t1 = a.axes[(axis + 1) % 3];
  m.t2 = a.axes[(axis + 2) % 3] * sign;
  m.d = side.d;
  m.first = static_cast<std::uint32_t>(points.size());
  double facing[3], most = 0;
  for (int k = 0; k < 3; ++k) {
    facing[k] = std::fabs(dot(b.axes[k], m.n));
    most = std::max(most, facing[k]);
  }
  FacePair faces(side, axis, m);
  for (int k = 0; k < 3; ++k) {
    if (facing[k] == most) faces.add_points(k, points);
  }
  m.count = static_cast<std::uint32_t>(points.size()) - m.first;
  double lowest = 0;
  for (std::size_t k = m.first; k < points.size(); ++k) {
    lowest = k == m.first ? points[k].separation : std::min(lowest, points[k].separation);
  }
  m.offset = a.half_extent[axis] + 0.5 * lowest - dot(side.d, m.n);
}

bool one_farthest_edge(const BoxFrame& box, int edge, const Vec3& n) {
  return dot(box.axes[(edge + 1) % 3], n) != 0 && dot(box.axes[(edge + 2) % 3], n) != 0;
}

void edge_manifold(const ManifoldSide& side, const BoxPair& pair, int axis, double separation, Manifold& m,
                   LargeVector<ManifoldPoint>& points) {
  const int i = (axis - 6) / 3, j = (axis - 6) % 3;
  const BoxFrame& a = *side.reference;
  const BoxFrame& b = *side.incident;
  m.n = pair.normal(axis);
  m.d = side.d;
  const auto outermost = [](const BoxFrame& box, int edge, const Vec3& direction, unsigned& name) {
    const int k1 = (edge + 1) % 3, k2 = (edge + 2) % 3;
    const double s1 = dot(box.axes[k1], direction) > 0 ? 1 : -1, s2 = dot(box.axes[k2], direction) > 0 ? 1 : -1;
    name = edge_of(edge, s1, s2);
    return Vec3(box.axes[k1] * (s1 * box.half_extent[k1]) + box.axes[k2] * (s2 * box.half_extent[k2]));
  };
  unsigned edge_a = 0, edge_b = 0;
  const Vec3 on_a = outermost(a, i, m.n, edge_a), on_b = outermost(b, j, -m.n, edge_b);
  const Vec3 u = a.axes[i], w = b.axes[j], between = side.d + (on_b - on_a);
  const double uw = dot(u, w), du = dot(between, u), dw = dot(between, w), squared_sine = 1 - uw * uw;
  const double s = std::clamp((du - uw * dw) / squared_sine, -a.half_extent[i], a.half_extent[i]);
  const double t = std::clamp((uw * du - dw) / squared_sine, -b.half_extent[j], b.half_extent[j]);
  const Vec3 from_b = ((on_a + u * s) - side.d + (on_b + w * t)) * 0.5;
  // The tangent frame must not depend on which box is the reference: horizontal across the normal, else along a's edge.
  const double horizontal = std::sqrt(m.n.x() * m.n.x() + m.n.y() * m.n.y());
  m.t1 = horizontal > 0 ? Vec3(m.n.y() / horizontal, -m.n.x() / horizontal, 0) : u;
  m.t2 = cross(m.n, m.t1);
  m.first = static_cast<std::uint32_t>(points.size());
  m.count = 1;
  m.offset = dot(from_b, m.n);
  ManifoldPoint& point = points.emplace_back(ManifoldPoint{});
  point.p = dot(from_b, m.t1);
  point.q = dot(from_b, m.t2);
  point.separation = separation;
  point.feature = side.reference_is_lower_row ? crossing_feature(edge_a, edge_b) : crossing_feature(edge_b, edge_a);
}

void ground_manifold(const BoxFrame& frame, double reach, Manifold& m, LargeVector<ManifoldPoint>& points) {
  m.n = {0, 0, 1};
  m.t1 = {1, 0, 0};
  m.t2 = {0, 1, 0};
  m.d = Vec3::Zero();
  m.first = static_cast<std::uint32_t>(points.size());
  const Vec3 x = frame.axes[0] * frame.half_extent.x(), y = frame.axes[1] * frame.half_extent.y(),
             z = frame.axes[2] * frame.half_extent.z();
  const double lowest = frame.position.z() - reach_along(frame, 2);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const double sx = (corner & 1U) != 0 ? 1 : -1, sy = (corner & 2U) != 0 ? 1 : -1, sz = (corner & 4U) != 0 ? 1 : -1;
    const Vec3 r = (x * sx + y * sy) + z * sz;
    const double height = frame.position.z() + r.z();
    if (height > reach) continue;
    ManifoldPoint& point = points.emplace_back(ManifoldPoint{});
    point.p = r.x();
    point.q = r.y();
    point.separation = height;
    point.feature = corner_feature(true, corner);
  }
  m.count = static_cast<std::uint32_t>(points.size()) - m.first;
  m.offset = lowest - frame.position.z();
}

}  // namespace tumble::sim
