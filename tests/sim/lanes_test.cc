#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "src/kernels/kernels_by_width.h"
#include "src/math/grid_magic.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"

namespace tumble::sim {
namespace {

constexpr std::array<LaneWidth, 4> kWidths = {LaneWidth::kOne, LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight};

std::vector<LaneWidth> widths_here() {
  std::vector<LaneWidth> widths;
  for (const LaneWidth width : kWidths) {
    if (runs_lanes(width)) widths.push_back(width);
  }
  return widths;
}

// Bodies and manifolds with nothing in common but that every sum stays within its grid; of the outcomes, the first
// body takes the first two, and so on.
struct RandomContacts {
  LargeVector<ContactBatch> batches;
  std::vector<BatchSides> sides;
  LargeVector<PointBatch> points;
  std::vector<ImpactBatch> impacts;
  std::vector<Outcome> outcomes;
  std::vector<std::uint32_t> entries;
  std::vector<BodyOutcomes> touched;
  std::vector<double> bodies;
  std::vector<std::uint32_t> moved;  // by body: the last visit that moved it
  std::uint32_t now = 0, first = 0;

  explicit RandomContacts(std::uint64_t seed) : random_(seed) {
    constexpr std::size_t kBodies = 40;
    bodies.assign((kBodies + 1) * kSolverBodyDoubles, 0.0);
    moved.assign(kBodies + 1, 0);
    for (std::size_t i = 0; i < kBodies; ++i) fill_body(bodies.data() + i * kSolverBodyDoubles);
    for (std::uint32_t used = 1; used <= kLanes; ++used) add_batch(used, kBodies);
    outcomes.resize(batches.size() * kLanes * 2);
    for (std::uint32_t i = 0; i < kBodies; ++i) {
      touched.push_back({i, 2 * i, 2 * i + 2});
      entries.insert(entries.end(), {2 * kLanes * (i % kLanes) + i / kLanes, 2 * kLanes * (i % kLanes)});
    }
  }

  // The next visit; the sweeps begin anew with `begins`. Changes of less than a twentieth move nothing.
  ContactWork next_visit(bool begins) {
    if (begins) first = ++now;
    return {batches.data(),
            sides.data(),
            batches.size(),
            points.data(),
            impacts.data(),
            bodies.data(),
            outcomes.data()->of,
            entries.data(),
            0.01,
            kPushPart,
            {moved.data(), ++now, first, 0, false, 0.05}};
  }

 private:
  double number(double low, double high) { return random_.uniform(low, high); }

  void fill_body(double* body) {
    for (int k = 0; k < 6; ++k) body[k] = number(-2, 2);
    body[6] = number(0.1, 2);
    for (const int diagonal : {7, 10, 12}) body[diagonal] = number(1, 8);
    for (const int other : {8, 9, 11}) body[other] = number(-0.3, 0.3);
    for (const int lent : {13, 14, 15}) body[lent] = number(-0.15, 0.15);
  }

  void add_batch(std::uint32_t used, std::size_t ground) {
    ContactBatch& batch = batches.emplace_back(ContactBatch{});
    BatchSides& of = sides.emplace_back();
    std::fill_n(of.a, kLanes, static_cast<std::uint32_t>(ground));
    std::fill_n(of.b, kLanes, static_cast<std::uint32_t>(ground));
    std::fill_n(of.visited + used, kLanes - used, kNeverDue);
    batch.used = used;
    batch.first = static_cast<std::uint32_t>(points.size());
    batch.count = 1 + used % 5;
    batch.met = static_cast<std::uint8_t>((1U << used) - 1U);
    batch.bounces = static_cast<std::uint8_t>(batch.met & 0xdaU);  // the others are stopped, or hold
    batch.fast = used % 2 == 0;
    batch.impact = static_cast<std::uint32_t>(impacts.size());
    impacts.emplace_back().batch = static_cast<std::uint32_t>(batches.size() - 1);
    points.resize(points.size() + batch.count, PointBatch{});
    for (unsigned lane = 0; lane < used; ++lane) fill_lane(batch, lane, static_cast<std::uint32_t>(ground));
  }

  void fill_lane(ContactBatch& batch, unsigned lane, std::uint32_t ground) {
    sides.back().a[lane] = lane % 3 == 0 ? ground : static_cast<std::uint32_t>(number(0, ground - 1));
    sides.back().b[lane] = static_cast<std::uint32_t>(number(0, ground - 1));
    const unsigned count = lane % 2 == 0 ? batch.count : 1;
    batch.point_count.of[lane] = count;
    for (int k = 0; k < 3; ++k) {
      batch.n[k].of[lane] = k == 2 ? 1 : 0;
      batch.t1[k].of[lane] = k == 0 ? 1 : 0;
      batch.t2[k].of[lane] = k == 1 ? 1 : 0;
      batch.d[k].of[lane] = number(-1, 1);
    }
    batch.offset.of[lane] = number(-1, 0);
    batch.friction.of[lane] = batch.friction_dynamic.of[lane] = number(0, 1);
    batch.restitution.of[lane] = number(0, 1);
    batch.split_a.of[lane] = batch.split_b.of[lane] = 1 + lane % 3;
    batch.acceleration.of[lane] = -9.81;
    batch.impulse_magic.of[lane] = kMotionMagic;
    for (Lanes* lanes : {&batch.force1, &batch.force2, &batch.twist}) lanes->of[lane] = number(-1, 1);
    for (unsigned k = 0; k < count; ++k) {
      PointBatch& point = points[batch.first + k];
      point.p.of[lane] = number(-0.5, 0.5);
      point.q.of[lane] = number(-0.5, 0.5);
      point.separation.of[lane] = number(-0.01, 0.01);
      point.impulse.of[lane] = number(0, 1);
      point.load.of[lane] = number(0, 1);
    }
  }

  test::Random random_;
};

template <class T>
bool same_bits(const std::vector<T>& x, const std::vector<T>& y) {
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0;
}

void run_kernels(RandomContacts& contacts, LaneWidth width) {
  const ContactKernels& contact = kernels(width).contacts;
  const ContactWork work = contacts.next_visit(true);
  const auto apply = [&](const ContactWork& visit, Due due) {
    contact.apply_outcomes(visit, contacts.touched.data(), contacts.touched.size(), due);
  };
  contact.prepare(work);
  contact.begin_impacts(work, 0, contacts.impacts.size(), false);
  contact.warm_start(work);
  apply(work, Due::kAll);
  for (const Sweep sweep : {Sweep::kPush, Sweep::kHold, Sweep::kPart, Sweep::kStop, Sweep::kRestitution}) {
    if (sweep == Sweep::kRestitution) contact.begin_impacts(work, 0, contacts.impacts.size(), true);
    for (int k = 0; k < 4; ++k) {
      const ContactWork visit = contacts.next_visit(k == 0);
      const Due due = contact.solve(visit, sweep);
      if (due == Due::kNone) break;
      apply(visit, due);
    }
    if (sweep == Sweep::kPush) contact.end_impacts(work, 0, contacts.impacts.size());
    if (sweep == Sweep::kHold) contact.end_whole_impacts(work, 0, contacts.impacts.size());
  }
  contact.move_on(contacts.next_visit(true));
}

TEST(Lanes, KernelsOfEveryWidthGiveTheBitsOfOneLane) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomContacts one(seed);
    run_kernels(one, LaneWidth::kOne);
    for (const double number : one.bodies) ASSERT_TRUE(std::isfinite(number)) << "seed " << seed;
    for (const LaneWidth width : widths_here()) {
      RandomContacts other(seed);
      run_kernels(other, width);
      ASSERT_TRUE(same_bits(one.bodies, other.bodies)) << name_of(width) << " lanes, seed " << seed;
      for (std::size_t k = 0; k < one.points.size(); ++k) {
        for (int lane = 0; lane < kLanes; ++lane) {
          ASSERT_EQ(one.points[k].impulse.of[lane], other.points[k].impulse.of[lane]) << name_of(width);
          ASSERT_EQ(one.points[k].separation.of[lane], other.points[k].separation.of[lane]) << name_of(width);
        }
      }
    }
  }
}

std::vector<std::uint64_t> hashes_of(const SceneDef& scene, LaneWidth width, int steps) {
  Result<World> world = create_world(scene);
  EXPECT_TRUE(world.ok());
  world->mutable_scratch().lanes = width;
  return test::phase_words_of(*world, steps);
}

TEST(Lanes, SessionsOfEveryWidthHaveTheSamePhaseHashes) {
  SceneDef heap = test::pile(4);
  test::jitter(heap, 0.01, 7);
  for (SceneDef layered : {heap, test::tumble_of_boxes(5, 3), test::wall(4, 5)}) {
    layered.world.method = Method::kLayered;
    const std::vector<std::uint64_t> one = hashes_of(layered, LaneWidth::kOne, 90);
    for (const LaneWidth width : widths_here()) EXPECT_EQ(one, hashes_of(layered, width, 90)) << name_of(width);
    EXPECT_EQ(one, hashes_of(layered, LaneWidth::kWidest, 90));
  }
}

// 27 boxes that meet the ground, and nothing else, in all ways that a collision with the ground tells apart: flat and
// aslant, fast and at rest, sliding, spinning about the vertical, without friction, fully elastic.
SceneDef landings() {
  SceneDef scene = test::on_ground();
  test::Random random(11);
  for (std::uint32_t k = 0; k < 27; ++k) {
    BoxDef box = test::box(k + 1, {0.7, 0.5, 0.4}, {3.0 * k, 0.25 * k, 0.2 + 0.05 * (k % 4)});
    if (k % 4 == 3) box.orientation = random.rotation();
    if (k % 3 != 0) box.velocity = Vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 0));
    if (k % 5 != 0) box.spin = Vec3(0, 0, random.uniform(-3, 3));
    if (k % 7 == 0) box.material.friction = box.material.friction_dynamic = 0;
    if (k % 7 == 2) box.material.friction_dynamic = 0.1;
    if (k % 8 == 5) box.material.restitution = 1;
    scene.boxes.push_back(box);
  }
  return scene;
}

TEST(Lanes, SessionsOfMethodThesisLikewise) {
  SceneDef drag = test::tilted_grid(5);  // 25 bodies: three eights and one
  drag.world.air_drag = 0.3;
  SceneDef heap = test::pile(3);
  test::jitter(heap, 0.01, 7);
  for (SceneDef thesis : {drag, heap, landings(), test::tumble_of_boxes(3, 3), test::plates_and_bars(4, 3)}) {
    thesis.world.method = Method::kThesis;
    thesis.world.substeps = 4;
    const std::vector<std::uint64_t> one = hashes_of(thesis, LaneWidth::kOne, 60);
    for (const LaneWidth width : widths_here()) EXPECT_EQ(one, hashes_of(thesis, width, 60)) << name_of(width);
    EXPECT_EQ(one, hashes_of(thesis, LaneWidth::kWidest, 60));
  }
}

}  // namespace
}  // namespace tumble::sim
