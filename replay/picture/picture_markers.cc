#include "replay/picture/picture_markers.h"

#include <algorithm>
#include <cmath>

#include "src/world/scratch.h"

namespace tumble::replay {
namespace {

using render::Colour;
using sim::Quat;
using sim::Vec3;

// They differ in lightness too, for readers without colour vision.
constexpr Colour kVelocityColour = {1.0F, 0.75F, 0.0F};
constexpr Colour kContact = {0.95F, 0.05F, 0.25F};
constexpr Colour kNormal = {0.0F, 0.55F, 0.55F};
constexpr Colour kBound = {0.02F, 0.12F, 0.9F};

// Sizes relative to the camera's distance, so that markers look equally wide in every scene.
constexpr double kShaftOverDistance = 0.0012;
constexpr double kPointOverDistance = 0.0028;

// The rotation that takes +x to a unit direction d, by the half-way construction: q = (1 + x·d, x × d), normalised. For
// d = −x that is zero, and half a turn about z serves.
Quat rotation_from_x(const Vec3& direction) {
  if (direction.x() < -0.999999) return {0, 0, 0, 1};
  return sim::normalised({1 + direction.x(), 0, -direction.z(), direction.y()});
}

double camera_distance(const render::Snapshot& snapshot) {
  return std::max(sim::length(snapshot.camera.target - snapshot.camera.position), 1.0);
}

void add_arrow(render::Snapshot& snapshot, const Vec3& from, const Vec3& along, const Colour& colour) {
  const double long_enough = sim::length(along);
  if (long_enough <= 0) return;
  const double shaft = kShaftOverDistance * camera_distance(snapshot);
  const double head = std::min(4 * shaft, long_enough / 2);
  const Vec3 direction = along / long_enough;
  const Quat turn = rotation_from_x(direction);
  snapshot.markers.push_back({from + along / 2, turn, {long_enough / 2, shaft, shaft}, colour});
  // A head of three steps; boxes are all that the renderer draws.
  for (int step = 0; step < 3; ++step) {
    const double wide = shaft * (2.8 - 0.7 * step);
    const Vec3 at = from + direction * (long_enough - head + head * (step + 0.5) / 3);
    snapshot.markers.push_back({at, turn, {head / 6, wide, wide}, colour});
  }
}

void add_contact(render::Snapshot& snapshot, const Vec3& at, const Vec3& normal) {
  const double distance = camera_distance(snapshot);
  const double size = kPointOverDistance * distance;
  add_arrow(snapshot, at, normal * (0.02 * distance), kNormal);
  snapshot.markers.push_back({at, {}, {size, size, size}, kContact});
}

void add_thesis_contacts(const sim::Scratch& scratch, render::Snapshot& snapshot) {
  const sim::Contacts& contacts = scratch.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vec3 at = scratch.frames[contacts.a[i]].position + contacts.r_a[i];
    // Normals point from a to b. The arrow shows the push on the upper one of the two.
    const bool on_a = contacts.normal.z[i] < 0;
    add_contact(snapshot, at, on_a ? Vec3(-contacts.normal[i]) : contacts.normal[i]);
  }
}

void add_manifold_points(const sim::World& world, render::Snapshot& snapshot) {
  const sim::Scratch& scratch = world.scratch();
  for (const sim::Manifold& manifold : scratch.manifolds) {
    if (manifold.asleep) continue;
    const Vec3 centre = world.bodies().position[manifold.b];
    for (const sim::ManifoldPoint& point : sim::points_of(scratch, manifold)) {
      const Vec3 at = centre + manifold.t1 * point.p + manifold.t2 * point.q + manifold.n * manifold.offset;
      if (point.impulse > 0) add_contact(snapshot, at, manifold.n.z() < 0 ? Vec3(-manifold.n) : manifold.n);
    }
  }
}

// Four edges along each axis, from corner to corner.
void add_edges(render::Snapshot& snapshot, const Vec3& centre, const Vec3& reach) {
  const double thick = kShaftOverDistance * camera_distance(snapshot);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vec3 half(thick, thick, thick);
    half[axis] += reach[axis];
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 at = centre;
      at[u] += (corner & 1) == 0 ? -reach[u] : reach[u];
      at[v] += (corner & 2) == 0 ? -reach[v] : reach[v];
      snapshot.markers.push_back({at, {}, half, kBound});
    }
  }
}

}  // namespace

void add_bounds_markers(render::Snapshot& snapshot) {
  for (const render::BoxLook& box : snapshot.boxes) {
    const sim::BoxFrame frame = {box.centre, sim::axes_of(box.orientation), box.half_extent};
    add_edges(snapshot, box.centre,
              {sim::reach_along(frame, 0), sim::reach_along(frame, 1), sim::reach_along(frame, 2)});
  }
}

void add_velocity_markers(render::Snapshot& snapshot, double seconds) {
  for (const render::BoxLook& box : snapshot.boxes) {
    if (sim::length(box.velocity) > 0.05) add_arrow(snapshot, box.centre, box.velocity * seconds, kVelocityColour);
  }
}

void add_contact_markers(const sim::World& world, render::Snapshot& snapshot) {
  if (world.state().def.method == sim::Method::kThesis) {
    add_thesis_contacts(world.scratch(), snapshot);
  } else {
    add_manifold_points(world, snapshot);
  }
}

}  // namespace tumble::replay
