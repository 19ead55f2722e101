// Sessions of two builds whose bits differ: how far their measures may be apart.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "golden/hunt/apart/session_pair.h"
#include "tests/golden/hunt_session.h"

namespace tumble::test {
namespace {

using hunt::ApartBound;
using hunt::Judgement;
using hunt::Outcome;
using hunt::SessionPair;

// A box that falls 0.3 m at 2 m/s and slides.
std::string sliding(const char* friction, const char* x = "0.0") {
  return std::string("[world]\nsteps = 60\n[material]\nfriction = ") + friction + "\n[[box]]\nid = 4\nposition = [" +
         x + ", 0.0, 0.8]\nvelocity = [2.0, 0.0, 0.0]\n";
}

Judgement judge_pair(const std::string& mine, const std::string& other, const ApartBound& bound) {
  const hunt::Trace here = traced(mine.c_str());
  return SessionPair(here, records_of(traced(other.c_str()))).judge(bound);
}

TEST(HuntApart, ASessionBesideItselfIsWithinEveryBound) {
  const std::string text = sliding("0.3");
  for (ApartBound bound : hunt::usual_bounds()) {
    bound.amount = bound.part = 0;
    EXPECT_EQ(judge_pair(text, text, bound).outcome, Outcome::kHeld) << bound.measure;
  }
}

TEST(HuntApart, PlacesAreComparedUpToTheFirstContact) {
  // Another friction shows only once the box lies on the ground.
  EXPECT_EQ(judge_pair(sliding("0.3"), sliding("0.5"), {"place", 1e-9, 0}).outcome, Outcome::kHeld);
  const Judgement moved = judge_pair(sliding("0.3"), sliding("0.3", "0.25"), {"place", 0.1, 0});
  EXPECT_EQ(moved.outcome, Outcome::kBroken);
  EXPECT_EQ(moved.step, 0U);
  EXPECT_EQ(moved.body, 4U);
  EXPECT_NEAR(moved.value, 0.25, 1e-12);
  EXPECT_EQ(moved.bound, 0.1);
}

TEST(HuntApart, NamesTheFirstAndTheFarthestDifference) {
  const Judgement one = judge_pair(sliding("0.3"), sliding("0.5"), {"drift_max", 0.01, 0});
  EXPECT_EQ(one.outcome, Outcome::kBroken);
  EXPECT_GT(one.step, 10U) << "it falls first";
  EXPECT_LT(one.step, 60U);
  EXPECT_EQ(one.body, 4U);
  EXPECT_NE(one.what.find("drift_max is "), std::string::npos) << one.what;
  EXPECT_NE(one.what.find(" m here and "), std::string::npos) << one.what;
  EXPECT_NE(one.what.find(", farthest apart after step "), std::string::npos) << one.what;
  EXPECT_GT(one.value, 0.01);
  EXPECT_EQ(one.bound, 0.01);
  EXPECT_EQ(judge_pair(sliding("0.3"), sliding("0.5"), {"drift_max", 5, 0}).outcome, Outcome::kHeld);
  EXPECT_EQ(judge_pair(sliding("0.3"), sliding("0.5"), {"drift_max", 0, 0.9}).outcome, Outcome::kHeld) << "a part";
}

TEST(HuntApart, AValueBesideNoneIsBeyondEveryBound) {
  // Over ice it never rests.
  const Judgement one = judge_pair(sliding("0.9"), sliding("0.0"), {"rest_time", 100, 0});
  EXPECT_EQ(one.outcome, Outcome::kBroken);
  EXPECT_NE(one.what.find("there"), std::string::npos) << one.what;
  EXPECT_NE(one.what.find("none (never)"), std::string::npos) << one.what;
  EXPECT_EQ(describe(one).find("allowed"), std::string::npos)
      << "no distance is beyond such a bound: " << describe(one);
  EXPECT_EQ(judge_pair(sliding("0.0"), sliding("0.0"), {"rest_time", 100, 0}).outcome, Outcome::kNotApplicable);
}

TEST(HuntApart, AValueThatOneSessionGetsLaterIsComparedAtTheEnd) {
  // Both rest at last, the smoother one later.
  const Judgement one = judge_pair(sliding("0.9"), sliding("0.55"), {"rest_time", 1e-3, 0});
  EXPECT_EQ(one.outcome, Outcome::kBroken);
  EXPECT_EQ(one.what.find("none"), std::string::npos) << one.what;
  EXPECT_GT(one.value, 1e-3);
  EXPECT_LT(one.value, 1);
}

TEST(HuntApart, SaysAsManyDigitsAsDiffer) {
  const Judgement one = judge_pair(sliding("0.3"), sliding("0.30001"), {"drift_max", 0, 0});
  EXPECT_EQ(one.outcome, Outcome::kBroken);
  EXPECT_NE(describe(one).find(": apart by "), std::string::npos) << describe(one);
  EXPECT_NE(describe(one).find(" m, allowed 0"), std::string::npos) << describe(one);
  const std::size_t is = one.what.find(" is ") + 4, here = one.what.find(" here and ");
  const std::string mine = one.what.substr(is, here - is);
  EXPECT_NE(one.what.substr(here + 10, mine.size()), mine) << one.what;
}

TEST(HuntApart, ABodyThatOneSessionLacksHasNoPlace) {
  const hunt::Trace here = traced(sliding("0.3").c_str());
  std::vector<replay::StepRecord> other = records_of(here);
  for (std::size_t k = 0; k < 3; ++k) other[k].states.position.x[0] += 0.25;
  other[3].states.position.x[0] = std::nan("");
  const Judgement one = SessionPair(here, other).judge({"place", 0.1, 0});
  EXPECT_EQ(one.outcome, Outcome::kBroken);
  EXPECT_EQ(one.step, 0U);
  EXPECT_NE(one.what.find("farthest after step 3, body 4, which has no place in one session"), std::string::npos)
      << one.what;
}

TEST(HuntApart, ReadsBounds) {
  const auto read = [](const std::vector<std::string>& words) { return hunt::read_bounds(words); };
  EXPECT_TRUE(read({})->empty());
  EXPECT_TRUE(read({"bits"})->empty());
  EXPECT_EQ(*read({"bounds"}), hunt::usual_bounds());
  EXPECT_EQ(*read({"gain_max=0.1+5%"}), (std::vector<ApartBound>{{"gain_max", 0.1, 0.05}}));
  EXPECT_EQ(*read({"final=5%"}), (std::vector<ApartBound>{{"final", 0, 0.05}}));
  EXPECT_EQ(*read({"place=1e-3"}), (std::vector<ApartBound>{{"place", 1e-3, 0}}));
  const auto changed = read({"bounds", "lost=2", "final=1"});
  ASSERT_TRUE(changed.ok());
  EXPECT_EQ(changed->size(), hunt::usual_bounds().size() + 1);
  for (const ApartBound& bound : *changed) {
    EXPECT_EQ(*read({to_text(bound)}), std::vector<ApartBound>{bound}) << to_text(bound);
    EXPECT_EQ(bound.amount == 2, bound.measure == "lost") << bound.measure;
  }
  for (const char* word : {"final=0.0001%", "final=7%", "final=0.1+0.3%", "final=29%", "final=12.345%"})
    EXPECT_EQ(to_text(read({word})->front()), word);
  for (const char* bad :
       {"gain_max", "gain_max=", "gain_max=-1", "gain_max=1x", "gain_max=1+2", "gain_max=nan", "bound"})
    EXPECT_FALSE(read({bad}).ok()) << bad;
  for (const char* other : {"mirror_error=1", "parting_time.0.1=1", "channel.x.max=1", "gain_mx=1"})
    EXPECT_FALSE(read({other}).ok()) << other;
  EXPECT_FALSE(read({"bits", "bounds"}).ok());
  EXPECT_FALSE(read({"lost=1", "lost=2"}).ok());
}

}  // namespace
}  // namespace tumble::test
