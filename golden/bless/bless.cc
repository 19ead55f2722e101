#include "tumble/golden/bless.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <system_error>

#include "golden/bless/from_report.h"
#include "golden/expected/expected_file.h"
#include "golden/judge/case_json.h"
#include "golden/run/external_engine.h"
#include "golden/run/longest_first.h"
#include "golden/run/repeated_runs.h"
#include "golden/run/run_case.h"
#include "golden/suite/parse_rules.h"
#include "golden/suite/text_files.h"
#include "replay/log/told_values.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "src/files/output_file.h"

namespace tumble::golden {
namespace {

/// A child's output has three parts: the result as JSON after its length, the new golden, the pictures.
constexpr std::size_t kLengthDigits = 12;

std::string hand_over(const CaseRun& run) {
  std::string golden;
  std::string pictures;
  Json json = to_json(run.result);
  json["unable"] = run.unable;
  if (run.incomplete.empty()) {
    const Result<std::vector<std::byte>> bytes = pack(run.actual);
    if (bytes.ok()) {
      golden.assign(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    } else {
      json["bless_refused"] = bytes.error().message;
    }
  }
  json["picture_bytes"] = Json::array();
  for (const DrawnPicture& picture : run.pictures) {
    json["picture_bytes"].push_back(picture.png.size());
    pictures.append(reinterpret_cast<const char*>(picture.png.data()), picture.png.size());
  }
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string length = std::to_string(text.size());
  SIM_CHECK(length.size() <= kLengthDigits, length.size());
  length.insert(0, kLengthDigits - length.size(), '0');
  return length + text + golden + pictures;
}

struct Handed {
  CaseFolder folder;
  CaseResult result;
  bool unable = false;  // the engine failed
  std::string golden;
  std::vector<std::string> pictures;  // one a [[picture]]; empty where it could not be drawn
  std::string rules_text;             // of the new metrics.toml
};

Handed take_over(const CaseFolder& folder, const process::JobResult& child) {
  Handed handed{
      .folder = folder, .result = {}, .unable = !child.failure.empty(), .golden = {}, .pictures = {}, .rules_text = {}};
  if (!child.failure.empty()) {
    handed.result.bless_refused = "its process " + child.failure;
    return handed;
  }
  const std::size_t length = std::stoul(child.output.substr(0, kLengthDigits));
  const std::string text = child.output.substr(kLengthDigits, length);
  Result<CaseResult> result = case_from_json(text);
  if (!result.ok()) {
    handed.result.bless_refused = result.error().message;
    return handed;
  }
  handed.result = *std::move(result);
  const Json json = Json::parse(text);
  handed.unable = json.at("unable");
  const std::vector<std::size_t> sizes = json.at("picture_bytes");
  const std::size_t end = child.output.size() - std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  std::size_t picture = end;
  for (const std::size_t size : sizes) {
    handed.pictures.push_back(child.output.substr(picture, size));
    picture += size;
  }
  handed.golden = child.output.substr(kLengthDigits + length, end - kLengthDigits - length);
  return handed;
}

/// A note of the session itself, which no blessing takes away.
bool says_cut(const std::string& note) { return note.starts_with(replay::kToldNote) || note.starts_with(kNearBound); }

Blessing blessing_of(const CaseResult& result, bool is_new) {
  Blessing blessing{.name = result.name, .is_new = is_new, .bits = {}, .details = {}, .metrics = result.metrics};
  const Verdict& exact = result.verdict(VerdictKind::kExact);
  blessing.bits = exact.message;
  if (is_new) {
    blessing.bits = "new, " + count_text(result.steps, "step") + " of " + count_text(result.bodies, "body");
  } else if (exact.message.empty()) {
    blessing.bits = "made anew, for the old golden could not be read";
  }
  if (!is_new && result.difference) blessing.details = result.difference->details;
  std::ranges::copy_if(result.notes, std::back_inserter(blessing.details), says_cut);
  for (const PictureResult& picture : result.pictures) {
    if (!picture.message.empty()) blessing.details.push_back(picture.rule.file() + ": " + picture.message);
  }
  std::erase_if(blessing.details, [](const std::string& detail) { return detail.starts_with("exact values"); });
  return blessing;
}

bool changes_something(const CaseResult& result, const std::string& old_rules, const std::string& new_rules) {
  return result.verdict(VerdictKind::kExact).outcome != Outcome::kPass || !result.problems.empty() ||
         !std::ranges::all_of(result.notes, says_cut) || old_rules != new_rules ||
         std::ranges::any_of(result.pictures, [](const PictureResult& picture) { return !picture.message.empty(); });
}

Status check_reason(const std::string& reason) {
  if (reason.find_first_not_of(' ') != std::string::npos && reason.find('\n') == std::string::npos) return {};
  return bad_input("--reason: wanted one line that says why the goldens move; it goes into HISTORY.md");
}

/// The new text of metrics.toml.
Result<std::string> new_rules(const Handed& handed, std::string& old_text) {
  const std::string path = handed.folder.file(kRulesFile).string();
  Result<std::string> text = read_text(path);
  if (!text.ok()) return text.error();
  old_text = *text;
  const Result<CaseRules> rules = parse_rules(*text, path);
  if (!rules.ok()) return rules.error();
  std::vector<std::optional<double>> values;
  for (const MetricResult& metric : handed.result.metrics) {
    if (!metric.rule.is_law) values.push_back(metric.value);
  }
  if (values.size() != rules->metrics.size()) return cannot_finish(path + ": changed while it was read");
  return with_values(*text, path, *rules, values);
}

Result<std::vector<Handed>> run_all(const BlessOptions& options, const std::vector<CaseFolder>& folders,
                                    const RecordedCases& recorded) {
  std::vector<Handed> handed;
  if (recorded.empty()) {
    if (Status ok = build_engine_of(folders, options.suite, options.pool.cancel); !ok.ok()) return ok.error();
  }
  const RunOptions run = {.suite = options.suite, .require = {}, .report = {}, .to_bless = true, .recorded = recorded};
  const bool finished = process::run_jobs(
      folders.size(), [&](std::size_t i) { return hand_over(run_case(folders[i], run)); },
      [&](std::size_t i, const process::JobResult& child) { handed.push_back(take_over(folders[i], child)); },
      options.pool);
  if (!finished) return cannot_finish("interrupted; nothing was blessed");
  std::ranges::sort(handed, {}, [](const Handed& h) { return h.folder.name; });
  for (const Handed& one : handed) {
    const std::string& why = one.result.bless_refused;
    if (why.empty()) continue;
    const std::string text = one.folder.name + ": " + why + "; nothing was blessed";
    return one.unable ? cannot_finish(text) : bad_input(text);
  }
  return handed;
}

/// What blessing may replace. Rules that cannot be read are told by the case's run.
std::vector<std::filesystem::path> files_of(const CaseFolder& folder) {
  std::vector<std::filesystem::path> files = {folder.file(kRulesFile), folder.file(kExpectedFile)};
  const Result<CaseRules> rules = read_rules(folder.file(kRulesFile));
  if (!rules.ok()) return files;
  for (const PictureRule& picture : rules->pictures) files.push_back(folder.path / picture.file());
  return files;
}

/// Writes nothing for any case where one of them cannot be written.
Status can_write(const BlessOptions& options, const std::vector<CaseFolder>& folders) {
  if (options.dry_run) return {};
  std::vector<std::filesystem::path> places = {options.suite};
  for (const CaseFolder& folder : folders) places.push_back(folder.path);
  for (const std::filesystem::path& place : places) {
    const Status ok = files::can_write_in(place, place);
    if (!ok.ok()) return Error{ok.error().kind, ok.error().message + "; nothing was blessed"};
  }
  std::vector<std::filesystem::path> files = {options.suite / kHistoryFile};
  for (const CaseFolder& folder : folders) std::ranges::copy(files_of(folder), std::back_inserter(files));
  for (const std::filesystem::path& file : files) {
    const Status ok = files::may_write(file.string());
    if (!ok.ok()) return Error{ok.error().kind, ok.error().message + "; nothing was blessed"};
  }
  return {};
}

Status write_case(const Handed& handed) {
  if (Status ok = write_file(handed.folder.file(kRulesFile), std::string_view(handed.rules_text)); !ok.ok()) return ok;
  for (std::size_t k = 0; k < handed.pictures.size(); ++k) {
    const std::string name = handed.result.pictures[k].rule.file();
    // A picture whose pixels did not move keeps its bytes, which name the driver that made them.
    if (handed.result.pictures[k].message.empty()) continue;
    if (Status ok = write_file(handed.folder.path / name, std::string_view(handed.pictures[k])); !ok.ok()) return ok;
  }
  return write_file(handed.folder.file(kExpectedFile), std::string_view(handed.golden));
}

}  // namespace

Result<BlessReport> bless_cases(const BlessOptions& options) {
  if (Status ok = check_reason(options.reason); !ok.ok()) return ok.error();
  const Result<Suite> suite = open_suite(options.suite);
  if (!suite.ok()) return suite.error();
  RecordedCases recorded;
  Selection chosen;
  chosen.names = options.names;
  if (!options.report.empty()) {
    Result<RecordedCases> opened = open_report(options.report);
    if (!opened.ok()) return opened.error();
    recorded = *std::move(opened);
    // All of a report are the cases that failed there.
    for (const auto& [name, one] : recorded) {
      if (options.names.empty()) chosen.names.push_back(name);
    }
  }
  Result<std::vector<CaseFolder>> folders = select_cases(*suite, chosen);
  if (!folders.ok()) return folders.error();
  if (Status ok = can_write(options, *folders); !ok.ok()) return ok.error();
  Result<std::vector<Handed>> handed = run_all(options, longest_first(*std::move(folders)), recorded);
  if (!handed.ok()) return handed.error();

  BlessReport report;
  std::vector<const Handed*> changed;
  for (Handed& one : *handed) {
    std::string old_rules;
    Result<std::string> rules = new_rules(one, old_rules);
    if (!rules.ok()) return rules.error();
    one.rules_text = *std::move(rules);
    std::error_code error;
    if (!changes_something(one.result, old_rules, one.rules_text)) {
      report.unchanged.push_back(one.folder.name);
      continue;
    }
    const bool is_new = !std::filesystem::exists(one.folder.file(kExpectedFile), error);
    report.blessed.push_back(blessing_of(one.result, is_new));
    changed.push_back(&one);
  }
  if (options.dry_run || changed.empty()) return report;
  for (const Handed* one : changed) {
    if (Status ok = write_case(*one); !ok.ok()) return ok.error();
  }
  const std::string entry = history_entry(options.reason, report.blessed);
  if (Status ok = add_to_history(options.suite, entry); !ok.ok()) return ok.error();
  return report;
}

}  // namespace tumble::golden
