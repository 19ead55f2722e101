// Laws of boxes inside one another: how those that begin so are parted, and how deep others get.
#include <gtest/gtest.h>

#include <string>

#include "tests/golden/hunt_session.h"

namespace tumble::test {
namespace {

using hunt::Judgement;
using hunt::Outcome;
using hunt::Trace;

const char* const kInside = R"(
[world]
steps = 30
ground = false
[[box]]
position = [0.0, 0.0, 5.0]
mass = 1.0
[[box]]
position = [0.7, 0.1, 5.2]
mass = 5.0
)";

TEST(HuntParting, HoldsOnSessionsOfThisBuild) {
  const Trace trace = traced(kInside);
  for (const hunt::Relation& one : hunt::relations()) {
    EXPECT_NE(one.judge(trace).outcome, Outcome::kBroken) << one.name << ": " << one.judge(trace).what;
  }
  EXPECT_EQ(judge("parting", trace).outcome, Outcome::kHeld);
  EXPECT_EQ(judge("overlap", trace).outcome, Outcome::kNotApplicable);
}

// The session that the law asks for is tampered with: boxes that part with a speed, push one another's centre away, or
// stay as they are.
TEST(HuntParting, SeesBoxesThatArePartedWrongly) {
  const auto parted = [](const char* method, const auto& change) {
    std::string text = kInside;
    text.insert(text.find("steps"), "method = \"" + std::string(method) + "\"\n");
    Trace trace = traced(text.c_str());
    trace.again = [&change](const sim::SceneDef& scene) {
      Result<Trace> other = hunt::trace(scene);
      for (std::size_t k = 12; k < other->states.size(); ++k) change(other->states[k].bodies, other->states[11].bodies);
      return other;
    };
    return judge("parting", trace);
  };
  using sim::Bodies;
  for (const char* method : {"layered", "thesis"}) {
    EXPECT_EQ(parted(method, [](Bodies&, const Bodies&) {}).outcome, Outcome::kHeld) << method;
    const Judgement speed = parted(method, [](Bodies& b, const Bodies&) { b.velocity.x[1] = 1e-4; });
    EXPECT_EQ(speed.step, 12U) << speed.what;
    EXPECT_EQ(speed.unit, "m/s");
    EXPECT_EQ(parted(method, [](Bodies& b, const Bodies&) { b.spin.z[0] = 1e-4; }).outcome, Outcome::kBroken);
  }
  const Judgement centre = parted("layered", [](Bodies& b, const Bodies&) { b.position.y[0] += 1e-6; });
  EXPECT_EQ(centre.outcome, Outcome::kBroken);
  EXPECT_EQ(centre.what, "the common centre of boxes that part moved");
  const Judgement stays = parted("layered", [](Bodies& b, const Bodies& before) { b = before; });
  EXPECT_EQ(stays.outcome, Outcome::kBroken);
  EXPECT_EQ(stays.what, "boxes are not parted");
  EXPECT_EQ(stays.step, 12U);
}

// A pin 2,600 times as heavy as the board on the ground that it stands on: the law claims nothing of either, although
// the ground lies between them and all else.
// (Scene 1111 of seed 1.)
TEST(HuntOverlap, ClaimsNothingOfWhatTouchesFarHeavierThings) {
  const Trace trace = traced(R"(
[world]
steps = 4
substeps = 4
[material]
friction = 0.35844795843057053
friction_dynamic = 0.217346077273554
restitution = 0
[[box]]
id = 1
size = [0.8482514087417262, 0.6557037204757787, 7.636624552418465]
mass = 0.013898460331900321
position = [0.0, 0.0, 3.8283122762092323]
[[box]]
id = 10
size = [0.013332966570489333, 0.0025405790106168944, 0.018213090897291406]
mass = 36.70555306616483
position = [0.0, 0.0, 7.703834368261987]
velocity = [-4.640557894297965, -4.102879458424005, -10.866355600535341]
)");
  const Judgement found = judge("overlap", trace);
  EXPECT_EQ(found.outcome, Outcome::kHeld) << found.what << ' ' << found.value << ' ' << found.bound;
}

// A light board between the ground and a pin that comes down: in the step in which the ground stops the board, the pin
// goes on with its own speed, however alike the two moved before.
TEST(HuntOverlap, AllowsForAThirdThingThatStopsOneOfTwo) {
  const Trace trace = traced(R"(
[world]
steps = 3
substeps = 4
freezing = false
[[box]]
size = [7.6, 7.6, 7.6]
mass = 1.0
position = [0.0, 0.0, 3.83]
[[box]]
size = [0.02, 0.02, 0.02]
mass = 40.0
position = [0.0, 0.0, 7.7]
velocity = [0.0, 0.0, -10.0]
)");
  const Judgement found = judge("overlap", trace);
  EXPECT_EQ(found.outcome, Outcome::kHeld) << found.what << ' ' << found.value << ' ' << found.bound;
}

}  // namespace
}  // namespace tumble::test
