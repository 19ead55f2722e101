#include "src/world/body_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "src/base/text.h"
#include "src/kernels/kernels_by_width.h"
#include "src/world/body_columns.h"
#include "src/world/hash_on_the_way.h"
#include "tumble/sim/limits.h"

namespace tumble::sim {
namespace {

std::string named(const Bodies& bodies, BodyIndex i) { return "body " + std::to_string(bodies.id[i]); }

}  // namespace

std::string beyond_text(const char* quantity, const Vec3& found, double limit, const char* unit) {
  const auto digits = [](double value) { return significant(value, 9); };
  return std::string("found ") + quantity + " (" + digits(found.x()) + ", " + digits(found.y()) + ", " +
         digits(found.z()) + ") " + unit + ", wanted finite and within ±" + significant(limit, 6) + ' ' + unit;
}

Error beyond(const std::string& body, const char* quantity, const Vec3& found, double limit, const char* unit) {
  const bool left =
      limit == kPositionMax && std::isfinite(found.x()) && std::isfinite(found.y()) && std::isfinite(found.z());
  return cannot_finish(body + ": " + beyond_text(quantity, found, limit, unit) + "; " +
                       (left ? "it left the world: start nearer to the origin, stop it, or remove it before"
                             : "use smaller speeds, a smaller dt or less extreme masses"));
}

Status check_body_closely(const Bodies& bodies, BodyIndex i) {
  const Vec3 position = bodies.position[i], velocity = bodies.velocity[i], spin = bodies.spin[i];
  if (!within(position, kPositionMax)) return beyond(named(bodies, i), "position", position, kPositionMax, "m");
  if (!within(velocity, kSpeedMax)) return beyond(named(bodies, i), "velocity", velocity, kSpeedMax, "m/s");
  if (!within(spin, kSpeedMax)) return beyond(named(bodies, i), "spin", spin, kSpeedMax, "rad/s");
  const Quat q = bodies.orientation[i];
  if (nearly_unit(q)) return {};
  return cannot_finish("body " + std::to_string(bodies.id[i]) + ": found an orientation of squared length " +
                       std::to_string(squared_length(q)) + ", wanted 1");
}

Status check_moving(Bodies& bodies, LaneWidth lanes) {
  if (kernels(lanes).bodies.check(columns_of(bodies), {0, bodies.size()})) return {};
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i)) continue;
    if (Status ok = check_body(bodies, i); !ok.ok()) return ok;
  }
  return {};
}

Status check_def(const WorldDef& def) {
  const auto in = [](double value, double low, double high) { return value >= low && value <= high; };  // false for NaN
  if (!in(def.dt, kDtMin, kDtMax)) {
    return bad_input("world: found a dt of " + exact(def.dt) + " s, wanted " + exact(kDtMin) + " … 1 s");
  }
  if (method_version(def.method) == 0) {
    return bad_input("world: found method number " + std::to_string(static_cast<int>(def.method)) +
                     ", wanted thesis or layered");
  }
  if (def.substeps == 0 || def.substeps > kSubstepsMax) {
    return bad_input("world: found " + std::to_string(def.substeps) + " substeps, wanted 1 … 1024");
  }
  for (const double g : {def.gravity.x(), def.gravity.y(), def.gravity.z()}) {
    if (in(g, -kGravityMax, kGravityMax)) continue;
    return bad_input("world: found a gravity of " + exact(g) + " m/s² along an axis, wanted -10000 … 10000");
  }
  const std::pair<const char*, double> settings[] = {{"freeze_energy", def.freeze_energy},
                                                     {"freeze_time", def.freeze_time},
                                                     {"slip_speed", def.slip_speed},
                                                     {"air_drag", def.air_drag}};
  for (const auto& [name, value] : settings) {
    if (!in(value, 0, 1e9)) {
      return bad_input(std::string("world: found a ") + name + " of " + exact(value) + ", wanted 0 … 1e9");
    }
  }
  if (!material_in_range(def.ground_material)) return bad_input("world: ground: " + out_of_range(def.ground_material));
  return {};
}

std::string out_of_range(const Material& m) {
  return "found a material of friction " + exact(m.friction) + ", dynamic " + exact(m.friction_dynamic) +
         ", and restitution " + exact(m.restitution) + ", wanted friction 0 … 1000 and restitution 0 … 1";
}

bool material_in_range(const Material& m) {
  const auto in = [](double value, double high) { return value >= 0 && value <= high; };
  return in(m.friction, kFrictionMax) && in(m.friction_dynamic, kFrictionMax) && in(m.restitution, 1);
}

Status check_gain_closely(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin) {
  if (!within(velocity, kSpeedMax)) return beyond(named(bodies, i), "velocity gain", velocity, kSpeedMax, "m/s");
  if (!within(spin, kSpeedMax)) return beyond(named(bodies, i), "spin gain", spin, kSpeedMax, "rad/s");
  return {};
}

Status check_gains_closely(const Bodies& bodies, BodyIndex i, double total) {
  return cannot_finish(named(bodies, i) + ": found gains of " + significant(total, 9) +
                       " m/s or rad/s together in one substep, wanted at most " + significant(kGainTotalMax, 6) +
                       ", where their sum is exact; use smaller speeds, a smaller dt or less extreme masses");
}

void hash_frozen_velocities(const Bodies& bodies, Hasher& hasher) {
  GatheredNumbers numbers(&hasher);
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.frozen[i] == 0) continue;
    numbers.add(Vec3(bodies.velocity[i]));
    numbers.add(Vec3(bodies.spin[i]));
  }
}

void add_motion(const Bodies& bodies, std::size_t begin, std::size_t end, Hasher& hasher) {
  for (const auto* column : {&bodies.position.x, &bodies.position.y, &bodies.position.z, &bodies.orientation.w,
                             &bodies.orientation.x, &bodies.orientation.y, &bodies.orientation.z, &bodies.velocity.x,
                             &bodies.velocity.y, &bodies.velocity.z, &bodies.spin.x, &bodies.spin.y, &bodies.spin.z}) {
    hasher.add(std::span<const double>(*column).subspan(begin, end - begin));
  }
}

void hash_motion(const Bodies& bodies, Hasher& hasher) {
  for (std::size_t begin = 0; begin < bodies.size(); begin += kMotionsABlock) {
    add_motion(bodies, begin, std::min(begin + kMotionsABlock, bodies.size()), hasher);
  }
}

}  // namespace tumble::sim
