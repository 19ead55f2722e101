#include "src/solve/body_check.h"

#include <cmath>
#include <cstdio>

#include "src/model/limits.h"

namespace tumble::sim {
namespace {

// NaN fails every comparison, so the test is for what is wanted.
bool within(const Vec3& v, double limit) {
  return std::fabs(v.x()) <= limit && std::fabs(v.y()) <= limit && std::fabs(v.z()) <= limit;
}

Error beyond(const Bodies& bodies, BodyIndex i, const char* what, const Vec3& found, double limit, const char* unit) {
  char text[256];
  std::snprintf(text, sizeof text,
                "body %llu: found %s (%.9g, %.9g, %.9g) %s, wanted finite and within ±%g %s; "
                "use smaller speeds, a smaller dt or less extreme masses",
                static_cast<unsigned long long>(bodies.id[i]), what, found.x(), found.y(), found.z(), unit, limit,
                unit);
  return cannot_finish(text);
}

}  // namespace

Status check_body(const Bodies& bodies, BodyIndex i) {
  const Vec3 position = bodies.position[i], velocity = bodies.velocity[i], spin = bodies.spin[i];
  if (!within(position, kPositionMax)) return beyond(bodies, i, "position", position, kPositionMax, "m");
  if (!within(velocity, kSpeedMax)) return beyond(bodies, i, "velocity", velocity, kSpeedMax, "m/s");
  if (!within(spin, kSpeedMax)) return beyond(bodies, i, "spin", spin, kSpeedMax, "rad/s");
  return {};
}

Status check_gain(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin) {
  if (!within(velocity, kSpeedMax)) return beyond(bodies, i, "velocity gain", velocity, kSpeedMax, "m/s");
  if (!within(spin, kSpeedMax)) return beyond(bodies, i, "spin gain", spin, kSpeedMax, "rad/s");
  return {};
}

void hash_motion(const World& world, Hasher& hasher) {
  const Bodies& bodies = world.bodies();
  for (const auto* column : {&bodies.position.x, &bodies.position.y, &bodies.position.z, &bodies.orientation.w,
                             &bodies.orientation.x, &bodies.orientation.y, &bodies.orientation.z, &bodies.velocity.x,
                             &bodies.velocity.y, &bodies.velocity.z, &bodies.spin.x, &bodies.spin.y, &bodies.spin.z}) {
    hasher.add(std::span<const double>(*column));
  }
}

}  // namespace tumble::sim
