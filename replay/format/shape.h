#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/sim/hash.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"
#include "tumble/sim/vec.h"

/// Names and shapes of bodies of other engines. Our own bodies are boxes and have neither.
namespace tumble::replay {

/// A shape in the body's own axes, around its centre of mass. The body's `size` stays the box around it.
struct Shape {
  enum class Kind : std::uint8_t { kSphere = 1, kCapsule = 2, kCylinder = 3, kHull = 4, kMesh = 5 };
  Kind kind = Kind::kSphere;
  std::uint8_t axis = 2;                      ///< of capsule and cylinder: 0 x, 1 y, 2 z
  double radius = 0;                          ///< m, > 0; of sphere, capsule and cylinder
  double half_length = 0;                     ///< m, >= 0; of a capsule without its caps, > 0 of a cylinder
  std::vector<sim::Vec3> points = {};         ///< m; a hull is the convex hull of at least 4
  std::vector<std::uint32_t> triangles = {};  ///< of a mesh: three indices into `points` each
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// XXH3-128 of kind and dimensions: the name of the shape in a log.
Hash128 hash_of(const Shape& shape);

/// Errors (kBadInput): a dimension that is no finite number or not above 0, an index of no point, too many points.
Status check_shape(const Shape& shape);

/// "sphere of radius 0.5 m", "hull of 12 points".
std::string to_string(const Shape& shape);

/// The edge lengths of the box around a shape, m: twice the largest reach from the centre along each axis.
sim::Vec3 size_of(const Shape& shape);

/// The name and the shape of a body.
struct BodyInfo {
  sim::BodyId id = 0;
  std::string name;    ///< at most 200 bytes of text; empty: none
  Hash128 shape = {};  ///< of a Shape of the log; zero: the box of the body's size
  friend bool operator==(const BodyInfo&, const BodyInfo&) = default;
};

/// Errors (kBadInput): an id or a name that no log can keep.
Status check_body_info(const BodyInfo& info);

}  // namespace tumble::replay
