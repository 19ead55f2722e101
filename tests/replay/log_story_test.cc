// The location and the growth of a first difference: few chunks opened, pairs, separations, logs that contradict
// themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/zstd_frame.h"
#include "replay/diff/difference_report.h"
#include "replay/diff/locate_divergence.h"
#include "replay/measure/metric_bound.h"
#include "tests/support/log_memory.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

/// A session in which the upper box falls from a little higher.
sim::SceneDef raised(sim::SceneDef scene, double by) {
  scene.boxes[2].position.z() += by;
  return scene;
}

/// A push before a step, so that two sessions differ from there on.
sim::SceneDef pushed(sim::SceneDef scene, std::uint64_t step) {
  scene.inputs.push_back({step, sim::Push{12, {0, 0.001, 0}, true, {0, 0, 0}}});
  return scene;
}

TEST(Locate, ChunksThatDoNotMatchAreHalvedToo) {
  constexpr std::uint64_t kSteps = 900;
  const sim::SceneDef scene = small_scene(kSteps);
  const Bytes bytes = record_to_memory(scene, {}, 5);
  for (const std::uint64_t step : {1ULL, 317ULL, 600ULL, kSteps - 0ULL}) {
    Result<LogReader> a = open_memory(bytes), b = open_memory(record_to_memory(pushed(scene, step), {}, 7));
    ASSERT_TRUE(a.ok() && b.ok());
    ASSERT_GT(a->chunks().size(), 150U);
    const Result<LocatedDivergence> located = diff_and_locate(*a, *b);
    ASSERT_TRUE(located.ok()) << located.error().message;
    ASSERT_TRUE(located->report.first);
    EXPECT_EQ(located->report.first->step, step);
    EXPECT_EQ(located->report.first->phase, "inputs");
    EXPECT_LE(located->chunks_opened, 24U) << step;
  }
}

TEST(Locate, BothSidesAreTakenAgain) {
  for (const sim::Method method : kMethods) {
    const sim::SceneDef scene = small_scene(30, method);
    Result<LogReader> a = open_memory(record_to_memory(scene)), b = open_memory(record_to_memory(pushed(scene, 20)));
    const Result<LocatedDivergence> located = diff_and_locate(*a, *b);
    ASSERT_TRUE(located.ok());
    EXPECT_TRUE(located->location.as_a && located->location.as_b);
    EXPECT_TRUE(located->location.not_taken.empty());
    EXPECT_EQ(std::ranges::count(located->location.bodies, 12U), 1);
  }
}

TEST(Locate, LogsWithoutStatesNameABodyWhereThisBuildReproducesThem) {
  RecordOptions hashes;
  hashes.states = {0};
  const sim::SceneDef scene = small_scene(30);
  Result<LogReader> a = open_memory(record_to_memory(scene, hashes)),
                    b = open_memory(record_to_memory(pushed(scene, 20), hashes));
  const Result<LocatedDivergence> located = diff_and_locate(*a, *b);
  ASSERT_TRUE(located.ok());
  EXPECT_EQ(std::ranges::count(located->location.bodies, 12U), 1);
}

TEST(StepContacts, AreThoseOfTheStep) {
  for (const sim::Method method : kMethods) {
    Result<LogReader> log = open_memory(record_to_memory(small_scene(40, method)));
    const Result<RetakenStep> step = retake_step(*log, 40);
    ASSERT_TRUE(step.ok()) << step.error().message;
    EXPECT_TRUE(step->same);
    ASSERT_FALSE(step->contacts.empty());
    bool on_ground = false;
    for (const StepContact& contact : step->contacts) {
      on_ground = on_ground || (contact.a == 10 && !contact.b) || contact.b == 10U || contact.a == 10;
      EXPECT_NEAR(sim::length(contact.normal), 1, 1e-9) << describe(contact);
    }
    EXPECT_TRUE(on_ground);
    EXPECT_FALSE(retake_step(*log, 0).ok());
    EXPECT_FALSE(retake_step(*log, 41).ok());
  }
}

StepContact contact(sim::BodyId a, std::optional<sim::BodyId> b) {
  StepContact made;
  made.a = a;
  made.b = b;
  return made;
}

TEST(StepContacts, ThePairIsTheOneThatDiffersOrTheOnlyOne) {
  using Pair = std::pair<sim::BodyId, sim::BodyId>;
  const std::vector<StepContact> contacts = {contact(1, 2), contact(3, 7), contact(5, 7), contact(7, std::nullopt)};
  EXPECT_EQ(pair_of({5, 7}, contacts), Pair(5, 7));
  EXPECT_EQ(pair_of({1}, contacts), Pair(1, 2)) << "the only body it touched";
  EXPECT_EQ(pair_of({7}, contacts), std::nullopt) << "it touched two";
  EXPECT_EQ(pair_of({9}, contacts), std::nullopt);
  EXPECT_EQ(pair_of({}, contacts), std::nullopt);
}

TEST(Growth, NamesTheStepOfEachMark) {
  const sim::SceneDef scene = small_scene(20);
  Result<LogReader> a = open_memory(record_to_memory(scene)),
                    b = open_memory(record_to_memory(raised(scene, std::ldexp(1.0, -26))));
  const Result<DivergenceGrowth> growth = growth_between(*a, *b, 0);
  ASSERT_TRUE(growth.ok()) << growth.error().message;
  ASSERT_EQ(growth->separation.rows.size(), 21U);
  ASSERT_GE(growth->separation.marks.size(), 2U);
  EXPECT_EQ(growth->separation.marks[0].above, 1e-12);
  EXPECT_EQ(growth->separation.marks[1].above, 1e-9);
  EXPECT_EQ(growth->separation.marks[1].step, 0U);
  EXPECT_EQ(growth->separation.marks[1].body, 12U);
  EXPECT_EQ(growth->separation.rows[0].bodies, 1U);
  EXPECT_EQ(growth->separation.rows[0].separation, std::ldexp(1.0, -26));
  EXPECT_FALSE(growth->separation.bodies_from);
  EXPECT_TRUE(growth->not_measured.empty());
  EXPECT_FALSE(growth->metrics.empty());
}

TEST(Growth, OfOneSessionIsNone) {
  Result<LogReader> a = open_memory(record_to_memory(small_scene())), b = open_memory(record_to_memory(small_scene()));
  const Result<DivergenceGrowth> growth = growth_between(*a, *b, 0);
  ASSERT_TRUE(growth.ok());
  EXPECT_EQ(growth->separation.largest.separation, 0);
  EXPECT_TRUE(growth->separation.marks.empty());
  EXPECT_TRUE(growth->metrics.empty());
}

TEST(Growth, NamesABodyOnOneSideOnly) {
  const sim::SceneDef scene = small_scene(12);
  sim::SceneDef removed = scene;
  removed.inputs.push_back({8, sim::Remove{12}});
  Result<LogReader> a = open_memory(record_to_memory(scene)), b = open_memory(record_to_memory(removed));
  const Result<DivergenceGrowth> growth = growth_between(*a, *b, 8);
  ASSERT_TRUE(growth.ok());
  EXPECT_EQ(growth->separation.bodies_from, 8U);
  EXPECT_GE(growth->separation.rows[0].bodies, 1U);
}

TEST(Growth, OfAReplayFollowsThisBuild) {
  const sim::SceneDef scene = small_scene(20);
  const Bytes bytes = record_to_memory(scene);
  Result<LogReader> log = open_memory(bytes), again = open_memory(bytes);
  const Result<DivergenceGrowth> growth = growth_in_replay(*log, *again, 5);
  ASSERT_TRUE(growth.ok()) << growth.error().message;
  EXPECT_EQ(growth->separation.rows.front().step, 5U);
  EXPECT_EQ(growth->separation.largest.separation, 0) << "this build reproduces the log";
  Result<LogReader> other = open_memory(record_to_memory(pushed(scene, 5)));
  const Result<DivergenceGrowth> apart = growth_in_replay(*other, *again, 5);
  ASSERT_TRUE(apart.ok()) << apart.error().message;
  EXPECT_GT(apart->separation.rows.front().bodies, 0U);
  EXPECT_GT(apart->separation.largest.separation, 0) << "there was no push in the session that this build plays";
}

/// A log in whose first chunk one state does not match its state hash; all hashes of stored bytes are right.
Bytes with_broken_state(const Bytes& bytes, std::uint64_t step) {
  Result<LogReader> log = open_memory(bytes);
  const ChunkPlace place = log->chunks().front();
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(place.offset);
  Prelude prelude = *decode_prelude(std::span(bytes).subspan(place.offset).first<kPreludeBytes>());
  std::vector<StepRecord> steps;
  for (std::uint64_t k = place.first_step; k < place.end_step(); ++k) steps.push_back(**log->read_step(k));
  steps[step - place.first_step].states.velocity.x[1] += 1.0 / 64;
  ChunkEncoder encoder;
  const Result<MessageBytes> message = encoder.encode(**log->keyframe_at_or_before(place.first_step - 1), steps);
  Compressor compressor;
  Bytes stored;
  EXPECT_TRUE(message.ok() && compressor.compress(message->bytes(), stored).ok());
  prelude.raw_bytes = message->bytes().size();
  prelude.stored_bytes = stored.size();
  prelude.stored_hash = hash_bytes(stored);
  Bytes made(bytes.begin(), begin);
  const auto encoded = encode(prelude);
  made.insert(made.end(), encoded.begin(), encoded.end());
  made.insert(made.end(), stored.begin(), stored.end());
  return made;
}

TEST(BrokenLog, EqualHashesWithUnequalStatesAreNotCalledTheSame) {
  const Bytes bytes = record_to_memory(small_scene(20));
  Result<LogReader> a = open_memory(bytes), b = open_memory(with_broken_state(bytes, 9));
  ASSERT_TRUE(b.ok());
  ASSERT_EQ(b->last_step(), 20U);
  EXPECT_TRUE(diff_logs(*a, *b, {}, {}, Reading::kHashes)->identical()) << "by the hashes they are";
  const Result<DiffReport> status = diff_logs(*a, *b);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::kDamaged);
  EXPECT_NE(status.error().message.find("step 9"), std::string::npos) << status.error().message;
}

TEST(BrokenLog, EqualStatesWithUnequalHashesAreNotCalledDifferent) {
  StepRecord record;
  copy_visible(sim::create_world(small_scene())->bodies(), record.states);
  record.has_states = true;
  record.state_hash = state_hash(record.states);
  StepRecord liar = record;
  liar.state_hash.low ^= 1;
  const auto feed = [](const char* name, const StepRecord& r) {
    return SessionSteps{name, [&r](std::uint64_t) -> Result<const StepRecord*> { return &r; }};
  };
  const Result<Separation> separation =
      measure_separation(feed("good.tumble", record), feed("liar.tumble", liar), 3, 3);
  ASSERT_FALSE(separation.ok());
  EXPECT_EQ(separation.error().kind, ErrorKind::kDamaged);
  EXPECT_NE(separation.error().message.find("liar.tumble"), std::string::npos) << separation.error().message;
}

// The pair is the place that a hash of a phase does not tell; points in another order are no other points.
TEST(Separation, NamesTheFirstContactThatDiffers) {
  const auto first_of = [](const std::vector<EngineContact>& a, const std::vector<EngineContact>& b) {
    StepRecord in_a, in_b;
    in_a.extras.contacts = a;
    in_b.extras.contacts = b;
    const auto steps = [](const StepRecord& record) {
      return SessionSteps{"session", [&](std::uint64_t) -> Result<const StepRecord*> { return &record; }};
    };
    ChannelMatch match;
    match.contacts = true;
    Result<Separation> separation = measure_separation(steps(in_a), steps(in_b), 3, 5, {}, &match);
    EXPECT_TRUE(separation.ok()) << separation.error().message;
    EXPECT_EQ(separation->contacts_from, std::uint64_t{3});
    return separation->first_contact.value_or(ContactSeparation());
  };
  const EngineContact one = {1, 0, {0, 0, 0}, {0, 0, 1}, 0.1, 2}, two = {1, 0, {1, 0, 0}, {0, 0, 1}, 0.1, 2},
                      other = {1, 4, {0, 0, 0}, {0, 0, 1}, 0.1, 2};
  EngineContact harder = other;
  harder.impulse = 3;
  const auto pushed_more = first_of({one, other}, {one, harder});
  EXPECT_EQ(pushed_more.pair, std::pair(sim::BodyId{1}, sim::BodyId{4}));
  EXPECT_EQ(pushed_more.words, "impulse");
  EXPECT_EQ(first_of({one, two}, {two, one}).words, "the same points in another order");
  EXPECT_EQ(first_of({one, two}, {two, two}).words, "position");
  EXPECT_EQ(first_of({one, other}, {one}).words, "only the first log has this contact");
  EXPECT_EQ(first_of({one, two, harder}, {two, one, other}).pair.second, 0U) << "the first pair";
}

TEST(MetricBound, SaysWhetherAValueIsWithinIt) {
  const Result<MetricBound> bound = parse_metric_bound("lateral_max <= 0.5");
  ASSERT_TRUE(bound.ok()) << bound.error().message;
  EXPECT_EQ(std::string(bound->metric->name), "lateral_max");
  EXPECT_TRUE(bound->holds(0.5));
  EXPECT_FALSE(bound->holds(0.500001));
  EXPECT_FALSE(bound->holds(std::nan("")));
  EXPECT_FALSE(bound->holds(std::nullopt));
  EXPECT_FALSE(parse_metric_bound("lateral_max<0.5")->holds(0.5));
  EXPECT_TRUE(parse_metric_bound("lost>0")->holds(1));
  EXPECT_TRUE(parse_metric_bound("lost>=1")->holds(1));
  for (const char* wrong : {"", "lateral_max", "lateral_max=0", "lateral_max<=", "lateral_max<=x", "lateral_max<=nan",
                            "lateral_max<=0m", "no_such<=0", "<=0"}) {
    EXPECT_FALSE(parse_metric_bound(wrong).ok()) << wrong;
  }
  EXPECT_FALSE(parse_metric_bound("top_drop_max>=0").ok()) << "holds for every session";
  for (const char* optional : {"rest_time>=0", "mirror_error>=0", "gain_ratio>=0"}) {
    const Result<MetricBound> has_value = parse_metric_bound(optional);
    ASSERT_TRUE(has_value.ok()) << has_value.error().message;
    EXPECT_FALSE(has_value->holds(std::nullopt)) << "a session that never rests";
  }
}

}  // namespace
}  // namespace tumble::replay
