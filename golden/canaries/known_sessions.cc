#include <array>
#include <cstdint>
#include <string>

#include "golden/canaries/known_answers.h"
#include "golden/hunt/apart/session_pair.h"
#include "golden/hunt/judge/relation.h"
#include "golden/hunt/scene/grammar.h"

namespace tumble::golden {
namespace {

struct Way {
  const char* relation;  // of hunt
  const char* name;
  const char* about;
};
constexpr std::array kWays = {
    Way{"repeat", "a session run again has the same bits", "suite"},
    Way{"lanes", "every width of lanes gives the same bits", "suite"},
    Way{"threads", "threads give the same bits", "suite"},
    Way{"resumed", "a step from a snapshot has the same bits", "format"},
    Way{"replayed", "a session through its log has the same bits", "format"},
};

// The first scenes of a seed, of both methods; none was chosen for what it finds. Symmetries are cases of the suite.
constexpr std::uint64_t kSeed = 21;
constexpr std::uint64_t kScenes = 6;

// A box that falls: its session beside itself is within all usual bounds, and beside one that is moved by a millimetre
// is not.
CanaryResult judge_pair() {
  CanaryResult result = {"a session a millimetre off is not within bounds", false, "as known", "suite"};
  sim::SceneDef scene;
  scene.steps = 8;
  scene.boxes.resize(1);
  scene.boxes[0].id = 1;
  scene.boxes[0].position = {0, 0, 4};
  const Result<hunt::Trace> trace = hunt::trace(scene);
  if (!trace.ok()) {
    result.message = trace.error().message;
    return result;
  }
  std::vector<replay::StepRecord> records = hunt::records_of(*trace);
  const auto broken = [&] {
    const hunt::SessionPair pair(*trace, records);
    std::string names;
    for (const hunt::ApartBound& bound : hunt::usual_bounds()) {
      if (pair.judge(bound).outcome == hunt::Outcome::kBroken) names += bound.measure + " ";
    }
    return names;
  };
  const std::string of_itself = broken();
  for (replay::StepRecord& record : records) record.states.position.x[0] += 1e-3;
  const std::string of_moved = broken();
  result.caught = of_itself.empty() && of_moved == "place ";
  if (!result.caught) result.message = "of itself: " + of_itself + "; of the one that is moved: " + of_moved;
  return result;
}

}  // namespace

std::vector<CanaryResult> run_known_sessions() {
  std::vector<CanaryResult> results;
  results.reserve(kWays.size() + 1);
  for (const Way& way : kWays) results.push_back({way.name, true, "as known", way.about});
  for (std::uint64_t number = 0; number < kScenes; ++number) {
    const Result<hunt::Trace> trace = hunt::trace(hunt::random_scene(kSeed, number));
    for (std::size_t k = 0; k < kWays.size(); ++k) {
      if (!results[k].caught) continue;
      const std::string scene = "scene " + std::to_string(number) + " of seed " + std::to_string(kSeed) + ": ";
      const hunt::Judgement one = trace.ok() ? hunt::find_relation(kWays[k].relation)->judge(*trace)
                                             : hunt::broken(0, 0, trace.error().message);
      if (one.outcome != hunt::Outcome::kBroken) continue;
      results[k].caught = false;
      results[k].message = scene + "step " + std::to_string(one.step) + ": " + one.what;
    }
  }
  results.push_back(judge_pair());
  return results;
}

}  // namespace tumble::golden
