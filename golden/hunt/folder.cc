#include "golden/hunt/folder.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "golden/bundle/sealed_text.h"
#include "golden/hunt/apart/apart_bounds.h"
#include "golden/hunt/engine/kept_run.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"

namespace tumble::hunt {
namespace {

constexpr const char* kFindings = "findings";
constexpr int kFormat = 2;

Tally tally_from(const Json& row) {
  Tally tally{row.at("held"), row.at("broken"), row.at("not_applicable"), std::nullopt, 0};
  // Null: no scene that held has a bound. 0 in both, of hunts kept by programs that knew no null, says that too.
  const Json &nearest = row.at("nearest"), &number = row.at("nearest_number");
  if (nearest.is_number() && (nearest != 0 || number != 0)) tally.nearest = nearest;
  if (number.is_number()) tally.nearest_number = number;
  return tally;
}

HuntState state_from(const Json& json) {
  HuntState state;
  state.seed = json.at("seed");
  state.share = {json.value("shard", std::uint64_t{1}), json.value("shards", std::uint64_t{1})};
  state.grammar = json.at("grammar");
  state.program = json.at("program");
  state.against = json.at("against");
  state.within = json.value("within", std::vector<std::string>{});
  state.engine = json.value("engine", "");
  state.engine_hash = json.value("engine_hash", "");
  state.claimed = json.value("claimed", std::vector<std::string>{});
  state.ended = json.value("ended", false);
  state.merged = json.value("merged", std::uint64_t{0});
  if (!json.at("count").is_null()) state.count = json.at("count").get<std::uint64_t>();
  state.next = json.at("scenes");
  state.no_scenes = json.at("no_scenes");
  state.refused = json.at("refused");
  state.refusal = json.value("refusal", "");
  for (const auto& [name, row] : json.at("relations").items()) {
    state.relations.emplace_back(name, tally_from(row));
  }
  for (const Json& one : json.at("findings")) state.findings.push_back(finding_from(one));
  return state;
}

// A hash finds damage; counts that contradict each other were written by no hunt.
std::string fault_of_counts(const HuntState& state) {
  if (state.no_scenes + state.refused > state.next) return "it counts more scenes without a session than scenes";
  const std::uint64_t judged = state.next - state.no_scenes - state.refused;
  for (const auto& [name, tally] : state.relations) {
    const std::uint64_t sum = tally.held + tally.broken + tally.not_applicable;
    if (sum != judged) return found_wanted(std::to_string(sum) + " scenes by " + name, std::to_string(judged));
    const auto listed = std::ranges::count(state.findings, name, &Finding::relation);
    if (static_cast<std::uint64_t>(listed) == tally.broken) continue;
    return "it counts " + std::to_string(tally.broken) + " scenes that broke " + name + " and lists " +
           std::to_string(listed);
  }
  return "";
}

}  // namespace

void Tally::add(const Tally& other) {
  held += other.held;
  broken += other.broken;
  not_applicable += other.not_applicable;
  if (other.nearest && (!nearest || *other.nearest > *nearest)) {
    nearest = other.nearest;
    nearest_number = other.nearest_number;
  }
}

void Tally::count(const Judgement& one, std::uint64_t number) {
  if (one.outcome == Outcome::kBroken) ++broken;
  if (one.outcome == Outcome::kNotApplicable) ++not_applicable;
  if (one.outcome != Outcome::kHeld) return;
  ++held;
  if (one.bound > 0 && (!nearest || one.value / one.bound > *nearest)) {
    nearest = one.value / one.bound;
    nearest_number = number;
  }
}

Json to_json(const Tally& tally) {
  return {{"held", tally.held},
          {"broken", tally.broken},
          {"not_applicable", tally.not_applicable},
          {"nearest", tally.nearest ? Json(*tally.nearest) : Json()},
          {"nearest_number", tally.nearest ? Json(tally.nearest_number) : Json()}};
}

Json to_json(const HuntState& state) {
  Json json = {{"format", kFormat},
               {"seed", state.seed},
               {"grammar", state.grammar},
               {"program", state.program},
               {"against", state.against},
               {"shard", state.share.shard},
               {"shards", state.share.shards},
               {"ended", state.ended},
               {"merged", state.merged},
               {"count", state.count ? Json(*state.count) : Json()},
               {"scenes", state.next},
               {"no_scenes", state.no_scenes},
               {"refused", state.refused}};
  if (!state.within.empty()) json["within"] = state.within;
  if (state.refused > 0) json["refusal"] = state.refusal;
  if (!state.engine.empty()) {
    json["engine"] = state.engine;
    json["claimed"] = state.claimed;
  }
  if (!state.engine_hash.empty()) json["engine_hash"] = state.engine_hash;
  json["relations"] = Json::object();
  for (const auto& [name, tally] : state.relations) json["relations"][name] = to_json(tally);
  json["findings"] = Json::array();
  for (const Finding& one : state.findings) json["findings"].push_back(to_json(one));
  if (state.beyond.scenes > 0) {
    json["beyond"] = {{"scenes", state.beyond.scenes}, {"findings", Json::array()}};
    for (const Finding& one : state.beyond.findings) json["beyond"]["findings"].push_back(to_json(one));
  }
  return json;
}

bool is_failure(const std::string& relation, const std::string& engine, const std::vector<std::string>& claimed) {
  return engine.empty() || relation == kSurvives || std::ranges::find(claimed, relation) != claimed.end();
}

bool no_measure_judged(const Tallies& relations) {
  const auto is_measure = [](const auto& row) { return measure_of(row.first).has_value(); };
  return std::ranges::any_of(relations, is_measure) && std::ranges::none_of(relations, [&](const auto& row) {
           return is_measure(row) && row.second.held + row.second.broken > 0;
         });
}

bool nothing_judged(const Tallies& relations, const std::string& engine, const std::vector<std::string>& claimed) {
  if (no_measure_judged(relations)) return true;
  return std::ranges::none_of(relations, [&](const auto& row) {
    const auto& [name, tally] = row;
    const bool asked = claimed.empty() || std::ranges::find(claimed, name) != claimed.end();
    // An engine that fails in every scene breaks `finishes`, one that reads none breaks `start` too, and no session of
    // it was judged.
    const bool is_failure = name == "finishes" || name == "start";
    const bool told = tally.broken > 0 && (engine.empty() || !is_failure || !claimed.empty());
    return asked && (tally.held > 0 || told);
  });
}

bool nothing_judged(const HuntState& state) { return nothing_judged(state.relations, state.engine, state.claimed); }

std::string judges_error(const HuntState& state) {
  const auto at = std::ranges::find_if(state.findings, [&state](const Finding& one) {
    return is_judges_error(one.relation, one.judging, state.engine);
  });
  if (at == state.findings.end()) return "";
  return "scene " + std::to_string(at->number) + " of seed " + std::to_string(at->seed) + ": " + at->judgement.what +
         ": an error of tumble, which no relation is judged by; kept as " + name_of(*at);
}

bool claims_hold(const HuntState& state) {
  const auto fails = [&state](const Finding& one) { return is_failure(one.relation, state.engine, state.claimed); };
  return std::ranges::none_of(state.findings, fails) && std::ranges::none_of(state.beyond.findings, fails);
}

Status same_hunt(const HuntState& kept, const HuntState& wanted, const std::string& where) {
  const auto differs = [&](const char* what, const std::string& found, const std::string& want) -> Status {
    if (found == want) return {};
    return bad_input(where + ": holds a hunt of another " + what + ": " + found_wanted(found, want) +
                     "; give another --folder, or remove this one");
  };
  if (Status ok = differs("seed", std::to_string(kept.seed), std::to_string(wanted.seed)); !ok.ok()) return ok;
  const auto part = [](const Share& share) { return std::to_string(share.shard) + "/" + std::to_string(share.shards); };
  if (Status ok = differs("shard", part(kept.share), part(wanted.share)); !ok.ok()) return ok;
  if (Status ok = differs("grammar", std::to_string(kept.grammar), std::to_string(wanted.grammar)); !ok.ok()) return ok;
  if (Status ok = differs("program", kept.program, wanted.program); !ok.ok()) return ok;
  if (Status ok = differs("--against", kept.against, wanted.against); !ok.ok()) return ok;
  if (Status ok = differs("--within", joined(kept.within, " "), joined(wanted.within, " ")); !ok.ok()) return ok;
  if (Status ok = differs("engine", kept.engine, wanted.engine); !ok.ok()) return ok;
  if (Status ok = differs(kept.against.empty() ? "build of the engine (its files' hash)"
                                               : "build of the other program (its files' hash)",
                          kept.engine_hash, wanted.engine_hash);
      !ok.ok())
    return ok;
  std::vector<std::string> found, want;
  for (const auto& row : kept.relations) found.push_back(row.first);
  for (const auto& row : wanted.relations) want.push_back(row.first);
  return differs("set of relations", joined(found, " "), joined(want, " "));
}

Result<HuntState> Folder::load() const {
  const std::filesystem::path file = path_ / kStateFile;
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error))) {
    return bad_input(path_.string() + ": holds no " + kStateFile + ", wanted the --folder of a hunt");
  }
  const Result<std::string> text = golden::read_text(file);
  if (!text.ok()) return text.error();
  const auto damaged = [&](const std::string& how) {
    return Error{ErrorKind::kDamaged, file.string() + ": damaged: " + how + "; remove the folder and hunt again"};
  };
  const Json json = Json::parse(*text, nullptr, false);
  try {
    if (json.is_discarded()) return damaged("it is no JSON");
    if (const Json& format = json.at("format"); format != kFormat) {
      return bad_input(file.string() + ": found format " + format.dump() + ", wanted " + std::to_string(kFormat) +
                       "; go on with the program that wrote it, or give another --folder");
    }
    if (const std::string fault = golden::fault_of_seal(*text); !fault.empty()) return damaged(fault);
    HuntState state = state_from(json);
    const std::string fault = fault_of_counts(state);
    return fault.empty() ? Result<HuntState>(std::move(state)) : damaged(fault);
  } catch (const Json::exception& problem) {
    return damaged(problem.what());
  }
}

Result<HuntState> Folder::open(HuntState fresh) const {
  const std::filesystem::path file = path_ / kStateFile;
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return fresh;
  Result<HuntState> kept = load();
  if (!kept.ok()) return kept.error();
  if (kept->merged > 0) {
    return bad_input(file.string() + ": was merged of shards and cannot go on; give another --folder");
  }
  if (Status ok = same_hunt(*kept, fresh, file.string()); !ok.ok()) return ok.error();
  kept->claimed = std::move(fresh.claimed);
  kept->ended = false;
  return kept;
}

Status Folder::keep(const std::filesystem::path& place, Finding& finding) const {
  Result<std::vector<std::string>> names = keep_run(place, path_ / kFindings, name_of(finding));
  if (!names.ok()) return names.error();
  finding.engine_files = *std::move(names);
  return {};
}

Status Folder::write(const Finding& finding, const std::string& drawn, const HuntState& state) const {
  const std::string name = name_of(finding);
  if (Status ok = golden::write_file(path_ / kFindings / (name + ".toml"), drawn); !ok.ok()) return ok;
  if (!finding.shrunk() && finding.relation != kSurvives) return {};
  const std::filesystem::path folder = path_ / "cases" / name;
  const std::string rules = case_rules(finding, state.program, !state.engine.empty());
  if (Status ok = golden::write_file(folder / "metrics.toml", rules); !ok.ok()) return ok;
  return golden::write_file(folder / "scene.toml", finding.shrunk() ? finding.shrunk_text : drawn);
}

Status Folder::save(const HuntState& state) const {
  const std::string text = to_json(state).dump(1, ' ', false, Json::error_handler_t::replace);
  return golden::write_file(path_ / kStateFile, std::string_view(golden::sealed(text)));
}

}  // namespace tumble::hunt
