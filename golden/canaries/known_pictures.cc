#include <span>
#include <string>
#include <vector>

#include "golden/canaries/known_answers.h"
#include "golden/suite/temporary_folder.h"
#include "src/base/text.h"
#include "src/render/picture/image_difference.h"
#include "src/render/scene/box_mesh.h"
#include "src/render/scene/camera_moves.h"
#include "src/render/scene/material_texels.h"
#include "src/render/scene/solid.h"
#include "src/render/scene/view.h"
#include "tumble/render/png.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

using sim::Vec3;

// The first digits of a hash.
std::string digits(const Hasher& hasher) { return to_string(hasher.digest()).substr(0, 12); }

std::string point_text(const Vec3& v) { return fixed(v.x(), 4) + " " + fixed(v.y(), 4) + " " + fixed(v.z(), 4); }

std::string textures() {
  std::string found;
  for (int layer = 0; layer < render::kLayerCount; ++layer) {
    Hasher hasher;
    for (const render::Texels& level : render::make_levels(layer)) hasher.add(std::span<const std::uint8_t>(level));
    found += (layer > 0 ? " " : "") + digits(hasher);
  }
  return found;
}

std::string look_text(const sim::Camera& camera) {
  return point_text(camera.position) + " to " + point_text(camera.target) + " focus " + fixed(camera.focus, 4) + "; ";
}

// A camera moved by hand, one movement after another, to both ends of its ways.
std::string movements() {
  sim::Camera camera = {{3, -10, 2}, {1, 2, 1}, 50, 6, 1};
  std::string found;
  const auto orbit = [&](double right, double up, bool ground) {
    render::orbit(camera, right, up, ground);
    found += look_text(camera);
  };
  orbit(30, 10, true);
  orbit(-100, 100, true);
  orbit(0, -200, true);
  orbit(0, -200, false);
  orbit(200, 120, false);
  render::pan(camera, 0.25, -0.5);
  found += look_text(camera);
  for (const double factor : {0.5, 1e-6, 1e9, 1e-3}) {
    render::zoom(camera, factor);
    found += look_text(camera);
  }
  render::shift(camera, {1, 2, 3});
  return found + look_text(camera);
}

std::string look_text(const render::View& view) {
  std::string found = point_text(view.eye) + ", " + point_text(view.right) + ", " + point_text(view.up) + ", " +
                      point_text(view.forward) + ", " + fixed(view.tangent_x, 5) + " " + fixed(view.tangent_y, 5) +
                      " " + fixed(view.near, 4) + " " + fixed(view.far, 2) + ",";
  for (const double entry : view.clip_from_world) found += " " + fixed(entry, 5);
  return found + "; ";
}

std::string all_views() {
  render::Snapshot snapshot;
  std::string found;
  for (const sim::Camera& camera :
       {sim::Camera{{3, -10, 2}, {1, 2, 1}, 50, 6, 1}, sim::Camera{{0, 0, 9}, {0, 0, 0}, 20, 6, 1}})
    found += look_text(render::camera_view(camera, 400, 300));
  for (const double far : {0.0, 20.0, 300.0}) {
    render::BoxLook& box = snapshot.boxes.emplace_back();
    box.centre = {far, far / 2, 1};
    found += look_text(render::light_view(snapshot));
  }
  return found;
}

std::string look_text(const render::Solid& solid) {
  Hasher hasher;
  for (const render::SolidVertex& corner : solid.corners) {
    for (const auto* numbers : {corner.at, corner.normal, corner.place})
      hasher.add({numbers[0] + 0.0, numbers[1] + 0.0, numbers[2] + 0.0});
  }
  return std::to_string(solid.corners.size()) + " " + digits(hasher) + "; ";
}

std::string solids() {
  std::vector<Vec3> points = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}, {1, 1, 1}, {0.5, 0.5, 0.25}, {2, 3, 0}};
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 3, 1};
  std::string found;
  for (int axis = 0; axis < 3; ++axis)
    found += look_text(render::make_capsule(axis, 0.5, 1)) + look_text(render::make_cylinder(axis, 0.5, 1));
  found += look_text(render::make_capsule(2, 0.75, 0)) + look_text(render::make_mesh(points, triangles)) +
           look_text(render::make_hull(points));
  points.resize(3);
  return found + look_text(render::make_hull(points));
}

// Boxes on their way between two states, and what the shaders get of them.
std::string all_instances() {
  render::Snapshot before, after;
  before.camera = after.camera = {{0, -10, 2}, {0, 0, 2}, 60, 10, 0};
  for (std::uint64_t id = 1; id <= 4; ++id) {
    render::BoxLook box;
    box.id = id;
    box.centre = {0, static_cast<double>(7 * id % 5), 1};
    box.half_extent = {0.5, 0.25, 1};
    box.texture = static_cast<sim::Texture>(id % 5);
    if (id != 4) before.boxes.push_back(box);
    box.centre = box.centre + Vec3(0.5, 0.25, 0.125);
    box.velocity = {1, 2, 3};
    box.spin = {3, 2, 1};
    box.orientation = sim::normalised({id == 2 ? -1.0 : 1.0, 0.5, 0, 0.25});
    if (id != 1) after.boxes.push_back(box);
  }
  const render::Snapshot half = render::between(before, after, 0.25, 0.5);
  std::string found;
  for (const render::BoxInstance& one : render::instances_of(half.boxes, render::camera_view(half.camera, 400, 300))) {
    std::vector<double> numbers;
    for (const auto* three :
         {one.centre, one.axis_x, one.axis_y, one.axis_z, one.half_extent, one.velocity, one.spin, one.tint})
      for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<double>(three[k]));
    for (const float more : {one.layer, one.offset[0], one.offset[1], one.plain})
      numbers.push_back(static_cast<double>(more));
    for (const double number : numbers) found += fixed(number, 3) + " ";
    found += "; ";
  }
  return found;
}

render::Image stripes(int shift) {
  render::Image image = render::Image::blank(20, 16);
  for (std::size_t k = 0; k < image.rgb.size(); ++k)
    image.rgb[k] = static_cast<std::uint8_t>(k % 7 * 30 + (k % 11 == 0 ? static_cast<std::size_t>(shift) : 0));
  return image;
}

std::string differences() {
  std::string found;
  for (const int shift : {0, 1, 8, 9, 60}) {
    const render::ImageDifference difference = render::difference_of(stripes(0), stripes(shift));
    Hasher hasher;
    hasher.add(std::span<const std::uint8_t>(render::difference_map(stripes(0), stripes(shift)).rgb));
    found += std::to_string(difference.pixels) + " " + std::to_string(difference.far_off) + " " +
             std::to_string(difference.largest) + " " + digits(hasher) + "; ";
  }
  return found;
}

std::string kept_picture() {
  const TemporaryFolder scratch("tumble-canary");
  const std::string path = (scratch.path() / "a.png").string();
  if (const Status ok = render::write_png(path, stripes(5), {{"Title", "µ"}, {"Comment", "b"}}); !ok.ok())
    return ok.error().message;
  const Result<render::PngFile> file = render::read_png(path);
  if (!file.ok()) return file.error().message;
  std::string found = file->image == stripes(5) ? "alike" : "another picture";
  for (const auto& [key, text] : file->text) found.append(", ").append(key).append(" ").append(text);
  return found;
}

}  // namespace

void run_known_pictures(CanaryRoll& roll) {
  roll.known("textures are as they were", textures,
             "c3127e0bcb2e c98576b84a74 87b6fd3829c0 1af1231d4dbd 71bd60f9d64a cc3ad8ff99a7");
  roll.known("a camera moves as it moved", movements,
             "8.5042 -7.1156 4.0973 to 1.0000 2.0000 1.0000 focus 6.0000; 0.6291 1.7905 13.1991 to 1.0000 2.0000 "
             "1.0000 focus 6.0000; -9.5958 -3.9856 0.0500 to 1.0000 2.0000 1.0000 focus 6.0000; 0.6291 1.7905 -11.1991 "
             "to 1.0000 2.0000 1.0000 focus 6.0000; 7.7281 9.8671 7.4685 to 1.0000 2.0000 1.0000 focus 6.0000; 7.5256 "
             "14.0092 2.6414 to 0.7975 6.1421 -3.8271 focus 6.0000; 4.1616 10.0756 -0.5929 to 0.7975 6.1421 -3.8271 "
             "focus 3.0000; 0.8527 6.2065 -3.7741 to 0.7975 6.1421 -3.8271 focus 0.0492; 5512.6688 6451.1272 5295.3655 "
             "to 0.7975 6.1421 -3.8271 focus 4915.3915; 6.3094 12.5871 1.4721 to 0.7975 6.1421 -3.8271 focus 4.9154; "
             "7.3094 14.5871 4.4721 to 1.7975 8.1421 -0.8271 focus 4.9154; ");
  roll.known("camera and light see what they saw", all_views,
             "3.0000 -10.0000 2.0000, 0.9864 0.1644 -0.0000, -0.0135 0.0808 0.9966, -0.1638 0.9831 -0.0819, 0.62174 "
             "0.46631 0.1000 2000.00, 1.58650 -0.02888 -0.16386 -0.16385 0.26442 0.17329 0.98318 0.98308 -0.00000 "
             "2.13730 -0.08193 -0.08192 -2.11533 -2.45501 10.28721 10.48617; 0.0000 0.0000 9.0000, 1.0000 -0.0000 "
             "0.0000, 0.0000 1.0000 0.0000, 0.0000 0.0000 -1.0000, 0.23510 0.17633 0.1000 2000.00, 4.25346 0.00000 "
             "0.00000 0.00000 -0.00000 5.67128 0.00000 0.00000 0.00000 0.00000 -1.00010 -1.00000 0.00000 0.00000 "
             "8.80089 9.00000; 10.0000 -10.0000 25.0000, 0.7071 0.7071 -0.0000, -0.6155 0.6155 0.4924, -0.3482 0.3482 "
             "-0.8704, 0.09766 0.09766 0.5745 287.23, 7.24077 -6.30228 -0.34955 -0.34816 7.24077 6.30228 0.34955 "
             "0.34816 -0.00000 5.04183 -0.87388 -0.87039 0.00000 0.00000 27.68672 28.72281; 10.0000 -10.0000 25.0000, "
             "0.7071 0.7071 -0.0000, -0.6155 0.6155 0.4924, -0.3482 0.3482 -0.8704, 1.13687 1.13687 0.5745 287.23, "
             "0.62198 -0.54136 -0.34955 -0.34816 0.62198 0.54136 0.34955 0.34816 -0.00000 0.43309 -0.87388 -0.87039 "
             "0.00000 0.00000 27.68672 28.72281; 10.0000 -10.0000 25.0000, 0.7071 0.7071 -0.0000, -0.6155 0.6155 "
             "0.4924, -0.3482 0.3482 -0.8704, 1.13687 1.13687 0.5745 287.23, 0.62198 -0.54136 -0.34955 -0.34816 "
             "0.62198 0.54136 0.34955 0.34816 -0.00000 0.43309 -0.87388 -0.87039 0.00000 0.00000 27.68672 28.72281; ");
  roll.known("round bodies, hulls and meshes have the triangles that they had", solids,
             "6912 2663205dcf93; 576 05604fcbcd3e; 6912 dc8d9b70b5e1; 576 829e2488be92; 6912 8f45a20ea950; 576 "
             "90c334aa722a; 6624 12751a5c7645; 12 ee274bde4488; 24 03f1aba75ab6; 0 99aa06d30147; ");
  roll.known(
      "boxes between two states are drawn where they were drawn", all_instances,
      "0.125 1.062 1.031 0.994 0.111 0.013 -0.111 0.969 0.222 0.013 -0.222 0.975 0.500 0.250 1.000 0.250 0.500 "
      "0.750 0.750 0.500 0.250 1.053 1.052 1.052 3.000 0.555 0.708 0.000 ; 0.125 2.500 0.000 0.905 0.381 0.190 "
      "-0.381 0.524 0.762 0.190 -0.762 0.619 0.500 0.250 1.000 1.000 2.000 3.000 3.000 2.000 1.000 1.000 1.000 "
      "1.000 4.000 0.765 0.205 0.000 ; 0.125 4.062 1.031 0.994 -0.111 0.013 0.111 0.969 -0.222 0.013 0.222 0.975 "
      "0.500 0.250 1.000 0.250 0.500 0.750 0.750 0.500 0.250 1.070 1.098 1.126 2.000 0.952 0.396 0.000 ; ");
  roll.known("differences of pictures are counted", differences,
             "0 0 0 034596b40327; 88 0 1 96d5cedb0406; 88 0 8 7cbd320af720; 88 88 9 4a24d4c225b5; 88 88 60 "
             "291330365eef; ");
  roll.known("a picture is read as it was written", kept_picture, "alike, Title µ, Comment b");
}

}  // namespace tumble::golden
