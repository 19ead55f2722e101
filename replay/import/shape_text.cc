#include "replay/import/shape_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr const char* kWords = "box, sphere, capsule-x, cylinder-x (or y, z), hull:FILE.obj or mesh:FILE.obj";

Error no_shape(std::string_view text) { return bad_input("shape: " + found_wanted(in_quotes(text), kWords)); }

/// Our axis that lies along axis k of the table.
std::uint8_t our_axis(int k, const EngineAxes& axes) {
  const sim::Vec3 along = axes.direction({k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0});
  return static_cast<std::uint8_t>(along.x() != 0 ? 0 : (along.y() != 0 ? 1 : 2));
}

Result<std::optional<Shape>> long_shape(std::string_view text, Shape::Kind kind, const sim::Vec3& size,
                                        const EngineAxes& axes) {
  const char letter = text.back();
  if (text.size() < 2 || text[text.size() - 2] != '-' || letter < 'x' || letter > 'z') return no_shape(text);
  Shape shape;
  shape.kind = kind;
  shape.axis = our_axis(letter - 'x', axes);
  shape.radius = std::max(size[(shape.axis + 1) % 3], size[(shape.axis + 2) % 3]) / 2;
  shape.half_length = size[shape.axis] / 2 - (kind == Shape::Kind::kCapsule ? shape.radius : 0);
  if (shape.half_length >= 0) return std::optional<Shape>(shape);
  return bad_input("shape: found a capsule of length " + exact(size[shape.axis]) + " m and width " +
                   exact(2 * shape.radius) + " m, wanted one at least as long as wide");
}

/// Triangles of a face with any number of corners "v", "v/vt", "v/vt/vn", "v//vn"; negative numbers count from the end.
Status add_face(std::istringstream& words, Shape& shape) {
  std::vector<std::uint32_t> corners;
  for (std::string word; words >> word;) {
    const long long number = std::strtoll(word.c_str(), nullptr, 10);
    const long long count = static_cast<long long>(shape.points.size());
    const long long index = number < 0 ? count + number : number - 1;
    if (number == 0 || index < 0 || index >= count) return bad_input("found a face with corner " + in_quotes(word));
    corners.push_back(static_cast<std::uint32_t>(index));
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    shape.triangles.insert(shape.triangles.end(), {corners[0], corners[i - 1], corners[i]});
  }
  return {};
}

Result<std::optional<Shape>> shape_of_file(std::string_view name, Shape::Kind kind, const EngineAxes& axes,
                                           const std::string& table_path) {
  const std::filesystem::path path = std::filesystem::path(table_path).parent_path() / std::string(name);
  std::ifstream file(path);
  if (!file) return bad_input("shape: " + path.string() + ": cannot be opened");
  Shape shape;
  shape.kind = kind;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::string word;
    words >> word;
    Status ok;
    if (word == "v") {
      double x = 0, y = 0, z = 0;
      if (!(words >> x >> y >> z)) ok = bad_input("found no three numbers behind v");
      shape.points.push_back(axes.length({x, y, z}));
    } else if (word == "f") {
      ok = add_face(words, shape);
    }
    if (!ok.ok())
      return bad_input("shape: " + path.string() + ':' + std::to_string(number) + ": " + ok.error().message);
  }
  if (file.bad()) return cannot_finish("shape: " + path.string() + ": cannot be read to its end");
  if (kind == Shape::Kind::kHull) shape.triangles.clear();
  if (Status ok = check_shape(shape); !ok.ok()) return bad_input(path.string() + ": " + ok.error().message);
  return std::optional<Shape>(std::move(shape));
}

}  // namespace

Result<std::optional<Shape>> parse_shape(std::string_view text, const sim::Vec3& size, const EngineAxes& axes,
                                         const std::string& table_path) {
  if (text == "box" || text.empty()) return std::optional<Shape>();
  if (text == "sphere") {
    Shape shape;
    shape.radius = std::min({size.x(), size.y(), size.z()}) / 2;
    return std::optional<Shape>(shape);
  }
  if (text.starts_with("capsule")) return long_shape(text, Shape::Kind::kCapsule, size, axes);
  if (text.starts_with("cylinder")) return long_shape(text, Shape::Kind::kCylinder, size, axes);
  if (text.starts_with("hull:")) return shape_of_file(text.substr(5), Shape::Kind::kHull, axes, table_path);
  if (text.starts_with("mesh:")) return shape_of_file(text.substr(5), Shape::Kind::kMesh, axes, table_path);
  return no_shape(text);
}

std::vector<ChannelKind> parse_kinds(std::string_view text) {
  constexpr std::array kKinds = {ChannelKind::kFloat64, ChannelKind::kFloat32, ChannelKind::kInt64,
                                 ChannelKind::kUint64, ChannelKind::kText};
  std::vector<ChannelKind> kinds;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    const auto* const kind = std::ranges::find_if(kKinds, [&](ChannelKind k) { return word == name_of(k); });
    if (kind == kKinds.end()) return {};
    kinds.push_back(*kind);
    begin = end + 1;
  }
  return kinds;
}

}  // namespace tumble::replay
