#include "golden/bundle/read_results.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "golden/judge/case_json.h"

namespace tumble::golden {
namespace {

constexpr int kKeys = 1;   // depth of the keys of a report
constexpr int kItems = 2;  // of the items of its lists

ShardReport report_from(const Json& json) {
  ShardReport report;
  report.problems = json.at("problems");
  for (const Json& one : json.at("canaries")) {
    report.canaries.push_back({one.at("name"), one.at("caught"), one.at("words"), one.at("about"), one.at("asked")});
  }
  return report;
}

}  // namespace

Result<ShardReport> read_results(const Bundle& bundle, const std::function<void(CaseResult result)>& take) {
  const std::filesystem::path path = bundle.folder / kReportFile;
  const std::vector<std::string>& wanted = bundle.manifest.judged;
  std::ifstream file(path, std::ios::binary);
  std::string list;  // the key whose value is read
  std::size_t count = 0;
  bool right = true;
  const Json::parser_callback_t each = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth == kKeys && event == Json::parse_event_t::key) list = parsed.get<std::string>();
    if (depth != kItems || event != Json::parse_event_t::object_end || list != "cases") return true;
    CaseResult one = case_from(parsed);
    right = right && count < wanted.size() && one.name == wanted[count];
    ++count;
    if (right) take(std::move(one));
    return false;  // it is not kept
  };
  std::string fault;
  try {
    const Json json = Json::parse(file, each);
    ShardReport report = report_from(json);
    const bool asked = std::ranges::equal(report.canaries, bundle.manifest.canaries, {}, &CanaryResult::name);
    if (right && count == wanted.size() && asked) return report;
    fault = std::string("its ") + (asked ? "cases" : "canaries") + " are not those that bundle.json names";
  } catch (const Json::exception& problem) {
    fault = problem.what();
  }
  return Error{ErrorKind::kDamaged, path.string() + ": damaged: " + fault + "; run that shard again"};
}

}  // namespace tumble::golden
