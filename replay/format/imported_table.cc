#include "tumble/replay/imported_table.h"

#include <cmath>

#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

using sim::Vec3;

constexpr double kCentimetre = 0.01;
constexpr double kMillimetre = 0.001;

EngineAxis axis_of(const Vec3& theirs) {
  int k = 0;
  while (k < 2 && theirs[k] == 0) ++k;
  return {static_cast<char>('x' + k), theirs[k] < 0 ? -1.0 : 1.0};
}

/// A product would quiet a signalling NaN, whose bits a table may give.
double scaled(double length, double metres) { return std::isnan(length) ? length : length * metres; }

Vec3 unit_vector(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

Vec3 reflected(const Vec3& v, int up) { return up == 2 ? Vec3(v.x(), -v.y(), v.z()) : Vec3(v.x(), v.y(), -v.z()); }

}  // namespace

// A left-handed engine is reflected first, along an axis of its own that lies level: up stays up. Then the axes are
// permuted cyclically until "up" is z, which keeps the handedness; y up needs one sign besides. No value is rounded.
Vec3 EngineAxes::direction(const Vec3& v) const {
  Vec3 right = left_handed ? reflected(v, up) : v;
  if (up == 0) return {right.y(), right.z(), right.x()};
  if (up == 1) return {right.x(), -right.z(), right.y()};
  return right;
}

Vec3 EngineAxes::their_direction(const Vec3& v) const {
  Vec3 right = v;
  if (up == 0) right = {v.z(), v.x(), v.y()};
  if (up == 1) right = {v.x(), v.z(), -v.y()};
  return left_handed ? reflected(right, up) : right;
}

Vec3 EngineAxes::length(const Vec3& v) const {
  const Vec3 turned = direction(v);
  return {scaled(turned.x(), metres), scaled(turned.y(), metres), scaled(turned.z(), metres)};
}

Vec3 EngineAxes::their_length(const Vec3& v) const {
  const Vec3 turned = their_direction(v);
  return {their_metres(turned.x()), their_metres(turned.y()), their_metres(turned.z())};
}

Vec3 EngineAxes::axial(const Vec3& w) const {  // a reflection reverses axial vectors
  return left_handed ? direction({-w.x(), -w.y(), -w.z()}) : direction(w);
}

Vec3 EngineAxes::their_axial(const Vec3& w) const {
  return left_handed ? their_direction({-w.x(), -w.y(), -w.z()}) : their_direction(w);
}

sim::Quat EngineAxes::turn(const sim::Quat& q) const {
  const Vec3 axis = axial({q.x, q.y, q.z});
  return {q.w, axis.x(), axis.y(), axis.z()};
}

sim::Quat EngineAxes::their_turn(const sim::Quat& q) const {
  const Vec3 axis = their_axial({q.x, q.y, q.z});
  return {q.w, axis.x(), axis.y(), axis.z()};
}

Vec3 EngineAxes::extents(const Vec3& size) const {
  const Vec3 turned = length(size);
  return {std::fabs(turned.x()), std::fabs(turned.y()), std::fabs(turned.z())};
}

EngineAxis EngineAxes::along(int k) const { return axis_of(their_direction(unit_vector(k))); }
EngineAxis EngineAxes::axial_along(int k) const { return axis_of(their_axial(unit_vector(k))); }

std::string EngineAxes::unit() const {
  if (metres == 1) return "m";
  if (metres == kCentimetre) return "cm";
  if (metres == kMillimetre) return "mm";
  return "[" + exact(metres) + " m]";
}

std::string to_string(const EngineAxes& axes) {
  std::string text(1, static_cast<char>('x' + axes.up));
  return text.append(" up, ").append(axes.left_handed ? "left" : "right").append("-handed, ").append(axes.unit());
}

Status check_table(const ImportedTable& table) {
  const auto& [up, left_handed, metres] = table.axes;
  if (up < 0 || up > 2 || !(metres > 0) || !std::isfinite(metres)) {
    return bad_input("found an imported table with axis " + std::to_string(up) + " up and " + exact(metres) +
                     " m per unit, wanted axis 0, 1 or 2 and a length above 0");
  }
  if (table.passed_over.size() <= kTableColumnsMax) return {};
  return bad_input("found " + std::to_string(table.passed_over.size()) + " columns passed over, wanted at most " +
                   std::to_string(kTableColumnsMax));
}

}  // namespace tumble::replay
