#include "golden/report/report.h"

#include <nlohmann/json.hpp>

#include "golden/judge/across_cases.h"
#include "golden/judge/change.h"
#include "golden/report/commands.h"
#include "golden/report/html.h"
#include "golden/report/junit.h"
#include "golden/report/report_place.h"
#include "golden/suite/text_files.h"

namespace tumble::golden {

Json report_json(const SuiteResult& result) {
  Json json = {{"passed", result.passed()},
               {"headline", headline(result)},
               {"across", across_cases(result.cases)},
               {"suite", result.suite},
               {"folder", current_folder()},
               {"run", to_json(result.run)},
               {"shard", result.shard},
               {"shards", result.shards},
               {"judged_cases", result.cases.size()},
               {"is_empty_shard", result.is_empty_shard()},
               {"seconds", result.seconds},
               {"failed_cases", result.failed_cases()},
               {"canaries_caught", result.canaries_caught()},
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
    json["canaries"].push_back(
        {{"name", canary.name}, {"caught", canary.caught}, {"about", canary.about}, {"words", canary.message}});
  }
  return json;
}

Status write_reports(const SuiteResult& result, const std::filesystem::path& folder,
                     const std::filesystem::path& junit) {
  const std::string json = report_json(result).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  if (Status ok = write_file(folder / "report.json", std::string_view(json)); !ok.ok()) return ok;
  const std::filesystem::path junit_path = junit_file(folder, junit);
  if (Status ok = write_file(junit_path, std::string_view(report_junit(result))); !ok.ok()) return ok;
  return write_file(folder / "index.html", std::string_view(report_html(result, folder)));
}

}  // namespace tumble::golden
