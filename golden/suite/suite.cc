#include "tumble/golden/suite.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "golden/suite/parse_rules.h"
#include "golden/suite/text_files.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> kCaseFiles = {kSceneFile, kRulesFile, kExpectedFile};
constexpr std::size_t kNameLengthMax = 100;

/// problems: gets a sentence where the folder could not be listed to its end, so that no case is left out unseen.
std::vector<fs::path> entries_of(const fs::path& folder, std::vector<std::string>& problems) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    entries.push_back(at->path());
  }
  if (error) problems.push_back(folder.string() + ": cannot be listed: " + error.message());
  std::ranges::sort(entries);
  return entries;
}

Error unknown_case(const Suite& suite, const std::string& name) {
  std::vector<std::string_view> names;
  for (const CaseFolder& known : suite.cases) names.push_back(known.name);
  const std::string_view nearest = nearest_word(name, names);
  std::string hint = nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?";
  if (nearest.empty() && !names.empty()) {
    const std::size_t shown = std::min<std::size_t>(names.size(), 8);
    hint = "; it has " + list_text({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown)});
    if (names.size() > shown) hint += " and " + std::to_string(names.size() - shown) + " more";
  }
  return bad_input("no case " + in_quotes(name) + " in " + (suite.root / "cases").string() + hint);
}

/// Whether an entry of a case's folder is one of its engine's files, or a folder with some of them.
bool belongs_to(const std::vector<std::string>& files, const std::string& entry) {
  return std::ranges::any_of(files, [&](const std::string& file) {
    const fs::path path = fs::path(file).lexically_normal();
    return !path.empty() && path.begin()->string() == entry;
  });
}

/// A case whose scene cannot be read belongs to every category: its failure must not hide.
bool is_in_category(const CaseFolder& folder, const std::string& category) {
  if (const std::optional<EngineCase> engine = engine_case(folder)) return engine->category == category;
  const Result<std::string> text = read_text(folder.file(kSceneFile));
  if (!text.ok()) return true;
  const Result<sim::SceneDef> scene = scenes::parse_scene(*text, folder.file(kSceneFile).string());
  return !scene.ok() || scene->category == category;
}

}  // namespace

std::optional<EngineCase> engine_case(const CaseFolder& folder) {
  Result<CaseRules> rules = read_rules(folder.file(kRulesFile));
  return rules.ok() ? std::move(rules->engine) : std::nullopt;
}

Result<Suite> open_suite(const fs::path& root) {
  std::error_code error;
  const fs::path cases = root / "cases";
  if (!fs::is_directory(cases, error)) {
    return bad_input(root.string() + ": found no folder \"cases\" in it, wanted a suite");
  }
  Suite suite{.root = root, .cases = {}, .problems = {}};
  for (const fs::path& entry : entries_of(cases, suite.problems)) {
    if (fs::is_directory(entry, error)) {
      suite.cases.push_back({entry.filename().string(), entry});
    } else {
      suite.problems.push_back(entry.string() + ": belongs to no case; remove it or give it a folder");
    }
  }
  if (suite.cases.empty() && !suite.problems.empty()) return bad_input(suite.problems.front());
  if (suite.cases.empty()) return bad_input(cases.string() + ": found no case, wanted a folder for each");
  return suite;
}

// A name that began with '-' would be an option in every command that a report prints.
Status check_case_name(const std::string& name) {
  const bool begins = !name.empty() && !name.starts_with('-');
  const bool right =
      begins && name.size() <= kNameLengthMax && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
      });
  if (right) return {};
  return bad_input("found " + in_quotes(name) +
                   " as a case's name, wanted letters, digits, '_' and '-', and no '-' first");
}

std::vector<std::string> folder_problems(const CaseFolder& folder) {
  std::vector<std::string> problems;
  std::error_code error;
  const std::optional<EngineCase> engine = engine_case(folder);
  // Rules that cannot be read, which the case's run reports, may be those of an engine.
  const bool may_lack_scene =
      engine || (fs::exists(folder.file(kRulesFile), error) && !read_rules(folder.file(kRulesFile)).ok());
  std::vector<std::string> own_files = engine ? engine->all_files() : std::vector<std::string>();
  if (const Result<CaseRules> rules = read_rules(folder.file(kRulesFile)); rules.ok()) {
    for (const MetricRule& rule : rules->metrics) own_files.push_back(rule.against);
  }
  for (const char* wanted : kCaseFiles) {
    if (fs::exists(folder.file(wanted), error) || (may_lack_scene && std::string_view(wanted) == kSceneFile)) {
      continue;
    }
    const bool by_bless = std::string_view(wanted) == kExpectedFile;
    problems.push_back(std::string("no ") + wanted + (by_bless ? ": bless the case" : ": a case needs one"));
  }
  // They may name any file of the folder.
  if (fs::exists(folder.file(kRulesFile), error) && !read_rules(folder.file(kRulesFile)).ok()) return problems;
  for (const fs::path& entry : entries_of(folder.path, problems)) {
    const std::string name = entry.filename().string();
    if (std::ranges::find(kCaseFiles, name) != kCaseFiles.end() || is_picture_name(name)) continue;  // judged with them
    if (belongs_to(own_files, name)) continue;
    problems.push_back("unreferenced: nothing reads " + name + "; remove it");
  }
  return problems;
}

Result<std::vector<CaseFolder>> select_cases(const Suite& suite, const Selection& selection) {
  std::vector<CaseFolder> chosen;
  for (const std::string& name : selection.names) {
    const auto found = std::ranges::find(suite.cases, name, &CaseFolder::name);
    if (found == suite.cases.end()) return unknown_case(suite, name);
    if (std::ranges::find(chosen, name, &CaseFolder::name) == chosen.end()) chosen.push_back(*found);
  }
  if (selection.names.empty()) chosen = suite.cases;
  if (!selection.category.empty()) {
    std::erase_if(chosen, [&](const CaseFolder& folder) { return !is_in_category(folder, selection.category); });
    if (chosen.empty() && !selection.names.empty()) {
      return bad_input("found no case of category " + in_quotes(selection.category) + " among those named: " +
                       joined(selection.names, ", ") + "; without names every case of the category is chosen");
    }
    if (chosen.empty()) {
      return bad_input("found no case of category " + in_quotes(selection.category) + " in " +
                       (suite.root / "cases").string() + "; 'category' in a case's scene.toml names it");
    }
  }
  std::ranges::sort(chosen, {}, &CaseFolder::name);
  return chosen;
}

std::size_t shard_of_name(std::string_view name, std::size_t shards) {
  return 1 + static_cast<std::size_t>(hash_bytes(std::as_bytes(std::span(name))).low % shards);
}

std::vector<CaseFolder> shard_of(const std::vector<CaseFolder>& selected, const Selection& selection) {
  SIM_CHECK(selection.shard >= 1 && selection.shard <= selection.shards, selection.shard, selection.shards);
  std::vector<CaseFolder> shard;
  for (const CaseFolder& folder : selected) {
    if (shard_of_name(folder.name, selection.shards) == selection.shard) shard.push_back(folder);
  }
  return shard;
}

}  // namespace tumble::golden
