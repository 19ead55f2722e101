// Thesis III.C.1: the merge of what several contacts ask for, against an exhaustive search and the thesis's own rule.
#include "src/thesis/merge_displacements.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::Displacement;
using sim::Vec3;
using Wanted = std::vector<Displacement>;

Vec3 any_direction(Random& random) {
  while (true) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const Vec3 v(x, y, z);
    if (v.norm() < 1 && v.norm() > 0.1) return v.normalized();
  }
}

enum class Kind { kAny, kCone, kHalfSpace, kLattice, kNearlyParallel };

Vec3 direction_of(Kind kind, const Vec3& middle, Random& random) {
  Vec3 n = any_direction(random);
  const double side = random.next() % 2 == 0 ? 1 : -1;
  switch (kind) {
    case Kind::kAny:
      return n;
    case Kind::kCone:
      return (n * 0.7 + middle).normalized();  // within 45° of the middle
    case Kind::kHalfSpace:
      return n.dot(middle) < 0 ? Vec3(-n) : n;
    case Kind::kLattice:
      return Vec3::Unit(static_cast<Eigen::Index>(random.next() % 3)) * side;
    case Kind::kNearlyParallel:
      break;
  }
  return (n * 1e-3 + middle * side).normalized();
}

Wanted random_set(Kind kind, std::size_t count, Random& random) {
  const Vec3 middle = any_direction(random);
  Wanted wanted;
  for (std::size_t k = 0; k < count; ++k) {
    const double even = 0.125 * static_cast<double>(1 + random.next() % 4);
    const double distance = kind == Kind::kLattice ? even : random.uniform(0.01, 1);
    wanted.push_back({direction_of(kind, middle, random), distance});
  }
  return wanted;
}

double longest(const Wanted& wanted) {
  double most = 0;
  for (const Displacement& w : wanted) most = std::max(most, w.distance);
  return most;
}

double squares_left(const Wanted& wanted, const Vec3& d, double weight = 0) {
  double sum = weight * d.squaredNorm();
  for (const Displacement& w : wanted) sum += std::pow(std::max(0.0, w.distance - d.dot(w.direction)), 2);
  return sum;
}

double overlap_left(const Wanted& wanted, const Vec3& d) {
  double most = 0;
  for (const Displacement& w : wanted) most = std::max(most, w.distance - d.dot(w.direction));
  return most;
}

// The shortest d that takes a subset of the displacements as equations, in the sense of least squares.
Vec3 shortest_for(const Wanted& wanted, std::size_t subset, double weight) {
  Eigen::Matrix3d matrix = weight * Eigen::Matrix3d::Identity();
  Vec3 right = Vec3::Zero(), d = Vec3::Zero();
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if ((subset >> k & 1) == 0) continue;
    matrix += wanted[k].direction * wanted[k].direction.transpose();
    right += wanted[k].direction * wanted[k].distance;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix);
  for (int k = 0; k < 3; ++k) {
    const Vec3 axis = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()[k] > 1e-11) d += axis * (axis.dot(right) / eigen.eigenvalues()[k]);
  }
  return d;
}

// The answer is the solution of some subset: all are tried, and of those that leave the least the shortest is taken.
Vec3 exhaustive(const Wanted& wanted, double weight = 0) {
  std::vector<Vec3> all;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t subset = 0; subset < (std::size_t{1} << wanted.size()); ++subset) {
    all.push_back(shortest_for(wanted, subset, weight));
    least = std::min(least, squares_left(wanted, all.back(), weight));
  }
  Vec3 best(1e300, 0, 0);
  for (const Vec3& d : all) {
    if (squares_left(wanted, d, weight) <= least + 1e-13 && d.norm() < best.norm()) best = d;
  }
  return best;
}

Vec3 merged(Wanted wanted) { return merge_displacements(wanted).displacement; }

// Where the shortest is longer than four times the longest, |d|² has its weight.
TEST(MergeDisplacements, FindsTheShortestOfTheMinimisers) {
  Random random(1);
  for (const Kind kind : {Kind::kAny, Kind::kCone, Kind::kHalfSpace, Kind::kLattice, Kind::kNearlyParallel}) {
    std::size_t exact = 0, held = 0;
    for (int trial = 0; trial < 600; ++trial) {
      const Wanted wanted = random_set(kind, 2 + random.next() % 5, random);
      Vec3 best = exhaustive(wanted);
      const double limit = 4 * longest(wanted);
      if (std::fabs(best.norm() - limit) < 1e-9) continue;
      const bool long_way = best.norm() > limit;
      if (long_way) best = exhaustive(wanted, static_cast<double>(wanted.size()) / 16);
      ++(long_way ? held : exact);
      EXPECT_LT((merged(wanted) - best).norm(), 1e-9) << "kind " << static_cast<int>(kind) << ", trial " << trial;
    }
    EXPECT_GT(exact, 50U);
    EXPECT_EQ(held > 0, kind == Kind::kAny || kind == Kind::kHalfSpace || kind == Kind::kNearlyParallel);
  }
}

// Several thousand sets of up to 40, of every kind, with and without bodies that give way too.
TEST(MergeDisplacements, OrderMirrorsAndExchangeChangeNoBit) {
  Random random(2);
  for (int trial = 0; trial < 4000; ++trial) {
    Wanted wanted = random_set(static_cast<Kind>(random.next() % 5), 2 + random.next() % 39, random);
    for (Displacement& w : wanted) w.shared = trial % 2 == 0 && random.next() % 3 == 0;
    const Vec3 d = merged(wanted);
    shuffle(wanted, random);
    EXPECT_EQ(merged(wanted), d) << "reordered, trial " << trial;
    Wanted mirrored = wanted, exchanged = wanted;
    for (Displacement& w : mirrored) w.direction.x() = -w.direction.x();
    for (Displacement& w : exchanged) std::swap(w.direction.x(), w.direction.y());
    EXPECT_EQ(merged(mirrored), Vec3(-d.x(), d.y(), d.z())) << "mirrored in x, trial " << trial;
    EXPECT_EQ(merged(exchanged), Vec3(d.y(), d.x(), d.z())) << "exchanged, trial " << trial;
    for (Displacement& w : exchanged) w.direction.x() = -w.direction.x();
    EXPECT_EQ(merged(exchanged), Vec3(-d.y(), d.x(), d.z())) << "exchanged and mirrored, trial " << trial;
  }
}

// One sweep reads every displacement once; 1,000 take no more sweeps than 10 twice over. At most 37 came up.
TEST(MergeDisplacements, SweepsHardlyGrowWithTheirNumber) {
  Random random(3);
  for (const std::size_t count : {10U, 100U, 1000U}) {
    for (const Kind kind : {Kind::kAny, Kind::kCone, Kind::kHalfSpace, Kind::kLattice, Kind::kNearlyParallel}) {
      for (int trial = 0; trial < 40; ++trial) {
        Wanted wanted = random_set(kind, count, random);
        EXPECT_LE(merge_displacements(wanted).sweeps, 45) << count << " of kind " << static_cast<int>(kind);
      }
    }
  }
}

// The thesis's words: the first is the reference; of one in its direction the part across is added and the longer of
// the two parts along is kept; one in the opposite direction is added.
Vec3 by_the_thesis(const Wanted& wanted) {
  Vec3 reference = wanted[0].direction * wanted[0].distance;
  for (std::size_t k = 1; k < wanted.size(); ++k) {
    const Vec3 next = wanted[k].direction * wanted[k].distance, along = reference.normalized();
    const double part = next.dot(along);
    if (part < 0) {
      reference += next;
    } else {
      reference = along * std::max(part, reference.norm()) + (next - along * part);
    }
  }
  return reference;
}

// Where directions are equal or square to one another, the two rules agree. Within 45° of one direction the merge ends
// every overlap with the shortest displacement; the thesis's rule is longer, or leaves a part, or both by its order.
TEST(MergeDisplacements, AgreesWithTheThesisWhereDirectionsAreSquare) {
  Random random(4);
  for (int trial = 0; trial < 500; ++trial) {
    Wanted wanted;
    for (int k = 0; k < 6; ++k) {
      const auto axis = static_cast<Eigen::Index>(random.next() % 3);
      wanted.push_back({Vec3::Unit(axis), random.uniform(0.01, 1)});
    }
    Wanted deepest;  // "the first" changes its direction as parts across are added; one for each axis does not
    for (int axis = 0; axis < 3; ++axis) {
      Displacement most{Vec3::Unit(axis), 0};
      for (const Displacement& w : wanted) {
        if (w.direction == most.direction) most.distance = std::max(most.distance, w.distance);
      }
      if (most.distance > 0) deepest.push_back(most);
    }
    EXPECT_LT((merged(wanted) - by_the_thesis(deepest)).norm(), 1e-9);
  }
}

TEST(MergeDisplacements, LeavesLessThanTheThesisAndGoesLessFar) {
  Random random(5);
  int thesis_leaves = 0, trials = 2000;
  double thesis_length = 0, length = 0, worst = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Wanted wanted = random_set(Kind::kCone, 2 + random.next() % 5, random);
    const Vec3 ours = merged(wanted), theirs = by_the_thesis(wanted);
    worst = std::max(worst, overlap_left(wanted, ours));
    if (overlap_left(wanted, theirs) > 0.01 * longest(wanted)) ++thesis_leaves;
    thesis_length += theirs.norm();
    length += ours.norm();
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(thesis_leaves, 0);
  EXPECT_GT(thesis_length, 1.05 * length);
  RecordProperty("thesis_leaves_percent", std::to_string(100.0 * thesis_leaves / trials));
  RecordProperty("thesis_longer_percent", std::to_string(100 * (thesis_length / length - 1)));
}

// What opposes: both rules leave overlap, the merge never more in the sum of squares.
TEST(MergeDisplacements, LeavesNoMoreThanTheThesisWhereContactsOppose) {
  Random random(6);
  int fewer = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Wanted wanted = random_set(Kind::kAny, 2 + random.next() % 7, random);
    const Vec3 ours = merged(wanted), theirs = by_the_thesis(wanted);
    const double weight = static_cast<double>(wanted.size()) / 16;
    EXPECT_LE(squares_left(wanted, ours), squares_left(wanted, theirs, weight) + 1e-12);
    if (squares_left(wanted, ours) < squares_left(wanted, theirs)) ++fewer;
  }
  EXPECT_GT(fewer, 1500);
}

}  // namespace
}  // namespace tumble::test
