#include "src/thesis/merge_displacements.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "src/base/check.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// Weights of |d|² for each displacement. The first is small enough to change nothing but the choice among minimisers;
// the second keeps d short where displacements oppose one another.
constexpr double kShortest = 0x1p-30;
constexpr double kShared = 0x1p-4;
// A merged displacement is at most this many times as long as the longest that was asked for.
constexpr double kReach = 4;
// Parts of the right side, and of a displacement, that are rounding.
constexpr double kSolved = 0x1p-44;
constexpr double kArrived = 0x1p-42;
// A shorter step of Newton's method is at least this part of the last one.
constexpr double kShorter = 0.125;
constexpr int kSweepsMax = 200;  // of one minimum; 40 are enough for any of the sets of merge_displacements_test.cc

// Σ n nᵀ and Σ p n over the displacements that d does not cover yet.
struct Uncovered {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  Vec3 pull = Vec3::Zero();

  // Arranged so that exchanging x and y exchanges two coefficients of the result and keeps their bits.
  [[nodiscard]] Vec3 times(const Vec3& v) const {
    return {(xx * v.x() + xy * v.y()) + xz * v.z(), (xy * v.x() + yy * v.y()) + yz * v.z(),
            (xz * v.x() + yz * v.y()) + zz * v.z()};
  }
  friend bool operator==(const Uncovered&, const Uncovered&) = default;
};

// Solves (M + weight · 1) d = pull by conjugate gradients from 0: three steps, begun anew until the rest is rounding.
// Every step lies in the span of the normals, so without a weight d is the shortest solution; along a direction that no
// normal has, d is 0. Scalar products are all that is needed, and they keep their bits under mirrors and exchanges; a
// formula with determinants would not.
Vec3 solve(const Uncovered& m, double weight) {
  const auto times = [&](const Vec3& v) { return Vec3(m.times(v) + v * weight); };
  Vec3 d = Vec3::Zero(), rest = m.pull;
  double square = dot(rest, rest);
  const double solved = square * (kSolved * kSolved);
  for (int round = 0; round < 4; ++round) {
    if (round > 0) {
      rest = m.pull - times(d);
      square = dot(rest, rest);
    }
    Vec3 direction = rest;
    for (int k = 0; k < 3; ++k) {
      if (square <= solved) return d;
      const Vec3 image = times(direction);
      const double bend = dot(direction, image);
      if (bend <= 0) return d;
      const double part = square / bend;
      d += direction * part;
      rest -= image * part;
      const double before = square;
      square = dot(rest, rest);
      direction = rest + direction * (square / before);
    }
  }
  return d;
}

// The minimum over one set of displacements.
class Merge {
 public:
  explicit Merge(std::span<const Displacement> wanted) : wanted_(wanted) {
    double longest = 0;
    for (const Displacement& w : wanted) longest = std::max(longest, w.distance);
    // Distances are divided by a power of two, so that the longest lies in [1, 2).
    unit_ = longest > 0x1p-100 ? power_of_two(longest) : 1;
    per_unit_ = 1 / unit_;
    longest_ = longest * per_unit_;
    const double count = static_cast<double>(std::bit_ceil(std::max<std::uint64_t>(wanted.size(), 8)));
    magic_ = 1.5 * count;  // grid.h: sums of so many terms below 2 are exact on a grid of 2⁻⁵² of the count
  }

  MergedDisplacement run() {
    Vec3 d = minimise(kShortest);
    if (dot(d, d) > (kReach * kReach) * (longest_ * longest_)) d = minimise(kShared);
    return {d * unit_, sweeps_};
  }

 private:
  [[nodiscard]] double rounded(double x) const { return (x + magic_) - magic_; }

  Uncovered uncovered_by(const Vec3& d) {
    ++sweeps_;
    Uncovered sum;
    for (const Displacement& w : wanted_) {
      const Vec3& n = w.direction;
      const double p = w.distance * per_unit_;
      if (p - dot(d, n) <= 0) continue;
      sum.xx += rounded(n.x() * n.x());
      sum.yy += rounded(n.y() * n.y());
      sum.zz += rounded(n.z() * n.z());
      sum.xy += rounded(n.x() * n.y());
      sum.xz += rounded(n.x() * n.z());
      sum.yz += rounded(n.y() * n.z());
      sum.pull += Vec3(rounded(n.x() * p), rounded(n.y() * p), rounded(n.z() * p));
    }
    return sum;
  }

  // Half the slope of Σ max(0, pᵢ − d·nᵢ)² + weight |d|² along a direction.
  static double slope(const Uncovered& m, double weight, const Vec3& d, const Vec3& direction) {
    return dot(m.times(d) + d * weight - m.pull, direction);
  }

  // Newton's method. The uncovered displacements decide the next d, and the search ends when they come back.
  Vec3 minimise(double weight_of_each) {
    const double weight = weight_of_each * static_cast<double>(wanted_.size());
    const int sweeps_end = sweeps_ + kSweepsMax;
    Vec3 d = Vec3::Zero();
    Uncovered now = uncovered_by(d);
    while (sweeps_ < sweeps_end) {
      Vec3 to = solve(now, weight);
      const Vec3 step = to - d;
      Uncovered next = uncovered_by(to);
      if (next == now || dot(step, step) <= dot(to, to) * (kArrived * kArrived)) break;
      // Where the new d lies far up the other side of the valley, a part of the step descends more. The slope along the
      // step is piecewise linear, so its own Newton's method finds the part.
      const double steepest = -0.5 * slope(now, weight, d, step);
      double part = 1, up = slope(next, weight, to, step);
      while (up > steepest && sweeps_ < sweeps_end) {
        const double bend = dot(next.times(step) + step * weight, step);
        part = std::max(part - up / bend, part * kShorter);
        to = d + step * part;
        next = uncovered_by(to);
        up = slope(next, weight, to, step);
      }
      d = to;
      now = next;
    }
    return solve(now, weight_of_each == kShortest ? 0 : weight);
  }

  std::span<const Displacement> wanted_;
  double unit_, per_unit_, longest_, magic_;
  int sweeps_ = 0;
};

MergedDisplacement merge_one_way(std::span<const Displacement> wanted) {
  if (wanted.size() == 1) return {wanted[0].direction * wanted[0].distance, 1};
  return Merge(wanted).run();
}

}  // namespace

MergedDisplacement merge_displacements(std::span<Displacement> wanted) {
  SIM_DCHECK(!wanted.empty(), wanted.size());
  if (wanted.size() == 1) return merge_one_way(wanted);
  Vec3 reference = Vec3::Zero();
  bool shared = false;
  for (const Displacement& w : wanted) {
    reference += PositionGrid::round(Vec3(w.direction * w.distance));
    shared = shared || w.shared;
  }
  if (!shared) return merge_one_way(wanted);
  const auto along = [&](const Displacement& w) { return dot(w.direction, reference) >= 0; };
  const auto middle = std::partition(wanted.begin(), wanted.end(), along);
  MergedDisplacement sum{Vec3::Zero(), 1};
  for (const std::span<Displacement> part : {std::span(wanted.begin(), middle), std::span(middle, wanted.end())}) {
    if (part.empty()) continue;
    const MergedDisplacement merged = merge_one_way(part);
    sum.displacement += merged.displacement;
    sum.sweeps += merged.sweeps;
  }
  return sum;
}

}  // namespace tumble::sim
