// What StateMeter says of all bodies together: overlaps, energies, the worst of any body, the rows of grids.
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "replay/measure/measure_overlap.h"
#include "replay/measure/measure_state.h"
#include "replay/measure/solid.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

using sim::BoxFrame;
using sim::Vec3;

// sim::kinetic_energy for the values in a log.
double kinetic_of(const sim::BoxDef& box, const Vec3& inertia, const BodyStates& s, std::size_t row) {
  const Vec3 v = s.velocity[row], w_B = spin_in_body(inertia, s, row);
  return 0.5 * (box.mass * sim::dot(v, v) + sim::dot(w_B, w_B.cwiseProduct(inertia)));
}

}  // namespace

void StateMeter::lose(Body& body, const std::optional<Vec3>& place) {
  if (!body.measured || std::exchange(body.lost, true)) return;
  ++lost_;
  if (!first_lost_) first_lost_ = FirstLost{body.box.id, step_, place};
}

double StateMeter::overlap_max(const BodyStates& now) {
  if (not_finite_.any) return kNotANumber;
  find_rows(now);
  if (has_shapes_) return deepest_of_shapes(now);
  std::vector<BoxFrame> boxes;
  std::vector<std::uint8_t> left_out;
  boxes.reserve(now.size());
  left_out.reserve(now.size());
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (body_of_row_[row] == kNone) continue;
    const Body& body = bodies_[body_of_row_[row]];
    boxes.push_back(frame_of(body.box, now, row));
    left_out.push_back(body.measured ? 0 : 1);
  }
  return deepest_overlap(boxes, left_out);
}

double StateMeter::deepest_of_shapes(const BodyStates& now) {
  std::vector<Solid> solids;
  std::vector<std::uint8_t> left_out;
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (body_of_row_[row] == kNone) continue;
    const Body& body = bodies_[body_of_row_[row]];
    solids.push_back({frame_of(body.box, now, row), body.shape.get()});
    left_out.push_back(body.measured ? 0 : 1);
  }
  return deepest_overlap(solids, left_out, is_upper_bound_);
}

std::optional<double> StateMeter::kinetic_by_shapes(const BodyStates& now) {
  if (!has_shapes_) return std::nullopt;
  find_rows(now);
  double kinetic = 0;
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (body_of_row_[row] == kNone || now.frozen[row] != 0) continue;
    const Body& body = bodies_[body_of_row_[row]];
    if (!body.box.is_static) kinetic += kinetic_of(body.box, body.inertia, now, row);
  }
  return kinetic;
}

std::vector<std::string> StateMeter::approximations() const {
  const auto count = [this](auto matches) {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(bodies_, [&](const Body& body) { return body.shape && matches(body); }));
  };
  const auto is_mesh = [](const Body& body) { return body.shape->kind == Shape::Kind::kMesh; };
  const std::uint64_t meshes = count(is_mesh);
  const std::uint64_t unknown = count([&](const Body& body) {
    return (is_mesh(body) || body.shape->kind == Shape::Kind::kHull) && !body.box.is_static;
  });
  std::vector<std::string> notes;
  if (meshes > 0) notes.push_back("overlaps of " + count_text(meshes, "body") + " with a mesh are not measured");
  if (is_upper_bound_) {
    notes.emplace_back("overlaps with a cylinder or a hull, and of a capsule with a box, are upper bounds");
  }
  if (unknown > 0) {
    notes.push_back("rotational energies of " + count_text(unknown, "body") +
                    " with a hull or a mesh use the inertia of the box around the body");
  }
  return notes;
}

StateMeter::Keeping StateMeter::keeping() const {
  Keeping worst;
  std::optional<std::uint64_t> bounces;
  const auto take = [](std::optional<double>& most, const std::optional<double>& value) {
    if (value) most = most ? largest(*most, *value) : *value;
  };
  for (const Body& body : bodies_) {
    if (!body.measured) continue;
    take(worst.momentum_drift, body.track.momentum_drift());
    take(worst.spin_energy_gain, body.track.spin_energy_gain());
    take(worst.bounce_height_loss, body.track.bounce_height_loss());
    bounces = std::min(bounces.value_or(body.track.bounces()), body.track.bounces());
  }
  worst.bounces = bounces.value_or(0);
  return worst;
}

// Counters of a log begin with step 1, so the energy of the start is computed here. Its sum runs in the solver's order,
// and the value equals the one a counter would have.
StateMeter::StartEnergy StateMeter::start_energy() const {
  double kinetic = 0, potential = 0, above_rest = 0;  // in the order of sim::total_energy, for equal bits
  for (const Body& body : bodies_) {
    if (!body.in_start || body.box.is_static) continue;
    const Vec3 position = start_.position[body.start_row];
    if (start_.frozen[body.start_row] == 0) kinetic += kinetic_of(body.box, body.inertia, start_, body.start_row);
    potential -= body.box.mass * sim::dot(start_gravity_, position);
    if (!ground_ || start_gravity_.z() >= 0) continue;
    const double rest = body.box.size.minCoeff() / 2;
    above_rest += body.box.mass * -start_gravity_.z() * largest(0.0, position.z() - rest);
  }
  return {kinetic, potential, kinetic + above_rest};
}

void StateMeter::widen_grid_row(const Body& body, const Vec3& position) {
  if (body.grid_row == kNone) return;
  GridRow& span = grid_rows_[body.grid_row];
  const double across = options_.lateral == LateralAxis::kX ? position.y() : position.x();
  span.across_low = least(span.across_low, across);
  span.across_high = largest(span.across_high, across);
  span.z_low = least(span.z_low, position.z());
  span.z_high = largest(span.z_high, position.z());
}

// In a tilted grid the bodies of one row start at one height and one place across; an exact solver keeps them so.
std::optional<double> StateMeter::column_spread() const {
  std::optional<double> widest;
  for (const GridRow& row : grid_rows_) {
    const double wide = largest(row.across_high - row.across_low, row.z_high - row.z_low);
    if (wide != -kInfinity) widest = largest(widest.value_or(0), wide);  // −infinity: its bodies were all removed
  }
  return widest;
}

}  // namespace tumble::replay
