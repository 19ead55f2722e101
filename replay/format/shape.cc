#include "tumble/replay/shape.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kHullPointsMin = 4;

bool has_points(Shape::Kind kind) { return kind == Shape::Kind::kHull || kind == Shape::Kind::kMesh; }

bool is_length(double value) { return std::isfinite(value) && value <= kShapeLengthMax; }

Status check_round(const Shape& shape) {
  const bool long_one = shape.kind != Shape::Kind::kSphere;
  const double shortest = shape.kind == Shape::Kind::kCapsule ? 0 : std::nextafter(0.0, 1.0);
  if (shape.axis > 2) return bad_input("shape: found axis " + std::to_string(shape.axis) + ", wanted 0, 1 or 2");
  if (!(shape.radius > 0) || !is_length(shape.radius)) {
    return bad_input("shape: found a radius of " + exact_bits(shape.radius) + " m, wanted one above 0 m and up to " +
                     exact(kShapeLengthMax) + " m");
  }
  if (long_one && (!(shape.half_length >= shortest) || !is_length(shape.half_length))) {
    return bad_input("shape: found a half length of " + exact_bits(shape.half_length) + " m, wanted one up to " +
                     exact(kShapeLengthMax) + " m");
  }
  return {};
}

Status check_pointed(const Shape& shape) {
  const bool mesh = shape.kind == Shape::Kind::kMesh;
  const std::size_t least = mesh ? 3 : kHullPointsMin;
  if (shape.points.size() < least || shape.points.size() > kShapePointsMax) {
    return bad_input("shape: found " + count_text(shape.points.size(), "point") + ", wanted " + std::to_string(least) +
                     " to " + std::to_string(kShapePointsMax));
  }
  for (const sim::Vec3& point : shape.points) {
    for (int k = 0; k < 3; ++k) {
      if (is_length(std::fabs(point[k]))) continue;
      return bad_input("shape: found a coordinate of " + exact_bits(point[k]) + " m, wanted one up to " +
                       exact(kShapeLengthMax) + " m");
    }
  }
  const std::size_t corners = shape.triangles.size();
  if (corners % 3 != 0 || corners / 3 > kShapeTrianglesMax || (mesh && corners == 0) || (!mesh && corners > 0)) {
    return bad_input("shape: found " + std::to_string(corners) + " corners of triangles, wanted " +
                     (mesh ? "three for each of 1 to " + std::to_string(kShapeTrianglesMax) : "none of a hull"));
  }
  const auto wrong = std::ranges::find_if(shape.triangles, [&](std::uint32_t i) { return i >= shape.points.size(); });
  if (wrong == shape.triangles.end()) return {};
  return bad_input("shape: found a triangle with point " + std::to_string(*wrong) + " of " +
                   std::to_string(shape.points.size()));
}

}  // namespace

Hash128 hash_of(const Shape& shape) {
  Hasher hasher;
  hasher.add(static_cast<std::uint64_t>(shape.kind));
  hasher.add(std::uint64_t{shape.axis});
  hasher.add(std::bit_cast<std::uint64_t>(shape.radius));
  hasher.add(std::bit_cast<std::uint64_t>(shape.half_length));
  hasher.add(std::uint64_t{shape.points.size()});
  for (const sim::Vec3& point : shape.points) {
    for (int k = 0; k < 3; ++k) hasher.add(std::bit_cast<std::uint64_t>(point[k]));
  }
  hasher.add(std::uint64_t{shape.triangles.size()});
  hasher.add(std::span<const std::uint32_t>(shape.triangles));
  return hasher.digest();
}

Status check_shape(const Shape& shape) {
  const auto kind = static_cast<unsigned>(shape.kind);
  if (kind < 1 || kind > 5) {
    return bad_input("shape: found kind " + std::to_string(kind) + ", wanted 1 (sphere) to 5 (mesh)");
  }
  return has_points(shape.kind) ? check_pointed(shape) : check_round(shape);
}

std::string to_string(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::kSphere:
      return "sphere of radius " + exact(shape.radius) + " m";
    case Shape::Kind::kCapsule:
    case Shape::Kind::kCylinder:
      return std::string(shape.kind == Shape::Kind::kCapsule ? "capsule" : "cylinder") + " of radius " +
             exact(shape.radius) + " m and half length " + exact(shape.half_length) + " m along " +
             static_cast<char>('x' + shape.axis);
    case Shape::Kind::kHull:
      return "hull of " + count_text(shape.points.size(), "point");
    case Shape::Kind::kMesh:
      return "mesh of " + count_text(shape.triangles.size() / 3, "triangle");
  }
  return "shape";
}

sim::Vec3 size_of(const Shape& shape) {
  sim::Vec3 half = {0, 0, 0};
  if (has_points(shape.kind)) {
    for (const sim::Vec3& point : shape.points) {
      for (int k = 0; k < 3; ++k) half[k] = std::max(half[k], std::fabs(point[k]));
    }
    return half * 2.0;
  }
  half = {shape.radius, shape.radius, shape.radius};
  if (shape.kind == Shape::Kind::kCapsule) half[shape.axis] += shape.half_length;
  if (shape.kind == Shape::Kind::kCylinder) half[shape.axis] = shape.half_length;
  return half * 2.0;
}

Status check_body_info(const BodyInfo& info) {
  if (info.id == 0 || info.id > sim::kBodyIdMax) {
    return bad_input("body: found id " + std::to_string(info.id) + ", wanted 1 to " + std::to_string(sim::kBodyIdMax));
  }
  if (info.name.size() <= kColumnNameBytesMax && printable(info.name) == info.name) return {};
  return bad_input("body " + std::to_string(info.id) + ": found the name " + in_quotes(info.name) +
                   ", wanted at most " + std::to_string(kColumnNameBytesMax) +
                   " bytes of text in UTF-8 without control characters");
}

}  // namespace tumble::replay
