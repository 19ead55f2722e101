#include "src/thesis/find_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "src/collide/box_pair.h"
#include "src/kernels/kernels_by_width.h"
#include "src/math/grid.h"
#include "src/thesis/ground/ground_points.h"

namespace tumble::sim {
namespace {

// For the mean of up to 15 points that lie on PositionGrid or in the middle between two of its steps: 16 times as fine,
// so that no mean lies in the middle between two steps of this grid. There the body from which the mean is measured
// would decide.
using MeanGrid = Grid<40>;

struct Contact {
  Vec3 normal;  // a to b
  double depth = 0;
  Vec3 r_a;
};

// The eight corners of a box whose centre lies at `centre`.
std::array<Vec3, 8> corners(const BoxFrame& frame, const Vec3& centre) {
  const Vec3 x = frame.axes[0] * frame.half_extent.x();
  const Vec3 y = frame.axes[1] * frame.half_extent.y();
  const Vec3 z = frame.axes[2] * frame.half_extent.z();
  const std::array<Vec3, 4> base = {Vec3(-x - y), Vec3(x - y), Vec3(y - x), Vec3(x + y)};
  std::array<Vec3, 8> all;
  for (std::size_t k = 0; k < 4; ++k) {
    all[k] = centre + (base[k] - z);
    all[k + 4] = centre + (base[k] + z);
  }
  return all;
}

// The corners behind a plane, and the point that they are merged to (thesis Fig. 6).
struct Behind {
  std::array<Vec3, 8> corners;
  std::size_t count = 0;
  Vec3 point = Vec3::Zero();
};

// Merges the corners behind a plane with their depths as weights. distance: of the plane from the origin of the
// corners; height_of: of a corner over that origin; both along the normal. None where no corner lies behind.
template <class HeightOf>
bool find_behind(const std::array<Vec3, 8>& corners, double distance, HeightOf height_of, Behind& behind) {
  std::array<double, 8> depth;
  double deepest = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    depth[k] = distance - height_of(corners[k]);
    deepest = std::max(deepest, depth[k]);
  }
  if (deepest <= 0) return false;
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    if (depth[k] <= 0) continue;
    const double weight = UnitGrid::round(depth[k] / deepest);
    sum += PositionGrid::round(Vec3(corners[k] * weight));
    weights += weight;
    behind.corners[behind.count++] = corners[k];
  }
  behind.point = PositionGrid::round(Vec3(sum / weights));
  return true;
}

// The way from a point of a face's plane to the face: zero on the face itself. From the box's centre.
Vec3 way_to_face(const BoxFrame& frame, int axis, const Vec3& point) {
  const auto way = [&](int k) {
    const double along = dot(point, frame.axes[k]), half = frame.half_extent[k];
    return Vec3(frame.axes[k] * (std::clamp(along, -half, half) - along));
  };
  return way((axis + 1) % 3) + way((axis + 2) % 3);
}

// Adds the corners, measured from the point, to the patch, if there is one.
void add_patch(const Behind& behind, std::vector<Vec3>* patch) {
  if (patch == nullptr) return;
  for (std::size_t k = 0; k < behind.count; ++k) patch->push_back(behind.corners[k] - behind.point);
}

// A collision point on a face; beyond: whether Fig. 6 puts it beyond the edge.
struct FacePoint {
  Vec3 point;
  bool beyond = false;
};

// The collision point of `other` on a face of `box`, from the box's centre. `to_other`: from there to the other centre;
// outward: the normal of the face, whose plane is infinite. With a patch, so with a static box, the point and the patch
// end where the face does: what hangs over its edge is not carried.
std::optional<FacePoint> point_on_face(const BoxFrame& box, int axis, const Vec3& outward, const BoxFrame& other,
                                       const Vec3& to_other, std::vector<Vec3>* patch) {
  Behind behind;
  const auto height_of = [&](const Vec3& corner) { return dot(corner, outward); };
  if (!find_behind(corners(other, to_other), box.half_extent[axis], height_of, behind)) return std::nullopt;
  if (patch == nullptr) return FacePoint{behind.point};
  const Vec3 merged = behind.point;
  behind.point = PositionGrid::round(Vec3(merged + way_to_face(box, axis, merged)));
  for (std::size_t k = 0; k < behind.count; ++k) behind.corners[k] += way_to_face(box, axis, behind.corners[k]);
  add_patch(behind, patch);
  return FacePoint{behind.point, behind.point != merged};
}

// The collision point, from a's centre, on a face of a or b. Corners are measured in the box of the face: names of the
// two boxes exchanged, the bits stay.
std::optional<FacePoint> face_point(const BoxPair& pair, int axis, std::vector<Vec3>* patch) {
  const Vec3 normal = pair.normal(axis);
  const Vec3& d = pair.offset();
  if (axis < 3) return point_on_face(pair.a(), axis, normal, pair.b(), d, patch);
  const auto from_b = point_on_face(pair.b(), axis - 3, -normal, pair.a(), -d, patch);
  if (!from_b) return std::nullopt;
  return FacePoint{Vec3(from_b->point + d), from_b->beyond};
}

// The middle of the edge that lies farthest along `direction`, from the box's centre.
Vec3 outermost_edge(const BoxFrame& frame, int edge, const Vec3& direction) {
  const int i = (edge + 1) % 3, j = (edge + 2) % 3;
  const auto side = [&](int k) {
    const double h = frame.half_extent[k];
    return Vec3(frame.axes[k] * (dot(frame.axes[k], direction) > 0 ? h : -h));
  };
  return side(i) + side(j);
}

Vec3 edge_point(const BoxPair& pair, int axis) {
  const int i = (axis - 6) / 3, j = (axis - 6) % 3;
  const Vec3& u = pair.a().axes[i];
  const Vec3& w = pair.b().axes[j];
  const Vec3 normal = pair.normal(axis);
  const Vec3 edge_a = outermost_edge(pair.a(), i, normal);
  const Vec3 edge_b = outermost_edge(pair.b(), j, -normal);
  const Vec3 between = pair.offset() + (edge_b - edge_a);
  const double uw = dot(u, w), du = dot(between, u), dw = dot(between, w);
  const double squared_sine = 1 - uw * uw;  // > 0: BoxPair refuses parallel edges
  const double s = std::clamp((du - uw * dw) / squared_sine, -pair.a().half_extent[i], pair.a().half_extent[i]);
  const double t = std::clamp((uw * du - dw) / squared_sine, -pair.b().half_extent[j], pair.b().half_extent[j]);
  const Vec3 on_a = PositionGrid::round(Vec3(edge_a + u * s));
  const Vec3 on_b = PositionGrid::round(Vec3(edge_b + w * t));
  return (on_a + (pair.offset() + on_b)) * 0.5;
}

// The distance that a box reaches from its centre along a direction, m.
double reach(const BoxFrame& frame, const Vec3& direction) {
  const auto along = [&](int k) { return frame.half_extent[k] * std::fabs(dot(frame.axes[k], direction)); };
  return (along(0) + along(1)) + along(2);
}

// Boxes in one place part along gravity; without gravity along z, the normal of the ground.
std::optional<Contact> coincident_contact(const BoxPair& pair, const Vec3& gravity) {
  const double a = volume_measure(pair.a()), b = volume_measure(pair.b());
  if (a == b) return std::nullopt;
  const double pull = length(gravity);
  const Vec3 up = pull > 0 ? plus_zero(Vec3(gravity / -pull)) : Vec3(0, 0, 1);
  return Contact{a > b ? up : plus_zero(Vec3(-up)), reach(pair.a(), up) + reach(pair.b(), up), Vec3::Zero()};
}

// Several planes that tie, and edges, have no patch.
std::optional<Contact> pair_contact(const BoxPair& pair, AxisSet planes, const Vec3& gravity,
                                    std::vector<Vec3>* patch) {
  const BestAxes best = pair.best(planes);
  if (best.axes == 0) return coincident_contact(pair, gravity);
  Vec3 normals = Vec3::Zero(), points = Vec3::Zero();
  Contact contact;
  const std::size_t begin = patch != nullptr ? patch->size() : 0;
  int count = 0;
  bool beyond = false;
  for (int axis = 0; axis < kAxisCount; ++axis) {
    if ((best.axes & only(axis)) == 0) continue;
    const auto found = axis < 6 ? face_point(pair, axis, patch) : FacePoint{edge_point(pair, axis)};
    if (!found) continue;
    contact.normal = pair.normal(axis);
    contact.r_a = found->point;
    normals += UnitGrid::round(contact.normal);
    points += found->point;
    beyond = beyond || found->beyond;
    ++count;
  }
  if (count == 0) return std::nullopt;
  contact.depth = -best.separation;
  // An infinite plane is deepest in corners that hang over its face; along some other axis the boxes overlap less.
  if (beyond) contact.depth = std::min(contact.depth, std::max(0.0, -pair.best_of_all().separation));
  if (count > 1) {  // every normal has a part along x_b − x_a, so they do not cancel
    contact.normal = normals / length(normals);
    contact.r_a = MeanGrid::round_any(Vec3(points / count));
    if (patch != nullptr) patch->resize(begin);
  }
  return contact;
}

std::optional<Contact> ground_contact(const BoxFrame& frame, std::vector<Vec3>* patch) {
  // Corners relative to the body's centre: x and y of the body do not enter, and the ground lies `height` below.
  const double height = frame.position.z();
  Behind behind;
  const auto height_of = [](const Vec3& corner) { return corner.z(); };
  if (!find_behind(corners(frame, Vec3::Zero()), -height, height_of, behind)) return std::nullopt;
  add_patch(behind, patch);
  return Contact{Vec3(0, 0, -1), reach_along(frame, 2) - height, behind.point};
}

// Room for `count` contacts in the columns that are written here.
void make_room(Contacts& contacts, std::size_t count) {
  for (Vec3Column* column : {&contacts.normal, &contacts.r_a, &contacts.r_b}) column->resize(count);
  contacts.depth.resize(count);
  contacts.patch_end.resize(count);
}

}  // namespace

Status find_contacts(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  Contacts& contacts = scratch.contacts;
  make_room(contacts, contacts.a.size());
  contacts.patch.clear();
  const bool in_lanes = kernels(scratch.lanes).ground.find_points != nullptr;
  const std::size_t singly = in_lanes ? ground_begin(contacts) : contacts.a.size();
  std::size_t kept = 0;
  for (std::size_t k = 0; k < singly; ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const std::uint16_t planes = contacts.planes[k];
    const BoxFrame& frame = scratch.frames[a];
    const bool ground = b == kGround;
    const bool on_fixed = ground || state.bodies.is_static[a] != 0 || state.bodies.is_static[b] != 0;
    std::vector<Vec3>* patch = on_fixed ? &contacts.patch : nullptr;
    const auto contact = ground ? ground_contact(frame, patch)
                                : pair_contact(BoxPair(frame, scratch.frames[b]), planes, state.def.gravity, patch);
    if (!contact) continue;
    contacts.a[kept] = a;
    contacts.b[kept] = b;
    contacts.planes[kept] = planes;
    contacts.normal.set(kept, contact->normal);
    contacts.depth[kept] = contact->depth;
    contacts.r_a.set(kept, contact->r_a);
    contacts.r_b.set(kept,
                     ground ? Vec3(Vec3::Zero()) : Vec3(contact->r_a - (scratch.frames[b].position - frame.position)));
    contacts.patch_end[kept] = static_cast<std::uint32_t>(contacts.patch.size());
    ++kept;
  }
  if (in_lanes) kept = find_ground_points(scratch, singly, kept);
  contacts.a.resize(kept);
  contacts.b.resize(kept);
  contacts.planes.resize(kept);
  make_room(contacts, kept);
  return {};
}

void hash_find_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  const Contacts& contacts = scratch.contacts;
  hasher.add(std::span<const BodyIndex>(contacts.a));
  hasher.add(std::span<const BodyIndex>(contacts.b));
  hasher.add(std::span<const std::uint16_t>(contacts.planes));
  for (const auto* column :
       {&contacts.normal.x, &contacts.normal.y, &contacts.normal.z, &contacts.depth, &contacts.r_a.x, &contacts.r_a.y,
        &contacts.r_a.z, &contacts.r_b.x, &contacts.r_b.y, &contacts.r_b.z}) {
    hasher.add(std::span<const double>(*column));
  }
  hasher.add(doubles_of(contacts.patch));
  hasher.add(std::span<const std::uint32_t>(contacts.patch_end));
}

}  // namespace tumble::sim
