#include "tools/hunt/hunt_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "golden/hunt/apart/apart_bounds.h"
#include "golden/hunt/judge/relation.h"

namespace tumble::tools {
namespace {

constexpr std::size_t kNumbersShown = 8;

std::string size_text(const hunt::FindingGroup& group) {
  return group.decade == 0 ? "" : ", beyond its bound 10^" + std::to_string(group.decade) + " times or more";
}

void print_group(const hunt::FindingGroup& group, const std::string& folder) {
  std::cout << "\n"
            << group.relation << (group.phase.empty() ? "" : ", phase " + group.phase) << size_text(group) << ": "
            << count_text(group.findings.size(), "scene") << '\n';
  const hunt::Finding& best = *group.findings.front();
  if (best.shrunk()) {
    std::cout << "  smallest: " << count_text(best.bodies, "body") << ", " << count_text(best.steps, "step")
              << (best.least ? "" : ", not yet the least") << ": " << printable(describe(best.shrunk_judgement))
              << '\n';
    if (!folder.empty()) std::cout << "  " << folder << "/cases/" << name_of(best) << "/scene.toml\n";
  } else {
    std::cout << "  " << printable(describe(best.judgement)) << '\n';
  }
  for (const std::string& file : best.engine_files) {
    std::cout << "  of scene " << best.number << " the engine "
              << (file.find(".said.txt") == std::string::npos ? "wrote" : "printed") << ": " << folder << "/findings/"
              << file << '\n';
  }
  std::cout << "  scenes";
  for (std::size_t k = 0; k < std::min(group.findings.size(), kNumbersShown); ++k) {
    std::cout << ' ' << group.findings[k]->number;
  }
  std::cout << (group.findings.size() > kNumbersShown ? " …\n" : "\n");
}

// claimed: of an engine; null: all are.
void print_tallies(const hunt::Tallies& relations, const std::vector<std::string>* claimed) {
  std::vector<std::string> head = {"RELATION", ">HELD", ">BROKEN", ">NOT JUDGED", ">NEAREST", "SCENE"};
  if (claimed != nullptr) head.insert(head.begin() + 1, "CLAIMED");
  Table table(head);
  for (const auto& [name, tally] : relations) {
    const bool near = tally.nearest.value_or(0) > 0;
    std::vector<std::string> row = {name,
                                    std::to_string(tally.held),
                                    std::to_string(tally.broken),
                                    std::to_string(tally.not_applicable),
                                    near ? fixed(100 * *tally.nearest, 0) + " %" : "",
                                    near ? std::to_string(tally.nearest_number) : ""};
    if (claimed != nullptr)
      row.insert(row.begin() + 1, std::ranges::find(*claimed, name) != claimed->end() ? "yes" : "");
    table.add(row);
  }
  table.print();
}

// The claims that no scene could be judged by; empty: each was.
std::string claims_not_judged(const hunt::Tallies& relations, const std::vector<std::string>& claimed) {
  std::string names;
  for (const auto& [name, tally] : relations) {
    if (std::ranges::find(claimed, name) == claimed.end() || tally.held + tally.broken > 0) continue;
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

bool reached_an_end(const hunt::Tallies& relations) {
  return std::ranges::any_of(relations, [](const auto& row) { return row.first == "finishes" && row.second.held > 0; });
}

constexpr const char* kNoClaimJudged = "no scene could be judged by what the engine claims: ";
constexpr const char* kNoMeasureJudged = "no scene has a value that a bound of --within could judge";
constexpr const char* kNoEndReached = "the engine came to the end of no scene that it could be judged by; ";

void print_claims_not_judged(const hunt::Tallies& relations, const std::vector<std::string>& claimed) {
  if (const std::string names = claims_not_judged(relations, claimed); !names.empty())
    std::cout << "\nno scene could be judged by these claims: " << names << '\n';
}

std::string why_nothing(const hunt::HuntState& state, std::optional<std::uint64_t> count) {
  if (state.next == 0) {
    if (state.merged > 0) return "the shards hold no scene";
    if (!state.ended) return "the hunt was interrupted before a scene was judged";
    if (count && state.share.of(*count) == 0) return "none of " + count_text(*count, "scene") + " is the shard's";
    return "the time ended before a scene was judged";
  }
  if (state.refused == state.next)
    return "the engine refused each of " + count_text(state.next, "scene") + ", " + state.refusal;
  const auto fails = std::ranges::find(state.findings, "finishes", &hunt::Finding::relation);
  if (!state.engine.empty() && fails != state.findings.end() && !reached_an_end(state.relations)) {
    return kNoEndReached + ("scene " + std::to_string(fails->number)) + ": " + describe(fails->judgement);
  }
  if (!state.claimed.empty()) return kNoClaimJudged + claims_not_judged(state.relations, state.claimed);
  if (hunt::no_measure_judged(state.relations)) return kNoMeasureJudged;
  return "no relation or law could be asked of any scene";
}

std::string why_nothing(const hunt::CorpusResult& result) {
  const std::string all = count_text(result.scenes, "scene");
  if (result.refused == result.scenes) return "the engine refused each of " + all + ", " + result.refusal;
  const auto fails = std::ranges::find(result.broken, "finishes", &hunt::CorpusResult::Broken::relation);
  if (!result.engine.empty() && fails != result.broken.end() && !reached_an_end(result.relations))
    return kNoEndReached + fails->file + ": " + describe(fails->judgement);
  if (!result.claimed.empty()) return kNoClaimJudged + claims_not_judged(result.relations, result.claimed);
  if (hunt::no_measure_judged(result.relations)) return kNoMeasureJudged;
  return "no relation or law could be asked of any of " + all;
}

}  // namespace

std::string nothing_judged_text(const hunt::HuntState& state, std::optional<std::uint64_t> count) {
  return "nothing was judged: " + printable(why_nothing(state, count));
}

std::string nothing_judged_text(const hunt::CorpusResult& result) {
  return "nothing was judged: " + printable(why_nothing(result));
}

void print_finding(const hunt::Finding& finding) {
  std::cout << finding.relation << ", scene " << finding.number << " (" << finding.kind
            << "): " << printable(describe(finding.judgement)) << '\n';
}

namespace {

void print_beyond(const hunt::Beyond& beyond) {
  if (beyond.scenes == 0) return;
  std::cout
      << '\n'
      << count_text(beyond.scenes, "scene")
      << " behind these were judged too and do not count: the time ended before a scene between. A hunt that goes "
         "on judges them again.\n";
  for (const hunt::Finding& one : beyond.findings) {
    std::cout << "  ";
    print_finding(one);
  }
}

}  // namespace

void print_hunt(const hunt::HuntState& state, const std::string& folder) {
  std::cout << "\nseed " << state.seed << ", " << count_text(state.next, "scene") << ", " << state.program;
  if (state.share.shards > 1) std::cout << ", shard " << state.share.shard << " of " << state.share.shards;
  if (!state.against.empty()) std::cout << ", against " << state.against;
  for (std::size_t k = 0; k < state.within.size(); ++k) std::cout << (k == 0 ? " within " : " ") << state.within[k];
  if (!state.engine.empty()) std::cout << ", of the engine `" << printable(state.engine) << '`';
  if (state.no_scenes > 0) std::cout << "; no world could be made of " << state.no_scenes;
  if (state.refused > 0) std::cout << "; the engine refused " << state.refused << ", " << printable(state.refusal);
  std::cout << "\n\n";
  print_tallies(state.relations, state.engine.empty() ? nullptr : &state.claimed);
  for (const hunt::FindingGroup& group : hunt::grouped(state.findings)) print_group(group, folder);
  print_beyond(state.beyond);
  if (nothing_judged(state)) return;
  print_claims_not_judged(state.relations, state.claimed);
  if (!state.findings.empty() || !state.beyond.findings.empty()) return;
  std::cout << "\nno scene broke a relation that it was judged by\n";
}

void print_corpus(const hunt::CorpusResult& result) {
  print_tallies(result.relations, result.engine.empty() ? nullptr : &result.claimed);
  if (nothing_judged(result)) return;
  std::cout << '\n' << count_text(result.scenes, "scene") << ", " << result.broken.size() << " broken\n";
  if (result.refused > 0)
    std::cout << "the engine refused " << result.refused << ", " << printable(result.refusal) << '\n';
  for (const hunt::CorpusResult::Broken& one : result.broken) {
    std::cout << printable(one.file) << ": " << one.relation << ": " << printable(describe(one.judgement)) << '\n';
  }
  print_claims_not_judged(result.relations, result.claimed);
}

namespace {

constexpr const char* kClaimOfAgainst =
    "--against PROGRAM computes the same bits; with --within: takes the scene to its end too";

std::string claim_of(const hunt::ApartBound& bound) {
  const std::string unit = unit_of(bound);
  std::string text =
      "--within bounds: " + to_text(bound) + (bound.amount > 0 && !unit.empty() ? " (" + unit + ")" : "");
  return text + (bound.measure == hunt::kPlace ? ", before the first contact" : "");
}

}  // namespace

void print_relations() {
  Table table({"NAME", "CLAIM"});
  for (const hunt::Relation& one : hunt::relations()) table.add({one.name, one.claim});
  table.add({hunt::kAgainst, kClaimOfAgainst});
  for (const hunt::ApartBound& bound : hunt::usual_bounds()) table.add({relation_of(bound), claim_of(bound)});
  table.print();
}

Json relations_json() {
  Json json = Json::array();
  for (const hunt::Relation& one : hunt::relations()) {
    json.push_back({{"name", one.name}, {"claim", one.claim}, {"kind", one.is_law ? "law" : "relation"}});
  }
  json.push_back({{"name", hunt::kAgainst}, {"claim", kClaimOfAgainst}, {"kind", "relation"}});
  for (const hunt::ApartBound& bound : hunt::usual_bounds())
    json.push_back({{"name", relation_of(bound)}, {"claim", claim_of(bound)}, {"kind", "bound"}});
  return json;
}

}  // namespace tumble::tools
