#include "src/render/scene/solid_meshes.h"

#include <utility>

namespace tumble::render {

Status SolidMeshes::load(const Gl& gl, const std::vector<BoxLook>& bodies) {
  std::map<std::shared_ptr<const Solid>, std::vector<BoxInstance>> instances;
  for (const BoxLook& body : bodies) {
    if (body.solid != nullptr) instances[body.solid].push_back(solid_instance(body));
  }
  std::erase_if(meshes_, [&](const auto& mesh) { return !instances.contains(mesh.first); });
  for (const auto& [solid, of_solid] : instances) {
    auto found = meshes_.find(solid);
    if (found == meshes_.end()) {
      Result<BoxMesh> made = BoxMesh::create(gl, *solid);
      if (!made.ok()) return made.error();
      found = meshes_.emplace(solid, *std::move(made)).first;
    }
    found->second.load(gl, of_solid);
  }
  return {};
}

void SolidMeshes::draw(const Gl& gl) const {
  for (const auto& [solid, mesh] : meshes_) mesh.draw(gl);
}

}  // namespace tumble::render
