#pragma once

#include <map>
#include <memory>
#include <vector>

#include "src/render/scene/box_mesh.h"
#include "tumble/render/snapshot.h"

namespace tumble::render {

/// A mesh for each solid of a snapshot, drawn once per body. Meshes are kept while a snapshot needs them.
class SolidMeshes {
 public:
  /// Takes the bodies that have a solid. Errors (kCannotFinish): the driver has no memory for a mesh.
  Status load(const Gl& gl, const std::vector<BoxLook>& bodies);
  void draw(const Gl& gl) const;
  [[nodiscard]] bool empty() const { return meshes_.empty(); }

 private:
  std::map<std::shared_ptr<const Solid>, BoxMesh> meshes_;
};

}  // namespace tumble::render
