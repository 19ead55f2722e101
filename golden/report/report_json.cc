#include "golden/report/report_json.h"

#include <nlohmann/json.hpp>

#include "golden/judge/across_cases.h"
#include "golden/report/commands.h"
#include "src/base/schema_name.h"
#include "tumble/golden/change.h"
#include "tumble/golden/suite.h"

namespace tumble::golden {

Json report_json(const SuiteResult& result) {
  Json json = {{"schema", schema_name("check")},
               {"passed", result.passed()},
               {"headline", headline(result)},
               {"across", across_cases(result.cases)},
               {"suite", result.suite},
               {"folder", current_folder()},
               {"run", to_json(result.run)},
               {"shard", result.shard},
               {"shards", result.shards},
               {"assignment", kAssignment},
               {"judged_cases", result.cases.size()},
               {"is_empty_shard", result.is_empty_shard()},
               {"seconds", result.seconds},
               {"failed_cases", result.failed_cases()},
               {"canaries_caught", result.canaries_caught()},
               {"canaries_of_all_shards", std::max(result.canaries.size(), result.facts.canaries.size())},
               {"problems", result.problems}};
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    json["failed_verdicts"][kVerdictNames[k]] = result.failed(static_cast<VerdictKind>(k));
  }
  for (const Change change : {Change::kNone, Change::kWithinBounds, Change::kOutOfBounds, Change::kNotJudged}) {
    json["changes"][key_of(change)] = result.with(change);
  }
  json["cases"] = Json::array();
  for (const CaseResult& one : result.cases) json["cases"].push_back(to_json(one));
  json["canaries"] = Json::array();
  for (const CanaryResult& canary : result.canaries) {
    json["canaries"].push_back({{"name", canary.name},
                                {"caught", canary.caught},
                                {"about", canary.about},
                                {"words", canary.message},
                                {"asked", canary.asked}});
  }
  return json;
}

}  // namespace tumble::golden
