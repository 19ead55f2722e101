#include "replay/export/scene/gltf_scene.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "replay/export/scene/body_look.h"
#include "replay/export/scene/shape_mesh.h"
#include "src/base/text.h"
#include "src/render/scene/material_texels.h"
#include "src/render/scene/view.h"
#include "tumble/render/png.h"

namespace tumble::replay {
namespace {

constexpr double kRough = 0.9;                     // of a surface without gloss
constexpr double kGloss = 0.5;                     // taken from it where the specular mask is full
constexpr double kLightIntensity = 3;              // lux, for the exposure of usual viewers
constexpr double kHalfTurn = 0.70710678118654752;  // sine of 45 degrees

using sim::Vec3;

/// The columns of a transform, with w of each.
GltfJson matrix(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& at) {
  GltfJson numbers = GltfJson::array();
  for (const Vec3& column : {x, y, z}) {
    for (int k = 0; k < 3; ++k) numbers.push_back(column[k]);
    numbers.push_back(0);
  }
  for (int k = 0; k < 3; ++k) numbers.push_back(at[k]);
  numbers.push_back(1);
  return numbers;
}

/// A node that looks along its −z, as cameras and lights do.
GltfJson looking(const sim::Camera& camera) {
  const render::View view = render::camera_view(camera, 16, 9);
  return matrix(view.right, view.up, -view.forward, view.eye);
}

class Scene {
 public:
  Scene(const ExportPlan& plan, GltfBuffer& buffer, GltfJson& json) : plan_(plan), buffer_(buffer), json_(json) {}

  Status add() {
    GltfJson children = GltfJson::array();
    for (const ExportBody& body : plan_.bodies) {
      if (Status ok = add_body(body); !ok.ok()) return ok;
      children.push_back(children.size());
    }
    const auto add_node = [&](GltfJson node) {
      children.push_back(json_["nodes"].size());
      json_["nodes"].push_back(std::move(node));
    };
    if (plan_.header.scene.world.ground) {
      const Result<std::size_t> mesh = add_mesh(ground_mesh(kGroundEdge), "ground", render::kGroundLayer, {});
      if (!mesh.ok()) return mesh.error();
      add_node({{"name", "ground"}, {"mesh", *mesh}});
    }
    const sim::Camera& camera = plan_.header.scene.camera;
    json_["cameras"] = GltfJson::array(
        {{{"type", "perspective"},
          {"perspective", {{"yfov", camera.fov * render::kDegree}, {"znear", 0.05}, {"zfar", 10000}}}}});
    add_node({{"name", "camera"}, {"camera", 0}, {"matrix", looking(camera)}});
    sim::Camera light;
    light.position = plan_.header.scene.light.position;
    light.target = plan_.header.scene.light.target;
    const char* lights = "KHR_lights_punctual";
    json_["extensionsUsed"] = GltfJson::array({lights});
    json_["extensions"][lights]["lights"] =
        GltfJson::array({{{"type", "directional"}, {"name", "light"}, {"intensity", kLightIntensity}}});
    add_node({{"name", "light"}, {"matrix", looking(light)}, {"extensions", {{lights, {{"light", 0}}}}}});
    // z up to y up
    json_["nodes"].push_back({{"name", "world"}, {"rotation", {-kHalfTurn, 0, 0, kHalfTurn}}, {"children", children}});
    json_["scenes"] = GltfJson::array({{{"name", scene_name()}, {"nodes", {json_["nodes"].size() - 1}}}});
    json_["scene"] = 0;
    return {};
  }

 private:
  [[nodiscard]] std::string scene_name() const {
    return plan_.header.scene.name.empty() ? "session" : printable(plan_.header.scene.name);
  }

  Status add_body(const ExportBody& body) {
    const std::string name = body.name.empty() ? "body " + std::to_string(body.box.id) : printable(body.name);
    const Vec3& s = body.box.size;
    const int layer = static_cast<int>(body.box.material.texture);
    const std::string geometry = (body.shape != nullptr ? to_string(hash_of(*body.shape)) : "box") + ' ' +
                                 (layer == 0 ? "0" : "1") + ' ' + exact(s.x()) + ' ' + exact(s.y()) + ' ' +
                                 exact(s.z());
    auto known = geometries_.find(geometry);
    if (known == geometries_.end()) known = geometries_.emplace(geometry, add_geometry(mesh_of(body))).first;
    const Result<std::size_t> mesh = add_primitive(known->second, name, layer, tint_of(body));
    if (!mesh.ok()) return mesh.error();
    json_["nodes"].push_back(
        {{"name", name}, {"mesh", *mesh}, {"extras", {{"id", body.box.id}, {"mass", body.box.mass}}}});
    return {};
  }

  Result<std::size_t> add_mesh(const TriangleMesh& mesh, const std::string& name, int layer, const Colour4& tint) {
    return add_primitive(add_geometry(mesh), name, layer, tint);
  }

  /// A primitive without a material.
  GltfJson add_geometry(const TriangleMesh& mesh) {
    GltfJson primitive;
    primitive["attributes"] = {{"POSITION", buffer_.add(mesh.positions, 3, true, kGltfVertices)},
                               {"NORMAL", buffer_.add(mesh.normals, 3, false, kGltfVertices)},
                               {"TEXCOORD_0", buffer_.add(mesh.uvs, 2, false, kGltfVertices)}};
    primitive["indices"] = buffer_.add(mesh.indices);
    return primitive;
  }

  Result<std::size_t> add_primitive(GltfJson primitive, const std::string& name, int layer, const Colour4& tint) {
    const Result<std::size_t> texture = add_textures(layer);
    if (!texture.ok()) return texture.error();
    const GltfJson material = {{"name", name},
                               {"pbrMetallicRoughness",
                                {{"baseColorTexture", {{"index", *texture}}},
                                 {"baseColorFactor", {tint.r, tint.g, tint.b, 1}},
                                 {"metallicRoughnessTexture", {{"index", *texture + 1}}},
                                 {"metallicFactor", 0}}}};
    json_["materials"].push_back(material);
    primitive["material"] = json_["materials"].size() - 1;
    json_["meshes"].push_back({{"name", name}, {"primitives", {std::move(primitive)}}});
    return json_["meshes"].size() - 1;
  }

  /// The number of a layer's texture of colours; the one of its roughness follows.
  Result<std::size_t> add_textures(int layer) {
    if (const auto known = textures_.find(layer); known != textures_.end()) return known->second;
    const render::Texels texels = render::make_levels(layer).front();
    render::Image colour = render::Image::blank(render::kTexelsPerEdge, render::kTexelsPerEdge), rough = colour;
    for (std::size_t i = 0; i * 4 < texels.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) colour.rgb[i * 3 + c] = texels[i * 4 + c];
      rough.rgb[i * 3 + 1] = static_cast<std::uint8_t>(std::lround(kRough * 255 - kGloss * texels[i * 4 + 3]));
    }
    const std::size_t first = textures_.size() * 2;
    for (const render::Image& image : {colour, rough}) {
      const Result<std::vector<std::byte>> png = render::encode_png(image);
      if (!png.ok()) return png.error();
      const std::string bytes(reinterpret_cast<const char*>(png->data()), png->size());
      json_["images"].push_back({{"bufferView", buffer_.add_view(bytes)}, {"mimeType", "image/png"}});
      json_["textures"].push_back({{"source", json_["images"].size() - 1}});
    }
    textures_.emplace(layer, first);
    return first;
  }

  const ExportPlan& plan_;
  GltfBuffer& buffer_;
  GltfJson& json_;
  std::map<int, std::size_t> textures_;         // by layer
  std::map<std::string, GltfJson> geometries_;  // by what they are made of
};

}  // namespace

Status add_gltf_scene(const ExportPlan& plan, GltfBuffer& buffer, GltfJson& json) {
  json["nodes"] = GltfJson::array();
  return Scene(plan, buffer, json).add();
}

}  // namespace tumble::replay
