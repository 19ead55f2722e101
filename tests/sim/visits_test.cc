// Which contacts a visit of the sweeps solves (src/kernels/contacts/contact_visits_impl.h): through the kernels of
// every width.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "src/kernels/kernels_by_width.h"
#include "src/math/grid_magic.h"
#include "src/world/scratch.h"

namespace tumble::sim {
namespace {

constexpr std::uint32_t kBodies = kLanes, kGroundRow = kBodies;

// Eight boxes of 1 kg that fall onto the ground at 1 m/s, one point each, in one batch.
class FallingBoxes {
 public:
  explicit FallingBoxes(LaneWidth width) : kernels_(kernels(width).contacts) {
    bodies_.assign((kBodies + 1) * kSolverBodyDoubles, 0.0);
    moved_.assign(kBodies + 1, 0);
    batch_.used = kLanes;
    batch_.count = 1;
    for (std::uint32_t i = 0; i < kBodies; ++i) add_box(i);
    kernels_.prepare(work());
  }

  bool solve(Sweep sweep = Sweep::kHold) {
    ++now_;
    due_ = kernels_.solve(work(), sweep);
    return due_ != Due::kNone;
  }
  [[nodiscard]] Due due() const { return due_; }
  void apply(std::uint32_t only_body) {
    const BodyOutcomes of = {only_body, only_body, only_body + 1};
    kernels_.apply_outcomes(work(), &of, 1, due_);
  }
  void leave_old() { leaves_old_ = true; }
  void begin() { first_ = ++now_; }
  void begin_sweep(std::uint32_t number) { sweep_ = number; }
  void set_sweeps(unsigned lane, std::uint8_t sweeps) { sides_.sweeps[lane] = sweeps; }
  void note_moved(std::uint32_t body) { moved_[body] = now_; }

  double& speed(std::uint32_t body) { return bodies_[body * kSolverBodyDoubles + 2]; }
  [[nodiscard]] double impulse(unsigned lane) const { return point_.impulse.of[lane]; }
  void set_impulse(unsigned lane, double impulse) { point_.impulse.of[lane] = impulse; }
  [[nodiscard]] bool moves(std::uint32_t body) const { return moved_[body] == now_; }
  [[nodiscard]] double outcome(std::uint32_t body) const { return outcomes_[2 * body + 1].of[2]; }
  void spoil_outcomes() {
    for (Outcome& row : outcomes_) row.of[2] = 7;
  }
  double find_overlaps() { return kernels_.find_overlaps(work()); }
  double& separation(unsigned lane) { return point_.separation.of[lane]; }

 private:
  void add_box(std::uint32_t i) {
    double* body = bodies_.data() + i * kSolverBodyDoubles;
    body[2] = -1;
    body[6] = 1;
    for (const int diagonal : {7, 10, 12}) body[diagonal] = 6;
    sides_.a[i] = kGroundRow;
    sides_.b[i] = i;
    batch_.point_count.of[i] = 1;
    batch_.n[2].of[i] = batch_.t1[0].of[i] = batch_.t2[1].of[i] = 1;
    batch_.offset.of[i] = -0.5;
    batch_.split_a.of[i] = batch_.split_b.of[i] = 1;
    batch_.impulse_magic.of[i] = kMotionMagic;
    batch_.impulse_max.of[i] = 4096;
    batch_.slop.of[i] = kSlop;
    entries_.push_back(2 * i + 1);
  }
  ContactWork work() {
    return {&batch_,
            &sides_,
            1,
            &point_,
            nullptr,
            bodies_.data(),
            outcomes_[0].of,
            entries_.data(),
            1.0 / 100,
            1.0 / 3,
            {moved_.data(), now_, first_, sweep_, false, kStill},
            leaves_old_};
  }

  static constexpr double kStill = 1e-3;  // m/s
  const ContactKernels& kernels_;
  ContactBatch batch_;
  BatchSides sides_;
  PointBatch point_;
  std::vector<double> bodies_;
  std::vector<Outcome> outcomes_ = std::vector<Outcome>(2 * kLanes);
  std::vector<std::uint32_t> entries_, moved_;
  std::uint32_t now_ = 0, first_ = 0, sweep_ = 0;
  bool leaves_old_ = false;
  Due due_ = Due::kNone;
};

class Visits : public testing::TestWithParam<LaneWidth> {
 protected:
  void SetUp() override {
    if (!runs_lanes(GetParam())) GTEST_SKIP() << "this machine has no " << name_of(GetParam()) << " lanes";
  }
};

TEST_P(Visits, AContactWhoseBodiesRestSinceIsNotSolvedAgain) {
  FallingBoxes boxes(GetParam());
  boxes.begin();
  EXPECT_TRUE(boxes.solve());
  EXPECT_GT(boxes.impulse(0), 0.5);
  boxes.set_impulse(0, 0.25);  // would be corrected
  EXPECT_FALSE(boxes.solve());
  EXPECT_EQ(boxes.impulse(0), 0.25);
}

TEST_P(Visits, NewSweepsSolveAllContacts) {
  FallingBoxes boxes(GetParam());
  boxes.begin();
  EXPECT_TRUE(boxes.solve());
  boxes.begin();
  boxes.set_impulse(0, 0.25);
  EXPECT_TRUE(boxes.solve());
  EXPECT_NE(boxes.impulse(0), 0.25);
}

// An island has had its sweeps while others go on.
TEST_P(Visits, AContactWhoseSweepsAreOverIsNotSolved) {
  FallingBoxes boxes(GetParam());
  boxes.set_sweeps(2, 3);
  boxes.set_sweeps(7, 4);
  boxes.begin();
  boxes.begin_sweep(3);
  EXPECT_TRUE(boxes.solve());
  for (unsigned lane = 0; lane < kLanes; ++lane) EXPECT_EQ(boxes.impulse(lane) != 0, lane == 7) << "lane " << lane;
  boxes.begin_sweep(4);
  boxes.set_impulse(7, 0.25);
  boxes.note_moved(7);
  EXPECT_FALSE(boxes.solve());
  EXPECT_EQ(boxes.impulse(7), 0.25);
}

TEST_P(Visits, OnlyTheContactsOfBodiesThatMovedAreSolved) {
  FallingBoxes boxes(GetParam());
  boxes.begin();
  ASSERT_TRUE(boxes.solve());
  for (unsigned lane = 0; lane < kLanes; ++lane) boxes.set_impulse(lane, 0.25);
  boxes.note_moved(3);
  boxes.note_moved(6);
  boxes.spoil_outcomes();
  ASSERT_TRUE(boxes.solve());
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    const bool moved = lane == 3 || lane == 6;
    EXPECT_EQ(boxes.impulse(lane) != 0.25, moved) << "lane " << lane;
    EXPECT_EQ(boxes.outcome(lane) != 0, moved) << "lane " << lane;
    EXPECT_NE(boxes.outcome(lane), 7) << "the outcome of another layer, lane " << lane;
  }
}

// A stack sweeps hundreds of layers in which few contacts are due: the others cost nothing but the question.
TEST_P(Visits, OldOutcomesMayStayAndAreNotApplied) {
  FallingBoxes boxes(GetParam());
  boxes.begin();
  ASSERT_TRUE(boxes.solve());
  EXPECT_EQ(boxes.due(), Due::kAll);
  boxes.leave_old();
  for (unsigned lane = 0; lane < kLanes; ++lane) boxes.set_impulse(lane, 0.25);
  boxes.note_moved(3);
  boxes.note_moved(6);
  boxes.spoil_outcomes();
  ASSERT_TRUE(boxes.solve());
  EXPECT_EQ(boxes.due(), Due::kSome);
  for (std::uint32_t i = 0; i < kBodies; ++i) {
    const double before = boxes.speed(i);
    boxes.apply(i);
    EXPECT_EQ(boxes.speed(i) != before, i == 3 || i == 6) << "body " << i;
    EXPECT_LT(boxes.speed(i), 6) << "an old outcome, body " << i;
  }
  EXPECT_FALSE(boxes.moves(0));
}

TEST_P(Visits, AContactThatMovesItsBodyIsSolvedAgain) {
  FallingBoxes boxes(GetParam());
  boxes.begin();
  ASSERT_TRUE(boxes.solve());
  boxes.apply(5);
  EXPECT_TRUE(boxes.moves(5));
  EXPECT_FALSE(boxes.moves(4));
  EXPECT_TRUE(boxes.solve());
}

TEST_P(Visits, ChangesBelowTheLimitAreAppliedButCallForNoVisit) {
  FallingBoxes boxes(GetParam());
  for (std::uint32_t i = 0; i < kBodies; ++i) boxes.speed(i) = -0.0005;
  boxes.begin();
  ASSERT_TRUE(boxes.solve());
  for (std::uint32_t i = 0; i < kBodies; ++i) boxes.apply(i);
  EXPECT_LT(std::abs(boxes.speed(2)), 0.0005);
  EXPECT_FALSE(boxes.moves(2));
  EXPECT_FALSE(boxes.solve());
}

TEST_P(Visits, OnlyOverlapsArePartedAtFirst) {
  FallingBoxes boxes(GetParam());
  boxes.separation(1) = -kSlop - 0.0001;
  boxes.separation(7) = -kSlop;
  boxes.begin();
  EXPECT_NEAR(boxes.find_overlaps(), 0.0001, 1e-12);
  for (unsigned lane = 0; lane < kLanes; ++lane) boxes.set_impulse(lane, 0.25);
  ASSERT_TRUE(boxes.solve(Sweep::kPart));
  for (unsigned lane = 0; lane < kLanes; ++lane) EXPECT_EQ(boxes.impulse(lane) != 0.25, lane == 1) << "lane " << lane;
}

INSTANTIATE_TEST_SUITE_P(Widths, Visits,
                         testing::Values(LaneWidth::kOne, LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight),
                         [](const auto& width) { return "Lanes" + std::string(name_of(width.param)); });

}  // namespace
}  // namespace tumble::sim
