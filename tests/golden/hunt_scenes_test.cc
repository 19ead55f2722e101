// Scenes of a hunt: drawn, written, shrunk.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "golden/hunt/corpus.h"
#include "golden/hunt/finding.h"
#include "golden/hunt/hunt.h"
#include "golden/hunt/judge/features.h"
#include "golden/hunt/judge/relation.h"
#include "golden/hunt/scene/grammar.h"
#include "golden/hunt/scene/scene_text.h"
#include "golden/hunt/shrink/shrink.h"
#include "golden/suite/temporary_folder.h"
#include "tests/golden/hunt_session.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/hash.h"

namespace tumble::test {
namespace {

using hunt::Judgement;
using hunt::TextScene;

// A scene of a folder has a title of its own.
TEST(HuntScenes, AreWrittenWithAnyTitle) {
  sim::SceneDef scene = hunt::random_scene(7, 1);
  scene.title = R"(a "quoted" title \ with a 'slash' # and more)";
  const Result<TextScene> text = hunt::settled(scene);
  ASSERT_TRUE(text.ok()) << text.error().message;
  EXPECT_EQ(text->scene.title, scene.title);
}

// The scene of a seed and a number is part of every report: whoever changes the grammar raises kGrammar.
TEST(HuntScenes, AreThoseOfTheGrammarsVersion) {
  Hasher hasher;
  std::set<std::string> kinds;
  std::size_t weak = 0, none = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const sim::SceneDef scene = hunt::random_scene(7, number);
    const std::string text = hunt::scene_text(scene);
    hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    kinds.insert(scene.title.substr(0, scene.title.find(',')));
    const double gravity = sim::length(scene.world.gravity);
    weak += gravity > 0 && gravity < 9 ? 1U : 0U;
    none += gravity == 0 ? 1U : 0U;
  }
  EXPECT_GE(weak, 5U);
  EXPECT_GE(none, 10U);
  EXPECT_EQ(hunt::kGrammar, 2U);
  EXPECT_EQ(to_string(hasher.digest()), "426bd527b8444851042925f5b289f3da");
  EXPECT_EQ(kinds.size(), 12U);
}

TEST(HuntScenes, ReadBackFromTheirTextToTheLastBit) {
  for (std::uint64_t number = 0; number < 300; ++number) {
    const Result<TextScene> text = hunt::settled(hunt::random_scene(1, number));
    ASSERT_TRUE(text.ok()) << number << ": " << text.error().message;
    EXPECT_EQ(hunt::scene_text(text->scene), text->text);
    EXPECT_LE(text->scene.boxes.size(), hunt::kBodiesMost);
    const Result<sim::SceneDef> again = scenes::parse_scene(text->text, "again.toml");
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(*again, text->scene) << number;
  }
}

// Breaks where any body is wider than 2 m.
Judgement wide(const hunt::Trace&, const TextScene& scene) {
  for (const sim::BoxDef& box : scene.scene.boxes) {
    if (box.size.x() > 2) return hunt::broken(1, box.id, "wide", box.size.x(), 2, "m");
  }
  return hunt::held();
}

TEST(HuntShrink, LeavesNothingThatCanGo) {
  sim::SceneDef scene = hunt::random_scene(3, 4);
  while (scene.boxes.size() < 5) {
    scene.boxes.push_back(scene.boxes.back());
    scene.boxes.back().id += 1;
    scene.boxes.back().position.x() += 100;
  }
  scene.boxes[2].size = {2.123456789, 1.23, 4.56};
  scene.boxes[2].orientation = sim::normalised({1, 0.2, 0.3, 0.4});
  scene.inputs = {{3, sim::SetGravity{{1, 2, -3}}}};
  const Result<TextScene> text = hunt::settled(scene);
  ASSERT_TRUE(text.ok()) << text.error().message;
  const hunt::Shrunk least = hunt::shrink(*text, wide({}, *text), wide, hunt::trace, 5000);
  EXPECT_TRUE(least.least);
  EXPECT_EQ(least.scene.scene.boxes.size(), 1U);
  EXPECT_EQ(least.scene.scene.boxes[0].id, 1U);
  EXPECT_TRUE(least.scene.scene.inputs.empty());
  EXPECT_EQ(least.scene.scene.steps, 1U);
  EXPECT_EQ(least.scene.scene.boxes[0].orientation, sim::Quat{});
  EXPECT_LE(least.scene.text.size(), 200U) << least.scene.text;
}

TEST(HuntShrink, StopsAtItsBoundAndSaysSo) {
  sim::SceneDef scene = hunt::random_scene(3, 4);
  scene.boxes[0].size.x() = 2.5;
  const Result<TextScene> text = hunt::settled(scene);
  ASSERT_TRUE(text.ok()) << text.error().message;
  const hunt::Shrunk some = hunt::shrink(*text, wide({}, *text), wide, hunt::trace, 3);
  EXPECT_FALSE(some.least);
  EXPECT_EQ(some.tried, 3U);
}

// A folder of its own, removed at the end.
const golden::TemporaryFolder& place() {
  static const golden::TemporaryFolder kPlace("hunt_test");
  return kPlace;
}

TEST(HuntCorpus, KeepsWhatDoesSomethingNew) {
  Result<hunt::Corpus> corpus = hunt::Corpus::open(place().path() / "one");
  ASSERT_TRUE(corpus.ok());
  const Result<TextScene> scene = hunt::settled(hunt::random_scene(1, 5));
  ASSERT_TRUE(scene.ok());
  EXPECT_TRUE(*corpus->add(*scene, {"a", "b"}));
  EXPECT_FALSE(*corpus->add(*scene, {"b"}));
  EXPECT_EQ(corpus->files().size(), 1U);
  EXPECT_EQ(corpus->features().size(), 2U);
}

TEST(HuntCorpus, MergesWithAnotherAndOpensAgain) {
  const auto filled = [](const char* name, std::uint64_t first) {
    Result<hunt::Corpus> corpus = hunt::Corpus::open(place().path() / name);
    EXPECT_TRUE(corpus.ok());
    for (std::uint64_t number = first; number < first + 12; ++number) {
      const Result<TextScene> scene = hunt::settled(hunt::random_scene(1, number));
      const Result<hunt::Trace> session = hunt::trace(scene->scene);
      EXPECT_TRUE(corpus->add(*scene, hunt::features_of(*session)).ok());
    }
    return *std::move(corpus);
  };
  hunt::Corpus left = filled("left", 0);
  const hunt::Corpus right = filled("right", 40);
  const std::size_t before = left.files().size();
  const Result<std::size_t> added = left.merge(place().path() / "right");
  ASSERT_TRUE(added.ok());
  EXPECT_EQ(left.files().size(), before + *added);
  for (const std::string& one : right.features()) EXPECT_TRUE(left.features().contains(one)) << one;
  EXPECT_EQ(*left.merge(place().path() / "right"), 0U);
  const Result<hunt::Corpus> again = hunt::Corpus::open(place().path() / "left");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->features(), left.features());
}

bool does(const std::vector<std::string>& features, const std::string& word) {
  return std::ranges::find(features, word) != features.end();
}

TEST(HuntFeatures, AnIslandSplitsWhereItsBodiesPartAwake) {
  const std::string pair =
      "[world]\nsteps = 40\ngravity = [0, 0, 0]\nground = false\n[material]\nrestitution = 0.5\n"
      "[[box]]\nid = 1\nposition = [0, 0, 5]\n[[box]]\nid = 2\nposition = [1.5, 0, 5]\nvelocity = [-4, 0, 0]\n";
  const auto parted = hunt::features_of(traced(pair.c_str()));
  EXPECT_TRUE(does(parted, "layered: an island splits"));
  EXPECT_FALSE(does(parted, "layered: an island splits into islands"));
  // Asleep nothing meets, and no island has split.
  for (const std::string method : {"thesis", "layered"}) {
    const std::string stack = "[world]\nsteps = 300\nmethod = \"" + method +
                              "\"\n[[box]]\nid = 1\nposition = [0, 0, 0.5]\n[[box]]\nid = 2\nposition = [0, 0, 1.5]\n";
    const auto asleep = hunt::features_of(traced(stack.c_str()));
    EXPECT_TRUE(does(asleep, method + ": a body falls asleep"));
    EXPECT_TRUE(does(asleep, method + ": 2 bodies in an island or more"));
    EXPECT_FALSE(does(asleep, method + ": an island splits"));
  }
}

TEST(HuntFeatures, TellHowNearALawsBoundWas) {
  std::size_t near = 0;
  for (std::uint64_t number = 0; number < 40; ++number) {
    const Result<hunt::Trace> session = hunt::trace(hunt::random_scene(1, number));
    ASSERT_TRUE(session.ok());
    const std::vector<std::string> features = hunt::features_of(*session);
    const std::string front = session->scene.world.method == sim::Method::kThesis ? "thesis: " : "layered: ";
    for (const hunt::Relation& law : hunt::relations()) {
      const hunt::Judgement one = law.is_law ? law.judge(*session) : hunt::not_applicable("a relation");
      const bool held = one.outcome == hunt::Outcome::kHeld && one.bound > 0;
      for (const int percent : {50, 90, 99}) {
        const bool reaches = held && one.value >= percent * one.bound / 100;
        near += reaches ? 1U : 0U;
        EXPECT_EQ(does(features, front + law.name + " reaches " + std::to_string(percent) + " % of its bound"), reaches)
            << law.name << " in scene " << number;
      }
    }
  }
  EXPECT_GT(near, 3U);
}

hunt::Finding finding(const char* relation, std::uint64_t number, double value) {
  hunt::Finding out;
  out.relation = relation;
  out.number = number;
  out.judgement = hunt::broken(5, 1, "found", value, 1, "m");
  return out;
}

// No claim of an engine covers it, and no relation counts it as broken: a kept hunt reads back.
TEST(HuntScenes, ASceneThatEndsTheProgramStaysAFinding) {
  hunt::HuntState state;
  state.relations = {{"ids", {}}};
  state.relations[0].second.not_applicable = state.next = 1;
  state.findings.push_back(finding(hunt::kSurvives, 0, 0));
  EXPECT_FALSE(hunt::claims_hold(state));
  state.engine = "my_engine {log}";
  EXPECT_FALSE(hunt::claims_hold(state));
  const hunt::Folder folder(place().path() / "survives");
  ASSERT_TRUE(folder.save(state).ok());
  const Result<hunt::HuntState> kept = folder.load();
  ASSERT_TRUE(kept.ok()) << kept.error().message;
  EXPECT_EQ(kept->findings.at(0).relation, hunt::kSurvives);
  state.findings[0].relation = "ids";
  EXPECT_TRUE(hunt::claims_hold(state)) << "what an engine does not claim is measured";
}

TEST(HuntFindings, AreGroupedByRelationPhaseAndSize) {
  const std::vector<hunt::Finding> all = {finding("overlap", 9, 2), finding("energy", 1, 2), finding("overlap", 3, 5),
                                          finding("overlap", 4, 5000)};
  const std::vector<hunt::FindingGroup> groups = hunt::grouped(all);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].findings.size(), 2U);
  EXPECT_EQ(groups[0].findings[0]->number, 3U);
  EXPECT_EQ(groups[0].decade, 0);
  EXPECT_EQ(groups[2].decade, 3);
}

}  // namespace
}  // namespace tumble::test
