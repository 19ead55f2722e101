#include "tests/support/transforms.h"

#include <array>
#include <bit>

namespace tumble::test {

using sim::Quat;
using sim::Vec3;

namespace {

// The bits of everything that is compared of a body.
using BodyBits = std::array<std::uint64_t, 15>;
BodyBits bits_of(const Vec3& x, const Quat& q, const Vec3& v, const Vec3& w, std::uint8_t frozen, double time) {
  const std::array<double, 14> values = {x.x(), x.y(), x.z(), q.w,   q.x,   q.y,   q.z,
                                         v.x(), v.y(), v.z(), w.x(), w.y(), w.z(), time};
  BodyBits bits;
  for (std::size_t k = 0; k < values.size(); ++k) bits[k] = std::bit_cast<std::uint64_t>(values[k]);
  bits[14] = frozen;
  return bits;
}

}  // namespace

const std::vector<Transform>& all_transforms() {
  static const std::vector<Transform> kAll = [] {
    constexpr std::uint64_t kSeed = 0xfeed;
    std::vector<Transform> all(6);
    all[0].mirror_x = true;
    all[1].mirror_y = true;
    all[2].swap_xy = true;
    all[3].shift = {1024, -512.5, 0};
    all[4].permute = kSeed;
    all[5] = {true, true, true, {-37.25, 4096, 0}, kSeed};
    return all;
  }();
  return kAll;
}

sim::SceneDef resolved(const sim::SceneDef& scene) {
  sim::SceneDef result = sim::on_grids(scene);
  for (sim::BoxDef& box : result.boxes) box.orientation = normalised(box.orientation);
  return result;
}

std::size_t differing_bodies(const sim::World& original, const sim::World& image, const Transform& transform,
                             const IdMap& ids) {
  const sim::Bodies& from = original.bodies();
  const sim::Bodies& to = image.bodies();
  std::size_t different = to.size() > from.size() ? to.size() - from.size() : 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto j = to.find(image_of(from.id[i], ids));
    if (!j) {
      ++different;
      continue;
    }
    const BodyBits wanted = bits_of(transform.point(from.position[i]), transform.orientation(from.orientation[i]),
                                    transform.vector(from.velocity[i]), transform.axial_vector(from.spin[i]),
                                    from.frozen[i], from.low_energy_time[i]);
    const BodyBits found = bits_of(to.position[*j], to.orientation[*j], to.velocity[*j], to.spin[*j], to.frozen[*j],
                                   to.low_energy_time[*j]);
    if (wanted != found) ++different;
  }
  return different;
}

}  // namespace tumble::test
