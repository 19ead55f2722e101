#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "src/render/gl/objects.h"
#include "src/render/scene/view.h"
#include "tumble/render/snapshot.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// One box as the shaders read it: floats, world axes. The layout is that of the vertex attributes (box_mesh.cc).
struct BoxInstance {
  float centre[3];
  float axis_x[3], axis_y[3], axis_z[3];  ///< unit vectors, the axes of the box in world axes
  float half_extent[3];                   ///< m
  float velocity[3];                      ///< m/s
  float spin[3];                          ///< rad/s
  float tint[3];
  float layer;      ///< of the materials
  float offset[2];  ///< of the texture
  float plain;      ///< 1: the tint without light, in focus; else 0
};

struct Solid;

/// Instances of the boxes of a snapshot, the nearest to `view` first, so that hidden surfaces are not shaded. Bodies
/// with a solid are left out.
std::vector<BoxInstance> instances_of(const std::vector<BoxLook>& boxes, const View& view);
std::vector<BoxInstance> instances_of(const std::vector<Marker>& markers);
/// A body with a solid, whose corners are in m.
BoxInstance solid_instance(const BoxLook& body);
/// The plane z = 0 as the top of a huge flat box around a point.
BoxInstance ground_instance(const sim::Vec3& around, double half_extent);

/// A unit cube or a solid, drawn once per instance.
///
/// | location | attribute             | per vertex or instance  |
/// |----------|-----------------------|-------------------------|
/// | 0        | corner, ±1 (solid: m) | vertex                  |
/// | 1        | normal, own axes      | vertex                  |
/// | 2        | tangent, own axes (solid: place on the surface) | vertex |
/// | 3 … 12   | BoxInstance, in order | instance                |
class BoxMesh {
 public:
  BoxMesh() = default;
  static Result<BoxMesh> create(const Gl& gl);
  static Result<BoxMesh> create(const Gl& gl, const Solid& solid);
  /// Replaces the instances that draw() draws.
  void load(const Gl& gl, std::span<const BoxInstance> instances);
  void draw(const Gl& gl) const;

 private:
  static Result<BoxMesh> create(const Gl& gl, std::span<const std::byte> vertices,
                                std::span<const std::uint32_t> indices);

  GlObject vertices_, indices_, instances_, array_;
  GLsizei index_count_ = 0;
  GLsizei count_ = 0;
};

/// The declarations of these attributes, for vertex shaders.
extern const char* const kBoxAttributes;

}  // namespace tumble::render
