#include "golden/hunt/finding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>

#include "golden/suite/text_files.h"
#include "src/base/text.h"

namespace tumble::hunt {
std::string name_of(const Finding& finding) {
  return finding.relation + "_" + std::to_string(finding.seed) + "_" + std::to_string(finding.number);
}

int decade_of(const Judgement& judgement) {
  if (!(judgement.bound > 0) || !std::isfinite(judgement.value)) return 0;
  const double times = judgement.value / judgement.bound;
  return times >= 1e9 ? 9 : static_cast<int>(std::floor(std::log10(std::max(times, 1.0))));
}

bool is_judges_error(const std::string& relation, const std::string& judging, const std::string& engine) {
  return relation == kSurvives && (!judging.empty() || !engine.empty());
}

Judgement ended(const std::string& failure, const std::string& judging, bool of_engine) {
  std::string what = (of_engine ? "Tumble's judge, and not the engine, " : "the program ") + failure;
  if (!judging.empty()) what += " while it judged " + judging;
  return broken(0, 0, std::move(what));
}

std::string told_in(const std::filesystem::path& file) {
  Result<std::string> text = golden::read_text(file);
  return text.ok() ? *std::move(text) : std::string();
}

std::vector<FindingGroup> grouped(const std::vector<Finding>& findings) {
  std::map<std::tuple<std::string, std::string, int>, FindingGroup> groups;
  for (const Finding& one : findings) {
    const int decade = decade_of(one.judgement);
    FindingGroup& group = groups[{one.relation, one.judgement.phase, decade}];
    group.relation = one.relation;
    group.phase = one.judgement.phase;
    group.decade = decade;
    group.findings.push_back(&one);
  }
  std::vector<FindingGroup> out;
  for (auto& [key, group] : groups) {
    std::ranges::sort(group.findings, {}, [](const Finding* one) { return std::pair(!one->shrunk(), one->number); });
    out.push_back(std::move(group));
  }
  std::ranges::stable_sort(out, std::greater{}, [](const FindingGroup& group) { return group.findings.size(); });
  return out;
}

Json to_json(const Judgement& judgement) {
  return {{"step", judgement.step},   {"phase", judgement.phase}, {"body", judgement.body}, {"what", judgement.what},
          {"value", judgement.value}, {"bound", judgement.bound}, {"unit", judgement.unit}};
}

Json to_json(const Finding& finding) {
  Json json = {{"name", name_of(finding)}, {"relation", finding.relation}, {"seed", finding.seed},
               {"number", finding.number}, {"kind", finding.kind},         {"found", to_json(finding.judgement)}};
  if (!finding.judging.empty()) json["judging"] = finding.judging;
  if (!finding.engine_files.empty()) json["engine_files"] = finding.engine_files;
  json["shrunk"] = nullptr;
  if (!finding.shrunk()) return json;
  json["shrunk"] = {{"scene", finding.shrunk_text}, {"found", to_json(finding.shrunk_judgement)},
                    {"bodies", finding.bodies},     {"steps", finding.steps},
                    {"tried", finding.tried},       {"least", finding.least}};
  return json;
}

std::string whole_text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

namespace {

// A value that is no finite number is null in JSON.
double number_from(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

}  // namespace

Judgement judgement_from(const Json& json) {
  Judgement out;
  out.outcome = Outcome::kBroken;
  out.step = json.at("step");
  out.phase = json.at("phase");
  out.body = json.at("body");
  out.what = json.at("what");
  out.value = number_from(json.at("value"));
  out.bound = number_from(json.at("bound"));
  out.unit = json.at("unit");
  return out;
}

Finding finding_from(const Json& json) {
  Finding out;
  out.relation = json.at("relation");
  out.seed = json.at("seed");
  out.number = json.at("number");
  out.kind = json.at("kind");
  out.judgement = judgement_from(json.at("found"));
  out.judging = json.value("judging", "");
  out.engine_files = json.value("engine_files", std::vector<std::string>{});
  const Json& shrunk = json.at("shrunk");
  if (shrunk.is_null()) return out;
  out.shrunk_text = shrunk.at("scene");
  out.shrunk_judgement = judgement_from(shrunk.at("found"));
  out.bodies = shrunk.at("bodies");
  out.steps = shrunk.at("steps");
  out.tried = shrunk.at("tried");
  out.least = shrunk.at("least");
  return out;
}

namespace {

// The metrics that measure what a law bounds.
struct LawMetric {
  std::string_view law;
  const char* metric;
};
constexpr LawMetric kLawMetrics[] = {{"energy", "gain_max"},
                                     {"overlap", "overlap_peak"},
                                     {"overlap", "ground_penetration_peak"},
                                     {"standing", "drift_max"}};

// Rules by which the case fails until what was found is mended; a comment where another build is part of what was
// found.
std::string rules_of_law(const std::string& law, double bound) {
  std::string text;
  for (const LawMetric& one : kLawMetrics) {
    if (one.law != law || !(bound > 0) || !std::isfinite(bound)) continue;
    text += std::string("\n[[metric]]\nname = \"") + one.metric + "\"\nmax = " + Json(bound).dump() +
            "\nwhy = \"the bound of the law '" + law + "' in this scene; bless refuses what is beyond it\"\n";
  }
  if (!text.empty()) return text;
  if (find_relation(law) != nullptr) return "\n[laws]\n" + law + " = true\n";
  if (law == kSurvives) return std::string("\n[laws]\n") + kSurvives + " = true\n";
  return "# No rule judges this: a golden that is blessed before it is mended accepts it.\n";
}

}  // namespace

std::string case_rules(const Finding& finding, std::string_view program, bool of_engine) {
  const Judgement& found = finding.shrunk() ? finding.shrunk_judgement : finding.judgement;
  std::string what;
  for (const char c : printable(describe(found))) what += c == '"' || c == '\\' ? '\'' : c;
  return "# Found by `tumble hunt`: seed " + std::to_string(finding.seed) + ", scene " +
         std::to_string(finding.number) + ", tumble " + std::string(program) + "; broke \"" + finding.relation +
         "\".\n# " + what + "\n" + (of_engine ? "\n[engine]\nscene = \"scene.toml\"\n" : "") +
         rules_of_law(finding.relation, found.bound) +
         "\n[[metric]]\nname = \"lost\"\nmax = 0.0\nwhy = \"nothing falls through the ground or through another "
         "body\"\n";
}

}  // namespace tumble::hunt
