#include "src/thesis/ground/ground_points.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "src/kernels/kernels_by_width.h"

namespace tumble::sim {
namespace {

// Adds the corners of contact k that lie in the ground to the patch.
void add_ground_patch(const GroundPoints& points, std::size_t k, std::vector<Vec3>& patch) {
  for (auto left = static_cast<unsigned>(points.behind[k]); left != 0; left &= left - 1) {
    const auto& corner = points.corner[std::countr_zero(left)];
    patch.emplace_back(corner[0][k], corner[1][k], corner[2][k]);
  }
}

}  // namespace

std::size_t ground_begin(const Contacts& contacts) {
  return static_cast<std::size_t>(std::find(contacts.b.begin(), contacts.b.end(), kGround) - contacts.b.begin());
}

std::size_t find_ground_points(Scratch& scratch, std::size_t begin, std::size_t kept) {
  Contacts& contacts = scratch.contacts;
  const GroundKernels& kernel = kernels(scratch.lanes).ground;
  GroundPoints points;
  points.frames = reinterpret_cast<const double*>(scratch.frames.data());
  const std::size_t end = contacts.a.size();
  for (; begin < end; begin += points.count) {
    points.body = contacts.a.data() + begin;
    points.count = std::min(end - begin, GroundPoints::kMost);
    kernel.find_points(points);
    for (std::size_t k = 0; k < points.count; ++k) {
      if (points.behind[k] == 0) continue;
      add_ground_patch(points, k, contacts.patch);
      contacts.a[kept] = points.body[k];
      contacts.b[kept] = kGround;
      contacts.planes[kept] = 0;
      contacts.normal.set(kept, Vec3(0, 0, -1));
      contacts.depth[kept] = points.depth[k];
      contacts.r_a.set(kept, Vec3(points.point[0][k], points.point[1][k], points.point[2][k]));
      contacts.r_b.set(kept, Vec3::Zero());
      contacts.patch_end[kept] = static_cast<std::uint32_t>(contacts.patch.size());
      ++kept;
    }
  }
  return kept;
}

}  // namespace tumble::sim
