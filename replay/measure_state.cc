#include "replay/measure_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "replay/measure_overlap.h"
#include "src/model/mass.h"

namespace tumble::replay {
namespace {

using sim::BoxFrame;
using sim::Quat;
using sim::Vec3;

// The angle, degrees, between the world's up and where a body's turn since the start has carried it. A turn about the
// vertical is no tilt, and equal orientations give exactly 0.
double tilt_between(const Quat& start, const Quat& now) {
  const Quat turn = sim::product(now, {start.w, -start.x, -start.y, -start.z});
  const double half = std::min(1.0, std::sqrt(turn.x * turn.x + turn.y * turn.y));  // sine of half the angle
  return 2 * std::asin(half) * 180 / std::numbers::pi;
}

// As sim::kinetic_energy, from what a log says of a body.
double kinetic_of(const sim::BoxDef& box, const Vec3& inertia, const BodyStates& s, std::size_t row) {
  const Vec3 v = s.velocity[row], w = s.spin[row];
  const bool round = inertia.x() == inertia.y() && inertia.y() == inertia.z();
  const Vec3 w_B = round ? w : sim::to_body(sim::axes_of(s.orientation[row]), w);
  return 0.5 * (box.mass * sim::dot(v, v) + sim::dot(w_B, w_B.cwiseProduct(inertia)));
}

BoxFrame frame_of(const sim::BoxDef& box, const BodyStates& s, std::size_t row) {
  return {s.position[row], sim::axes_of(s.orientation[row]), box.size / 2};
}

}  // namespace

StateMeter::StateMeter(const sim::SceneDef& scene, BodyStates start)
    : start_(std::move(start)), gravity_(scene.world.gravity), ground_(scene.world.ground) {
  bodies_.reserve(scene.boxes.size());
  for (const sim::BoxDef& box : scene.boxes) {
    Body body{.box = box, .inertia = sim::box_inertia(box.mass, box.size)};
    const auto at = std::ranges::lower_bound(start_.id, box.id);
    body.in_start = at != start_.id.end() && *at == box.id;
    body.start_row = static_cast<std::size_t>(at - start_.id.begin());
    bodies_.push_back(body);
  }
  number_grid_rows();
}

void StateMeter::number_grid_rows() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers;
  for (Body& body : bodies_) {
    const sim::Origin& origin = body.box.origin;
    if (origin.kind != sim::Origin::Kind::kGrid || !body.in_start || body.box.is_static) continue;
    body.grid_row = numbers.try_emplace({origin.table, origin.row}, numbers.size()).first->second;
  }
  grid_rows_.resize(numbers.size());
}

void StateMeter::add_thrown(const sim::BoxDef& box) {
  const auto at = std::ranges::lower_bound(bodies_, box.id, {}, [](const Body& body) { return body.box.id; });
  bodies_.insert(at, Body{.box = box, .inertia = sim::box_inertia(box.mass, box.size)});
  row_ids_.clear();  // bodies_ moved
}

void StateMeter::find_rows(const BodyStates& now) {
  if (row_ids_ == now.id && body_of_row_.size() == now.size()) return;
  row_ids_ = now.id;
  body_of_row_.assign(now.size(), kNone);
  std::size_t k = 0;
  for (std::size_t row = 0; row < now.size(); ++row) {  // both lists ascend
    while (k < bodies_.size() && bodies_[k].box.id < now.id[row]) ++k;
    if (k < bodies_.size() && bodies_[k].box.id == now.id[row]) body_of_row_[row] = k;
  }
}

StateMeasures StateMeter::measure(const BodyStates& now) {
  find_rows(now);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::ranges::fill(grid_rows_, GridRow{kInfinity, -kInfinity, kInfinity, -kInfinity});
  StateMeasures out;
  std::size_t dynamic = 0, from_start = 0, frozen = 0;
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (body_of_row_[row] == kNone) continue;
    Body& body = bodies_[body_of_row_[row]];
    if (body.box.is_static) continue;
    ++dynamic;
    frozen += now.frozen[row];
    if (now.frozen[row] == 0) {
      const double kinetic = kinetic_of(body.box, body.inertia, now, row);
      out.kinetic += kinetic;
      if (!(kinetic <= kRestEnergy * body.box.mass)) out.at_rest = false;
    }
    if (ground_) {
      out.ground_penetration_max =
          std::max(out.ground_penetration_max, ground_penetration(frame_of(body.box, now, row)));
      if (now.position.z[row] < 0 && !std::exchange(body.lost, true)) ++lost_;
    }
    if (!body.in_start) continue;
    ++from_start;
    compare_with_start(body, now, row, out);
    widen_grid_row(body, now.position[row]);
  }
  if (from_start > 0) out.lateral_rms = std::sqrt(out.lateral_rms / static_cast<double>(from_start));
  if (dynamic > 0) out.frozen_fraction = static_cast<double>(frozen) / static_cast<double>(dynamic);
  out.column_spread = column_spread();
  return out;
}

void StateMeter::compare_with_start(const Body& body, const BodyStates& now, std::size_t row,
                                    StateMeasures& out) const {
  const Vec3 moved = now.position[row] - start_.position[body.start_row];
  out.lateral_max = std::max(out.lateral_max, std::fabs(moved.x()));
  out.lateral_rms += moved.x() * moved.x();  // the sum; measure() finishes it
  out.drift_max = std::max(out.drift_max, std::sqrt(moved.x() * moved.x() + moved.y() * moved.y()));
  out.top_drop_max = std::max(out.top_drop_max, -moved.z());
  out.tilt_max = std::max(out.tilt_max, tilt_between(start_.orientation[body.start_row], now.orientation[row]));
}

void StateMeter::widen_grid_row(const Body& body, const Vec3& position) {
  if (body.grid_row == kNone) return;
  GridRow& span = grid_rows_[body.grid_row];
  span.y_low = std::min(span.y_low, position.y());
  span.y_high = std::max(span.y_high, position.y());
  span.z_low = std::min(span.z_low, position.z());
  span.z_high = std::max(span.z_high, position.z());
}

std::optional<double> StateMeter::column_spread() const {
  if (grid_rows_.empty()) return std::nullopt;
  double widest = 0;  // a row whose bodies were all removed is −infinity wide
  for (const GridRow& row : grid_rows_) widest = std::max({widest, row.y_high - row.y_low, row.z_high - row.z_low});
  return widest;
}

double StateMeter::overlap_max(const BodyStates& now) {
  find_rows(now);
  std::vector<BoxFrame> boxes;
  std::vector<std::uint8_t> is_static;
  boxes.reserve(now.size());
  is_static.reserve(now.size());
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (body_of_row_[row] == kNone) continue;
    const sim::BoxDef& box = bodies_[body_of_row_[row]].box;
    boxes.push_back(frame_of(box, now, row));
    is_static.push_back(box.is_static ? 1 : 0);
  }
  return deepest_overlap(boxes, is_static);
}

StateMeter::StartEnergy StateMeter::start_energy() const {
  double kinetic = 0, potential = 0, above_rest = 0;  // summed as sim::total_energy does, for equal bits
  for (const Body& body : bodies_) {
    if (!body.in_start || body.box.is_static) continue;
    const Vec3 position = start_.position[body.start_row];
    if (start_.frozen[body.start_row] == 0) kinetic += kinetic_of(body.box, body.inertia, start_, body.start_row);
    potential -= body.box.mass * sim::dot(gravity_, position);
    if (!ground_ || gravity_.z() >= 0) continue;
    const double rest = body.box.size.minCoeff() / 2;
    above_rest += body.box.mass * -gravity_.z() * std::max(0.0, position.z() - rest);
  }
  return {kinetic, potential, kinetic + above_rest};
}

}  // namespace tumble::replay
