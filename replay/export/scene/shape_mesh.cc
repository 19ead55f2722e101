#include "replay/export/scene/shape_mesh.h"

#include <array>
#include <cmath>

#include "replay/export/scene/convex_hull.h"

namespace tumble::replay {
namespace {

using sim::Vec3;

constexpr int kAround = 32;  // corners of a circle
constexpr int kUp = 16;      // rings of a sphere
constexpr double kPi = 3.14159265358979323846;
constexpr double kGrainU = 0.45, kGrainV = 0.55;  // repeats of a texture per m, along and across the longer edge

void add_vertex(const Vec3& at, const Vec3& normal, double u, double v, TriangleMesh& mesh) {
  for (int k = 0; k < 3; ++k) {
    mesh.positions.push_back(static_cast<float>(at[k]));
    mesh.normals.push_back(static_cast<float>(normal[k]));
  }
  mesh.uvs.push_back(static_cast<float>(u));
  mesh.uvs.push_back(static_cast<float>(v));
}

void add_quad(std::uint32_t first, TriangleMesh& mesh) {
  for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + k);
}

TriangleMesh box_mesh(const Vec3& size, bool is_crate) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const int first = (axis + 1) % 3, second = (axis + 2) % 3;
      Vec3 normal = {0, 0, 0};
      normal[axis] = sign;
      const auto begin = static_cast<std::uint32_t>(mesh.vertices());
      const std::array<std::array<double, 2>, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
      for (const auto& [a, b] : corners) {
        Vec3 at = size / 2;
        at[axis] *= sign;
        at[first] *= a * sign;  // the other face runs the other way round
        at[second] *= b;
        double u = a * size[first] / 2, v = b * size[second] / 2;
        if (size[first] < size[second]) std::swap(u, v);
        if (is_crate) {
          add_vertex(at, normal, a / 2 + 0.5, b / 2 + 0.5, mesh);
        } else {
          add_vertex(at, normal, u * kGrainU, v * kGrainV, mesh);
        }
      }
      add_quad(begin, mesh);
    }
  }
  return mesh;
}

/// A point around `axis`: r sideways in direction `turn`, h along.
Vec3 around(int axis, double r, double turn, double h) {
  Vec3 at = {0, 0, 0};
  at[axis] = h;
  at[(axis + 1) % 3] = r * std::cos(turn);
  at[(axis + 2) % 3] = r * std::sin(turn);
  return at;
}

/// Turns a profile (distance from the axis, height; and its normal) about the axis.
struct Profile {
  double r, h, normal_r, normal_h;
};

void add_turned(int axis, const std::vector<Profile>& profile, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices());
  for (const Profile& point : profile) {
    for (int k = 0; k <= kAround; ++k) {
      const double turn = 2 * kPi * k / kAround;
      add_vertex(around(axis, point.r, turn, point.h), around(axis, point.normal_r, turn, point.normal_h),
                 static_cast<double>(k) / kAround, point.h * kGrainV, mesh);
    }
  }
  const auto row = static_cast<std::uint32_t>(kAround + 1);
  for (std::uint32_t i = 0; i + 1 < profile.size(); ++i) {
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(kAround); ++k) {
      const std::uint32_t a = first + i * row + k, b = a + row;
      for (const std::uint32_t index : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(index);
    }
  }
}

/// A sphere that is pulled apart along an axis by `half_length` to either side.
TriangleMesh capsule_mesh(const Shape& shape) {
  std::vector<Profile> profile;
  for (int i = 0; i <= kUp; ++i) {
    const double angle = kPi * (static_cast<double>(i) / kUp - 0.5);
    const double c = i == 0 || i == kUp ? 0 : std::cos(angle), s = std::sin(angle);
    const double apart = i * 2 < kUp ? -shape.half_length : shape.half_length;
    if (i * 2 == kUp && shape.half_length > 0) profile.push_back({shape.radius, -shape.half_length, 1, 0});
    profile.push_back({shape.radius * c, shape.radius * s + apart, c, s});
  }
  TriangleMesh mesh;
  add_turned(shape.axis, profile, mesh);
  return mesh;
}

TriangleMesh cylinder_mesh(const Shape& shape) {
  const double r = shape.radius, h = shape.half_length;
  TriangleMesh mesh;
  add_turned(shape.axis, {{0, -h, 0, -1}, {r, -h, 0, -1}}, mesh);
  add_turned(shape.axis, {{r, -h, 1, 0}, {r, h, 1, 0}}, mesh);
  add_turned(shape.axis, {{r, h, 0, 1}, {0, h, 0, 1}}, mesh);
  return mesh;
}

/// Flat triangles; those without an area are left out.
TriangleMesh flat_mesh(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& triangles) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vec3 &a = points[triangles[i]], &b = points[triangles[i + 1]], &c = points[triangles[i + 2]];
    const Vec3 normal = sim::cross(b - a, c - a);
    const double area = sim::length(normal);
    if (!(area > 0)) continue;
    for (const Vec3& at : {a, b, c}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices()));
      add_vertex(at, normal / area, at.x() * kGrainU + at.z() * kGrainV, at.y() * kGrainV, mesh);
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh mesh_of(const ExportBody& body) {
  TriangleMesh box = box_mesh(body.box.size, body.box.material.texture == sim::Texture::kCrate);
  if (body.shape == nullptr) return box;
  const Shape& shape = *body.shape;
  switch (shape.kind) {
    case Shape::Kind::kSphere:
    case Shape::Kind::kCapsule:
      return capsule_mesh(shape);
    case Shape::Kind::kCylinder:
      return cylinder_mesh(shape);
    case Shape::Kind::kHull:
    case Shape::Kind::kMesh:
      break;
  }
  const bool is_hull = shape.kind == Shape::Kind::kHull;
  TriangleMesh mesh = flat_mesh(shape.points, is_hull ? convex_hull(shape.points) : shape.triangles);
  return mesh.indices.empty() ? box : mesh;
}

TriangleMesh ground_mesh(double edge) {
  constexpr double kGroundRepeats = 0.25;  // per m
  TriangleMesh mesh;
  const std::array<std::array<double, 2>, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const auto& [a, b] : corners) {
    const double x = a * edge / 2, y = b * edge / 2;
    add_vertex({x, y, 0}, {0, 0, 1}, x * kGroundRepeats, y * kGroundRepeats, mesh);
  }
  add_quad(0, mesh);
  return mesh;
}

}  // namespace tumble::replay
