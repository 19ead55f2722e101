#include "replay/measure/measure_state.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "replay/measure/measure_overlap.h"
#include "replay/measure/solid.h"
#include "src/model/mass.h"

namespace tumble::replay {
namespace {

using sim::BoxFrame;
using sim::Quat;
using sim::Vec3;

// The angle, degrees, between the world's up and the direction to which the body's turn since the start carries up. A
// turn about the vertical is no tilt. For a unit quaternion (w, x, y, z) the cosine of that angle is 1 − 2(x² + y²), so
// sin(angle / 2) = √(x² + y²). The arcsine keeps small angles exact, and equal orientations give exactly 0; an
// arccosine near 1 would give 1e-8.
double tilt_between(const Quat& start, const Quat& now) {
  const Quat turn = sim::product(now, {start.w, -start.x, -start.y, -start.z});
  const double half = least(1.0, std::sqrt(turn.x * turn.x + turn.y * turn.y));  // sine of half the angle
  return 2 * std::asin(half) * 180 / std::numbers::pi;
}

/// Leaves no measure that a bound could hold for.
void spoil(StateMeasures& measures, bool has_grid) {
  for (double* value :
       {&measures.lateral_max, &measures.lateral_rms, &measures.drift_max, &measures.tilt_max, &measures.top_drop_max,
        &measures.ground_penetration_max, &measures.kinetic_linear, &measures.kinetic_rotational,
        &measures.frozen_fraction, &measures.height_max, &measures.height_min, &measures.height_mean}) {
    *value = kNotANumber;
  }
  if (has_grid) measures.column_spread = kNotANumber;
  measures.at_rest = false;
}

}  // namespace

// For a cube every axis is principal, so no turn is needed and the world's components give the same energy without
// rounding.
Vec3 spin_in_body(const Vec3& inertia, const BodyStates& s, std::size_t row) {
  const Vec3 w = s.spin[row];
  const bool round = inertia.x() == inertia.y() && inertia.y() == inertia.z();
  return round ? w : sim::to_body(sim::axes_of(s.orientation[row]), w);
}

BoxFrame frame_of(const sim::BoxDef& box, const BodyStates& s, std::size_t row) {
  return {s.position[row], sim::axes_of(s.orientation[row]), box.size / 2};
}

StateMeter::StateMeter(const sim::SceneDef& scene, BodyStates start, const MeasureOptions& options, BodyTable shapes)
    : start_(std::move(start)),
      options_(options),
      shapes_(std::move(shapes)),
      start_gravity_(scene.world.gravity),
      gravity_(scene.world.gravity),
      ground_(scene.world.ground),
      space_(scene.world.ground) {
  bodies_.reserve(scene.boxes.size());
  for (sim::BoxDef box : scene.boxes) {
    const auto at = std::ranges::lower_bound(start_.id, box.id);
    if (at == start_.id.end() || *at != box.id) continue;
    const auto row = static_cast<std::size_t>(at - start_.id.begin());
    box.position = start_.position[row];
    box.orientation = start_.orientation[row];
    box.velocity = start_.velocity[row];
    space_.add(box);
    bodies_.push_back(body_of(box));
    bodies_.back().in_start = true;
    bodies_.back().start_row = row;
  }
  number_grid_rows();
}

void StateMeter::describe(const Extras& extras) { shapes_.add(extras.bodies, extras.shapes); }

StateMeter::Body StateMeter::body_of(const sim::BoxDef& box) {
  Body body;
  body.box = box;
  body.inertia = sim::box_inertia(box.mass, box.size);
  if (const Shape* shape = shapes_.shape(box.id)) {
    has_shapes_ = true;
    body.shape = std::make_shared<const Shape>(*shape);
    body.inertia = inertia_of(*shape, box.mass, box.size);
  }
  body.measured = !box.is_static && options_.bodies.holds(box);
  if (const double speed = sim::length(box.velocity); !box.is_static && std::isfinite(speed)) {
    body.given_speed = body.told_speed = body.driven_speed = speed;
  }
  return body;
}

// Numbers the rows of all [[grid]] tables, in the order in which their bodies appear.
void StateMeter::number_grid_rows() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers;
  for (Body& body : bodies_) {
    const sim::Origin& origin = body.box.origin;
    if (origin.kind != sim::Origin::Kind::kGrid || !body.measured) continue;
    body.grid_row = numbers.try_emplace({origin.table, origin.row}, numbers.size()).first->second;
  }
  grid_rows_.resize(numbers.size());
}

void StateMeter::apply(const sim::Command& input) {
  const auto place_of = [&](sim::BodyId id) {
    return std::ranges::lower_bound(bodies_, id, {}, [](const Body& body) { return body.box.id; });
  };
  if (const auto* gravity = std::get_if<sim::SetGravity>(&input)) gravity_ = gravity->gravity;
  if (const auto* thrown = std::get_if<sim::Throw>(&input)) {
    space_.add(thrown->box);
    place(place_of(thrown->box.id), thrown->box);
    row_ids_.clear();  // bodies_ moved
  }
  if (const auto* set = std::get_if<sim::SetVelocity>(&input)) give_speed(set->id, sim::length(set->velocity), false);
  if (const auto* push = std::get_if<sim::Push>(&input)) give_speed(push->id, sim::length(push->impulse), true);
  if (const auto* removed = std::get_if<sim::Remove>(&input)) {
    const auto body = place_of(removed->id);
    if (body != bodies_.end() && body->box.id == removed->id) body->removed = true;
  }
}

// A table may lack a body for some steps: the one that comes back is the one that was there. Where an engine gives its
// id to another one, that one is measured from here on.
void StateMeter::place(std::vector<Body>::iterator at, const sim::BoxDef& box) {
  if (at == bodies_.end() || at->box.id != box.id) {
    bodies_.insert(at, body_of(box));
  } else if (at->box.size == box.size && at->box.mass == box.mass && at->box.is_static == box.is_static) {
    at->removed = false;
  } else {
    *at = body_of(box);
  }
}

// A speed that an input gives: by an impulse, kg m/s, it adds up.
void StateMeter::give_speed(sim::BodyId id, double given, bool is_impulse) {
  const auto body = std::ranges::lower_bound(bodies_, id, {}, [](const Body& one) { return one.box.id; });
  if (body == bodies_.end() || body->box.id != id || body->box.is_static) return;
  const double speed = is_impulse ? body->given_speed + given / body->box.mass : given;
  if (std::isfinite(speed)) body->given_speed = speed;
}

// Each body's own way grows at the fastest speed that it was given. Only a log of another engine gives by its states.
void StateMeter::pass(const BodyStates& now, double dt) {
  space_.pass(dt, gravity_);
  for (std::size_t row = 0; told_speeds_ && row < now.size(); ++row) {
    if (body_of_row_[row] == kNone) continue;
    Body& body = bodies_[body_of_row_[row]];
    const double speed = sim::length(now.velocity[row]);
    const double gain = speed - body.told_speed;
    if (gain <= kDrivenGain) body.driven_speed = std::max(body.driven_speed + gain, 0.0);  // false for NaN
    body.given_speed = std::max(body.given_speed, body.driven_speed);
    body.told_speed = speed;
  }
  for (Body& body : bodies_) body.given_way += body.given_speed * dt;
}

// The body's own way, or that of another one that hit it: an elastic hit passes on at most 2 m / (m + M) of a speed.
double StateMeter::reasonable_way(const Body& body) const {
  double way = body.given_way;
  for (const Body& other : bodies_) {
    if (other.box.is_static) continue;
    way = std::max(way, other.given_way * 2 * other.box.mass / (other.box.mass + body.box.mass));
  }
  return way;
}

// Bodies and rows both ascend by id, so one walk over the two lists matches them. Most steps neither add nor remove a
// body; then the ids are those of the state before and the walk is saved.
void StateMeter::find_rows(const BodyStates& now) {
  if (row_ids_ == now.id && body_of_row_.size() == now.size()) return;
  row_ids_ = now.id;
  body_of_row_.assign(now.size(), kNone);
  std::size_t row = 0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {  // both lists ascend
    while (row < now.size() && now.id[row] < bodies_[k].box.id) ++row;
    if (row < now.size() && now.id[row] == bodies_[k].box.id) {
      body_of_row_[row] = k;
    } else if (!bodies_[k].removed) {
      lose(bodies_[k], std::nullopt);  // it is gone, and no input removed it
    }
  }
}

// The one place where a body is found to be lost for a number that is none: every measure below leaves the body out,
// and spoil() then takes the value from every measure that should have included it.
void StateMeter::find_not_finite(const BodyStates& now, std::uint64_t step) {
  const auto note = [](std::optional<NotFinite>& first, const NotFinite& found) {
    if (first) ++first->bodies;
    if (!first) first = found;
  };
  for (std::size_t row = 0; row < now.size(); ++row) {
    const std::optional<NotFinite> found = replay::not_finite(now, row, step);
    if (!found) continue;
    Body* body = body_of_row_[row] == kNone ? nullptr : &bodies_[body_of_row_[row]];
    if (body != nullptr && std::exchange(body->not_finite, true)) continue;
    note(not_finite_.any, *found);
    if (body == nullptr || !(body->measured || body->box.is_static)) continue;
    note(not_finite_.chosen, *found);
    lose(*body, now.position[row]);
  }
}

StateMeasures StateMeter::measure(const BodyStates& now, std::uint64_t step, double dt) {
  step_ = step;
  find_rows(now);
  pass(now, dt);
  if (!all_finite(now)) find_not_finite(now, step);
  std::ranges::fill(grid_rows_, GridRow{kInfinity, -kInfinity, kInfinity, -kInfinity});
  StateMeasures out;
  std::size_t frozen = 0;
  out.height_max = -kInfinity;
  out.height_min = kInfinity;
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (body_of_row_[row] == kNone) continue;
    Body& body = bodies_[body_of_row_[row]];
    if (!body.measured) continue;
    ++out.bodies;
    if (body.not_finite) continue;
    frozen += now.frozen[row];
    measure_motion(body, now, row, out);
    measure_place(body, now, row, out);
    if (!body.in_start) continue;
    ++out.of_start;
    compare_with_start(body, now, row, out);
    widen_grid_row(body, now.position[row]);
  }
  if (out.of_start > 0) out.lateral_rms = std::sqrt(out.lateral_rms / static_cast<double>(out.of_start));
  out.column_spread = column_spread();
  if (out.bodies == 0) {
    out.height_max = out.height_min = 0;
  } else {
    out.frozen_fraction = static_cast<double>(frozen) / static_cast<double>(out.bodies);
    out.height_mean /= static_cast<double>(out.bodies);
  }
  if (not_finite_.chosen) spoil(out, !grid_rows_.empty());
  return out;
}

// Angular momentum is measured in world axes, where it is constant in free flight while the body's axes turn.
void StateMeter::measure_motion(Body& body, const BodyStates& now, std::size_t row, StateMeasures& out) {
  const Vec3 v = now.velocity[row], w_B = spin_in_body(body.inertia, now, row);
  const Vec3 momentum_B = w_B.cwiseProduct(body.inertia);
  const double linear = 0.5 * body.box.mass * sim::dot(v, v), rotational = 0.5 * sim::dot(w_B, momentum_B);
  const bool round = body.inertia.x() == body.inertia.y() && body.inertia.y() == body.inertia.z();
  body.track.add({.height = now.position.z[row] - body.box.size.minCoeff() / 2,
                  .rise = v.z(),
                  .spin_momentum = round ? momentum_B : sim::to_world(sim::axes_of(now.orientation[row]), momentum_B),
                  .spin_energy = rotational},
                 -gravity_.z());
  if (now.frozen[row] != 0) return;
  out.kinetic_linear += linear;
  out.kinetic_rotational += rotational;
  if (!(linear + rotational <= kRestEnergy * body.box.mass)) out.at_rest = false;
}

void StateMeter::measure_place(Body& body, const BodyStates& now, std::size_t row, StateMeasures& out) {
  const Vec3 centre = now.position[row];
  // Few bodies are ever outside, so what others may have done to the body is asked of those alone.
  if (!body.lost && !space_.holds(centre, body.given_way) && !space_.holds(centre, reasonable_way(body))) {
    lose(body, centre);
  }
  if (ground_) {
    const BoxFrame frame = frame_of(body.box, now, row);
    out.ground_penetration_max =
        largest(out.ground_penetration_max,
                body.shape ? ground_penetration(Solid{frame, body.shape.get()}) : ground_penetration(frame));
  }
  out.height_max = largest(out.height_max, centre.z());
  out.height_min = least(out.height_min, centre.z());
  out.height_mean += centre.z();  // the sum; measure() finishes it
}

void StateMeter::compare_with_start(const Body& body, const BodyStates& now, std::size_t row,
                                    StateMeasures& out) const {
  const Vec3 moved = now.position[row] - start_.position[body.start_row];
  const double lateral = options_.lateral == LateralAxis::kX ? moved.x() : moved.y();
  out.lateral_max = largest(out.lateral_max, std::fabs(lateral));
  out.lateral_rms += lateral * lateral;  // the sum; measure() finishes it
  out.drift_max = largest(out.drift_max, std::sqrt(moved.x() * moved.x() + moved.y() * moved.y()));
  out.top_drop_max = largest(out.top_drop_max, -moved.z());
  out.tilt_max = largest(out.tilt_max, tilt_between(start_.orientation[body.start_row], now.orientation[row]));
}

}  // namespace tumble::replay
