#include "src/scenes/generators.h"

#include <cmath>

#include "src/base/check.h"
#include "src/base/rng.h"
#include "src/math/trig.h"
#include "tumble/sim/limits.h"

namespace tumble::scenes {
namespace {

using Kind = sim::Origin::Kind;

// The offset of place i of n from the middle of the row. Exact, and odd about the middle: rows come out symmetric.
double from_middle(std::uint64_t i, std::uint64_t n) {
  return static_cast<double>(i) - 0.5 * static_cast<double>(n - 1);
}

// Collects the bodies of one generator and gives each what all have in common.
class Emitter {
 public:
  Emitter(const Generator& generator, Kind kind) : generator_(generator) {
    box_.size = generator.body.size;
    box_.mass = generator.body.mass;
    box_.material = generator.body.material;
    box_.frozen = generator.body.frozen;
    box_.origin.kind = kind;
    box_.origin.table = generator.table;
  }

  sim::BoxDef& prototype() { return box_; }

  void emit(std::uint64_t row, std::uint64_t column, const sim::Vec3& position) {
    sim::BoxDef box = box_;
    box.position = sim::plus_zero(position);
    box.origin.row = static_cast<std::uint32_t>(row);
    box.origin.column = static_cast<std::uint32_t>(column);
    disturb(box);
    boxes.push_back(box);
  }

  std::vector<sim::BoxDef> boxes;

 private:
  void disturb(sim::BoxDef& box) const {
    const Jitter& jitter = generator_.jitter;
    const std::uint64_t counter = boxes.size();
    if (jitter.position > 0) {
      box.position.x() += jitter.position * random_symmetric(jitter.seed, counter, 0);
      box.position.y() += jitter.position * random_symmetric(jitter.seed, counter, 1);
    }
    if (jitter.degrees > 0) {
      const double yaw = jitter.degrees * random_symmetric(jitter.seed, counter, 2);
      box.orientation = sim::normalised(sim::product(turned_about({0, 0, 1}, yaw), box.orientation));
    }
  }

  const Generator& generator_;
  sim::BoxDef box_;
};

std::vector<sim::BoxDef> boxes_of(const GridShape& shape, const Generator& generator) {
  Emitter out(generator, Kind::kGrid);
  const sim::SinCos tilt = sim::sin_cos_degrees(shape.tilt);
  const sim::Vec3& size = generator.body.size;
  out.prototype().orientation = turned_about({1, 0, 0}, shape.tilt);
  const double lowest = shape.base + 0.5 * (size.y() * tilt.sin + size.z() * tilt.cos);
  for (std::uint64_t row = 0; row < shape.rows; ++row) {
    const double along = static_cast<double>(row) * shape.pitch;
    const double y = along * tilt.cos;
    const double z = lowest + along * tilt.sin;
    for (std::uint64_t column = 0; column < shape.cols; ++column) {
      out.emit(row, column, {from_middle(column, shape.cols) * shape.pitch, y, z});
    }
  }
  return std::move(out.boxes);
}

std::vector<sim::BoxDef> boxes_of(const TowerShape& shape, const Generator& generator) {
  Emitter out(generator, Kind::kTower);
  sim::BoxDef& next = out.prototype();
  double top = shape.position.z();
  for (std::uint64_t row = 0; row < shape.count; ++row) {
    out.emit(row, 0, {shape.position.x(), shape.position.y(), top + 0.5 * next.size.z()});
    top += next.size.z();
    next.size *= shape.taper;
    next.mass *= (shape.taper * shape.taper) * shape.taper;
  }
  return std::move(out.boxes);
}

std::vector<sim::BoxDef> boxes_of(const PyramidShape& shape, const Generator& generator) {
  Emitter out(generator, Kind::kPyramid);
  const sim::Vec3& at = shape.position;
  for (std::uint64_t row = 0; row < shape.base; ++row) {
    const std::uint64_t n = shape.base - row;
    const double z = at.z() + (static_cast<double>(row) + 0.5) * generator.body.size.z();
    for (std::uint64_t i = 0; i < n; ++i) out.emit(row, i, {at.x() + from_middle(i, n) * shape.spacing, at.y(), z});
  }
  return std::move(out.boxes);
}

std::vector<sim::BoxDef> boxes_of(const WallShape& shape, const Generator& generator) {
  Emitter out(generator, Kind::kWall);
  const sim::Vec3& at = shape.position;
  for (std::uint64_t course = 0; course < shape.courses; ++course) {
    const double shift = course % 2 == 0 ? -shape.shift : shape.shift;
    const double z = at.z() + (static_cast<double>(course) + 0.5) * generator.body.size.z();
    for (std::uint64_t i = 0; i < shape.bricks; ++i) {
      out.emit(course, i, {at.x() + (from_middle(i, shape.bricks) * shape.spacing + shift), at.y(), z});
    }
  }
  return std::move(out.boxes);
}

std::vector<sim::BoxDef> boxes_of(const PileShape& shape, const Generator& generator) {
  Emitter out(generator, Kind::kPile);
  const sim::Vec3& at = shape.position;
  for (std::uint64_t layer = 0; layer < shape.nz; ++layer) {
    const double z = at.z() + static_cast<double>(layer) * shape.pitch;
    for (std::uint64_t j = 0; j < shape.ny; ++j) {
      const double y = at.y() + from_middle(j, shape.ny) * shape.pitch;
      for (std::uint64_t i = 0; i < shape.nx; ++i) {
        out.emit(layer, j * shape.nx + i, {at.x() + from_middle(i, shape.nx) * shape.pitch, y, z});
      }
    }
  }
  return std::move(out.boxes);
}

std::optional<std::uint64_t> checked(std::uint64_t count) {
  if (count > sim::kBodiesMax) return std::nullopt;
  return count;
}

}  // namespace

std::optional<std::uint64_t> body_count(const Shape& shape) {
  // A product of two counts of at most 4·10⁶ is far below 2⁶⁴; the third factor comes in only after a check.
  struct Count {
    std::optional<std::uint64_t> operator()(const GridShape& s) const { return checked(s.rows * s.cols); }
    std::optional<std::uint64_t> operator()(const TowerShape& s) const { return checked(s.count); }
    std::optional<std::uint64_t> operator()(const PyramidShape& s) const { return checked(s.base * (s.base + 1) / 2); }
    std::optional<std::uint64_t> operator()(const WallShape& s) const { return checked(s.courses * s.bricks); }
    std::optional<std::uint64_t> operator()(const PileShape& s) const {
      const std::optional<std::uint64_t> layer = checked(s.nx * s.ny);
      return layer ? checked(*layer * s.nz) : std::nullopt;
    }
  };
  return std::visit(Count{}, shape);
}

std::vector<sim::BoxDef> generate(const Generator& generator) {
  SIM_CHECK(body_count(generator.shape).has_value(), generator.shape.index());
  return std::visit([&](const auto& shape) { return boxes_of(shape, generator); }, generator.shape);
}

}  // namespace tumble::scenes
