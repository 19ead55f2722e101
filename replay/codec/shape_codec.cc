#include "replay/codec/shape_codec.h"

#include <string>
#include <utility>

#include "replay/codec/blob.h"
#include "replay/format/limits.h"

namespace tumble::replay {
namespace {

std::string text_of(capnp::Text::Reader text) { return {text.cStr(), text.size()}; }

std::vector<double> flat(const std::vector<sim::Vec3>& points) {
  std::vector<double> numbers;
  for (const sim::Vec3& point : points) numbers.insert(numbers.end(), {point.x(), point.y(), point.z()});
  return numbers;
}

Status decode_points(capnp::Data::Reader in, std::vector<sim::Vec3>& points) {
  if (in.size() % 24 != 0 || in.size() / 24 > kShapePointsMax) {
    return damaged("shape: found " + std::to_string(in.size()) + " bytes of points");
  }
  std::vector<std::uint64_t> bits;
  if (Status ok = get_planes("shape: points", in, in.size() / 8, bits); !ok.ok()) return ok;
  for (std::size_t i = 0; i + 2 < bits.size(); i += 3) {
    points.emplace_back(double_of(bits[i]), double_of(bits[i + 1]), double_of(bits[i + 2]));
  }
  return {};
}

}  // namespace

void encode(const Shape& shape, schema::Shape::Builder out) {
  const Hash128 hash = hash_of(shape);
  out.setHashLow(hash.low);
  out.setHashHigh(hash.high);
  out.setKind(static_cast<std::uint8_t>(shape.kind));
  out.setAxis(shape.axis);
  out.setRadius(shape.radius);
  out.setHalfLength(shape.half_length);
  const std::vector<std::uint64_t> bits = bits_of(std::span<const double>(flat(shape.points)));
  put_planes(std::span<const std::uint64_t>(bits), out.initPoints(static_cast<unsigned>(bits.size() * 8)));
  put_planes(std::span<const std::uint32_t>(shape.triangles),
             out.initTriangles(static_cast<unsigned>(shape.triangles.size() * 4)));
}

Result<Shape> decode(schema::Shape::Reader in) {
  Shape shape;
  shape.kind = static_cast<Shape::Kind>(in.getKind());
  shape.axis = in.getAxis();
  shape.radius = in.getRadius();
  shape.half_length = in.getHalfLength();
  if (Status ok = decode_points(in.getPoints(), shape.points); !ok.ok()) return ok.error();
  const capnp::Data::Reader triangles = in.getTriangles();
  if (triangles.size() / 12 > kShapeTrianglesMax) return damaged("shape: found too many triangles");
  if (Status ok = get_planes("shape: triangles", triangles, triangles.size() / 4, shape.triangles); !ok.ok()) {
    return ok.error();
  }
  if (Status ok = check_shape(shape); !ok.ok()) return damaged(ok.error().message);
  const Hash128 found = hash_of(shape), wanted = {in.getHashHigh(), in.getHashLow()};
  if (found == wanted) return shape;
  return damaged("shape: found hash " + to_string(found) + ", wanted " + to_string(wanted));
}

void encode(const BodyInfo& info, schema::BodyInfo::Builder out) {
  out.setId(info.id);
  out.setName(info.name);
  out.setShapeLow(info.shape.low);
  out.setShapeHigh(info.shape.high);
}

Result<BodyInfo> decode(schema::BodyInfo::Reader in) {
  BodyInfo info = {in.getId(), text_of(in.getName()), {in.getShapeHigh(), in.getShapeLow()}};
  if (Status ok = check_body_info(info); !ok.ok()) return damaged(ok.error().message);
  return info;
}

}  // namespace tumble::replay
