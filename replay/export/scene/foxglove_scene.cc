#include "replay/export/scene/foxglove_scene.h"

#include <map>

#include "replay/export/scene/body_look.h"
#include "replay/export/scene/shape_mesh.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr double kGroundThickness = 0.02;  // m

void set(foxglove::Vector3& to, const sim::Vec3& v) {
  to.set_x(v.x());
  to.set_y(v.y());
  to.set_z(v.z());
}

void set(foxglove::Color& to, const Colour4& colour) {
  to.set_r(colour.r);
  to.set_g(colour.g);
  to.set_b(colour.b);
  to.set_a(1);
}

/// At `at` of the entity's frame, with its z axis along axis `along` of it.
void set_pose(foxglove::Pose& pose, const sim::Vec3& at, int along = 2) {
  constexpr double kHalf = 0.70710678118654752;
  set(*pose.mutable_position(), at);
  pose.mutable_orientation()->set_w(along == 2 ? 1 : kHalf);
  if (along == 0) pose.mutable_orientation()->set_y(kHalf);
  if (along == 1) pose.mutable_orientation()->set_x(-kHalf);
}

void add_cylinder(const Shape& shape, const Colour4& colour, foxglove::SceneEntity& entity) {
  foxglove::CylinderPrimitive& cylinder = *entity.add_cylinders();
  set_pose(*cylinder.mutable_pose(), {0, 0, 0}, shape.axis);
  set(*cylinder.mutable_size(), {2 * shape.radius, 2 * shape.radius, 2 * shape.half_length});
  cylinder.set_bottom_scale(1);
  cylinder.set_top_scale(1);
  set(*cylinder.mutable_color(), colour);
}

void add_sphere(const sim::Vec3& at, double radius, const Colour4& colour, foxglove::SceneEntity& entity) {
  foxglove::SpherePrimitive& sphere = *entity.add_spheres();
  set_pose(*sphere.mutable_pose(), at);
  set(*sphere.mutable_size(), {2 * radius, 2 * radius, 2 * radius});
  set(*sphere.mutable_color(), colour);
}

void add_cube(const sim::Vec3& at, const sim::Vec3& size, const Colour4& colour, foxglove::SceneEntity& entity) {
  foxglove::CubePrimitive& cube = *entity.add_cubes();
  set_pose(*cube.mutable_pose(), at);
  set(*cube.mutable_size(), size);
  set(*cube.mutable_color(), colour);
}

void add_triangles(const ExportBody& body, const Colour4& colour, foxglove::SceneEntity& entity) {
  const TriangleMesh mesh = mesh_of(body);
  foxglove::TriangleListPrimitive& triangles = *entity.add_triangles();
  set_pose(*triangles.mutable_pose(), {0, 0, 0});
  set(*triangles.mutable_color(), colour);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    foxglove::Point3& point = *triangles.add_points();
    point.set_x(static_cast<double>(mesh.positions[i]));
    point.set_y(static_cast<double>(mesh.positions[i + 1]));
    point.set_z(static_cast<double>(mesh.positions[i + 2]));
  }
  for (const std::uint32_t index : mesh.indices) triangles.add_indices(index);
}

void add_body(const ExportBody& body, foxglove::SceneEntity& entity) {
  const Colour4 colour = colour_of(body);
  if (body.shape == nullptr) return add_cube({0, 0, 0}, body.box.size, colour, entity);
  const Shape& shape = *body.shape;
  switch (shape.kind) {
    case Shape::Kind::kSphere:
      return add_sphere({0, 0, 0}, shape.radius, colour, entity);
    case Shape::Kind::kCylinder:
      return add_cylinder(shape, colour, entity);
    case Shape::Kind::kCapsule: {
      add_cylinder(shape, colour, entity);
      sim::Vec3 end = {0, 0, 0};
      end[shape.axis] = shape.half_length;
      add_sphere(end, shape.radius, colour, entity);
      return add_sphere(-end, shape.radius, colour, entity);
    }
    case Shape::Kind::kHull:
    case Shape::Kind::kMesh:
      return add_triangles(body, colour, entity);
  }
}

}  // namespace

std::vector<std::string> frame_names(const ExportPlan& plan) {
  std::map<std::string, int> used;
  for (const ExportBody& body : plan.bodies) ++used[body.name];
  std::vector<std::string> names;
  for (const ExportBody& body : plan.bodies) {
    const bool unique =
        !body.name.empty() && body.name != kWorldFrame && !body.name.starts_with("body_") && used[body.name] == 1;
    names.push_back(unique ? body.name : "body_" + std::to_string(body.box.id));
  }
  return names;
}

foxglove::SceneUpdate scene_at(const ExportPlan& plan, std::size_t index, const std::vector<std::string>& frames) {
  foxglove::SceneUpdate scene;
  scene.add_deletions()->set_type(foxglove::SceneEntityDeletion::ALL);
  if (plan.header.scene.world.ground) {
    foxglove::SceneEntity& ground = *scene.add_entities();
    ground.set_id("ground");
    ground.set_frame_id(kWorldFrame);
    add_cube({0, 0, -kGroundThickness / 2}, {kGroundEdge, kGroundEdge, kGroundThickness}, ground_colour(), ground);
  }
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    if (!plan.bodies[i].at(index)) continue;
    foxglove::SceneEntity& entity = *scene.add_entities();
    entity.set_id("body_" + std::to_string(plan.bodies[i].box.id));
    entity.set_frame_id(frames[i]);
    entity.set_frame_locked(true);
    foxglove::KeyValuePair& mass = *entity.add_metadata();
    mass.set_key("mass_kg");
    mass.set_value(exact(plan.bodies[i].box.mass));
    add_body(plan.bodies[i], entity);
  }
  return scene;
}

}  // namespace tumble::replay
