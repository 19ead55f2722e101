#include "src/render/scene/box_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "src/render/scene/material_texels.h"
#include "src/render/scene/materials.h"
#include "src/render/scene/solid.h"

namespace tumble::render {
namespace {

using sim::Vec3;

struct Vertex {
  float corner[3], normal[3], tangent[3];
};
constexpr std::size_t kVertexCount = 24;
constexpr GLsizei kIndexCount = 36;

// Faces +x, −x, +y, −y, +z, −z; the corners of each counter-clockwise seen from outside.
std::array<Vertex, kVertexCount> cube_vertices() {
  std::array<Vertex, kVertexCount> vertices{};
  for (std::size_t v = 0; v < kVertexCount; ++v) {
    const std::size_t axis = v / 8, corner = v % 4;
    const float side = v / 4 % 2 == 0 ? 1.0F : -1.0F;
    const std::size_t axis_u = (axis + 1) % 3, axis_v = (axis + 2) % 3;
    const bool right = corner == 1 || corner == 2, top = corner >= 2;
    Vertex& vertex = vertices[v];
    vertex.corner[axis] = vertex.normal[axis] = side;
    vertex.corner[axis_u] = (right ? 1.0F : -1.0F) * side;
    vertex.corner[axis_v] = top ? 1.0F : -1.0F;
    // A face that stands upright has its v upright, so that boards of a crate stand too.
    vertex.tangent[axis == 1 ? axis_v : axis_u] = 1.0F;
  }
  return vertices;
}

std::array<std::uint32_t, kIndexCount> cube_indices() {
  std::array<std::uint32_t, kIndexCount> indices{};
  constexpr std::array<std::uint32_t, 6> kCorners = {0, 1, 2, 0, 2, 3};
  for (std::size_t i = 0; i < kIndexCount; ++i) {
    indices[i] = static_cast<std::uint32_t>(i / 6 * 4 + kCorners[i % 6]);
  }
  return indices;
}

void put(float (&to)[3], const Vec3& from) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(from[k]);
}

void put_pose(BoxInstance& to, const Vec3& centre, const sim::Quat& orientation, const Vec3& half_extent) {
  const sim::Axes axes = sim::axes_of(orientation);
  put(to.centre, centre);
  put(to.axis_x, axes[0]);
  put(to.axis_y, axes[1]);
  put(to.axis_z, axes[2]);
  put(to.half_extent, half_extent);
}

BoxInstance instance_of(const BoxLook& box) {
  BoxInstance instance{};
  put_pose(instance, box.centre, box.orientation, box.half_extent);
  put(instance.velocity, box.velocity);
  put(instance.spin, box.spin);
  const Variation variation = variation_of(box);
  put(instance.tint, {variation.tint.r, variation.tint.g, variation.tint.b});
  instance.layer = static_cast<float>(box.texture);
  instance.offset[0] = variation.offset_u;
  instance.offset[1] = variation.offset_v;
  return instance;
}

// Floats of each attribute of BoxInstance, in order: centre, three axes, half extent, velocity, spin, tint, (layer,
// offset, plain).
constexpr std::array<GLint, 9> kInstanceWidths = {3, 3, 3, 3, 3, 3, 3, 3, 4};

void describe(const Gl& gl, GLuint location, GLint width, GLsizei stride, std::size_t offset, GLuint divisor) {
  gl.EnableVertexAttribArray(location);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset into the bound buffer as a pointer
  gl.VertexAttribPointer(location, width, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

}  // namespace

const char* const kBoxAttributes = R"(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal_B;
layout(location = 2) in vec3 tangent_B;
layout(location = 3) in vec3 centre;
layout(location = 4) in vec3 axis_x;
layout(location = 5) in vec3 axis_y;
layout(location = 6) in vec3 axis_z;
layout(location = 7) in vec3 half_extent;
layout(location = 8) in vec3 velocity;
layout(location = 9) in vec3 spin;
layout(location = 10) in vec3 tint_in;
layout(location = 11) in vec4 look;  // layer, offset, plain
)";

std::vector<BoxInstance> instances_of(const std::vector<BoxLook>& boxes, const View& view) {
  std::vector<double> depths(boxes.size());
  std::ranges::transform(boxes, depths.begin(), [&](const BoxLook& box) { return view.depth_of(box.centre); });
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return depths[i]; });
  std::vector<BoxInstance> instances;
  instances.reserve(boxes.size());
  for (const std::size_t i : order) {
    if (boxes[i].solid == nullptr) instances.push_back(instance_of(boxes[i]));
  }
  return instances;
}

BoxInstance solid_instance(const BoxLook& body) {
  BoxInstance instance = instance_of(body);
  put(instance.half_extent, {1, 1, 1});
  return instance;
}

std::vector<BoxInstance> instances_of(const std::vector<Marker>& markers) {
  std::vector<BoxInstance> instances;
  instances.reserve(markers.size());
  for (const Marker& marker : markers) {
    BoxInstance instance{};
    put_pose(instance, marker.centre, marker.orientation, marker.half_extent);
    put(instance.tint, {marker.colour.r, marker.colour.g, marker.colour.b});
    instance.plain = 1;
    instances.push_back(instance);
  }
  return instances;
}

BoxInstance ground_instance(const Vec3& around, double half_extent) {
  BoxInstance instance{};
  put_pose(instance, {around.x(), around.y(), -1}, {}, {half_extent, half_extent, 1});
  put(instance.tint, {1, 1, 1});
  instance.layer = kGroundLayer;
  return instance;
}

Result<BoxMesh> BoxMesh::create(const Gl& gl) {
  const auto vertices = cube_vertices();
  return create(gl, std::as_bytes(std::span(vertices)), cube_indices());
}

Result<BoxMesh> BoxMesh::create(const Gl& gl, const Solid& solid) {
  static_assert(sizeof(SolidVertex) == sizeof(Vertex), "of the same attributes");
  std::vector<std::uint32_t> indices(solid.corners.size());
  std::iota(indices.begin(), indices.end(), 0U);
  return create(gl, std::as_bytes(std::span(solid.corners)), indices);
}

Result<BoxMesh> BoxMesh::create(const Gl& gl, std::span<const std::byte> vertices,
                                std::span<const std::uint32_t> indices) {
  static_assert(sizeof(BoxInstance) == 28 * sizeof(float), "kInstanceWidths describes it");
  BoxMesh mesh;
  mesh.index_count_ = static_cast<GLsizei>(indices.size());
  mesh.array_ = GlObject::make(gl, GlObject::Kind::kVertexArray);
  mesh.vertices_ = GlObject::make(gl, GlObject::Kind::kBuffer);
  mesh.indices_ = GlObject::make(gl, GlObject::Kind::kBuffer);
  mesh.instances_ = GlObject::make(gl, GlObject::Kind::kBuffer);
  gl.BindVertexArray(mesh.array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices_.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices.data(), GL_STATIC_DRAW);
  for (GLuint location = 0; location < 3; ++location) {
    describe(gl, location, 3, sizeof(Vertex), location * 3 * sizeof(float), 0);
  }
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices_.id());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.instances_.id());
  std::size_t offset = 0;
  for (GLuint k = 0; k < kInstanceWidths.size(); ++k) {
    describe(gl, 3 + k, kInstanceWidths[k], sizeof(BoxInstance), offset, 1);
    offset += static_cast<std::size_t>(kInstanceWidths[k]) * sizeof(float);
  }
  const Status made = check_gl(gl, "making a mesh");
  if (!made.ok()) return made.error();
  return mesh;
}

void BoxMesh::load(const Gl& gl, std::span<const BoxInstance> instances) {
  count_ = static_cast<GLsizei>(instances.size());
  gl.BindBuffer(GL_ARRAY_BUFFER, instances_.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(), GL_STREAM_DRAW);
}

void BoxMesh::draw(const Gl& gl) const {
  if (count_ == 0) return;
  gl.BindVertexArray(array_.id());
  gl.DrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, count_);
}

}  // namespace tumble::render
