#include "golden/bundle/bundle_set.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "golden/bundle/file_hashes.h"
#include "src/base/text.h"
#include "tumble/golden/suite.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLinesMax = 200;

class Problems {
 public:
  void add(const Error& error) {
    if (error.kind == ErrorKind::kDamaged) kind_ = error.kind;
    ++count_;
    if (count_ <= kLinesMax) lines_ += "\n  " + error.message;
  }
  [[nodiscard]] Status status() const {
    if (count_ == 0) return {};
    std::string text =
        "the shards cannot be merged: " + std::to_string(count_) + (count_ == 1 ? " problem" : " problems");
    if (count_ > kLinesMax) text += ", the first " + std::to_string(kLinesMax) + " of which are";
    return Error{kind_, text + ":" + lines_};
  }

 private:
  ErrorKind kind_ = ErrorKind::kBadInput;
  std::size_t count_ = 0;
  std::string lines_;
};

std::string shard_text(std::size_t shard, std::size_t shards) {
  return "shard " + std::to_string(shard) + " of " + std::to_string(shards);
}

std::string label(const Bundle& bundle) {
  return bundle.folder.string() + ": " + shard_text(bundle.manifest.shard, bundle.manifest.shards);
}

std::string options_text(const Manifest& manifest) {
  std::string text;
  for (const auto& [name, value] : manifest.facts.options) {
    if (value.empty()) continue;
    text.append(text.empty() ? "--" : " --").append(name);
    if (value != kGiven) text.append(1, ' ').append(value);
  }
  return text;
}

/// What all shards of a check have in common, and its name in a message.
struct Fact {
  const char* name;
  std::string (*of)(const Manifest& manifest);
};

const Fact kFacts[] = {
    {"number of shards", [](const Manifest& m) { return std::to_string(m.shards); }},
    {"commit", [](const Manifest& m) { return m.run.commit + (m.run.tree == "changed" ? " with changes" : ""); }},
    {"program (its file's hash)", [](const Manifest& m) { return m.facts.program_hash; }},
    {"suite (its files' hash)", [](const Manifest& m) { return m.facts.suite_hash; }},
    {"engine (its files' hash)", [](const Manifest& m) { return m.facts.engine_hash; }},
    {"selection of cases",
     [](const Manifest& m) { return std::to_string(m.selected) + " cases, hash " + m.facts.selected_hash; }},
    {"list of canaries",
     [](const Manifest& m) {
       return std::to_string(m.facts.canaries.size()) + " canaries, hash " + names_hash(m.facts.canaries);
     }},
    {"set of options", options_text},
    {"rule that assigns cases", [](const Manifest& m) { return m.assignment; }},
};

/// The text that most bundles have; of equally many, the first bundle's. A bundle without one has nothing to compare.
std::string usual(const std::vector<Bundle>& bundles, const Fact& fact) {
  std::map<std::string, std::size_t> counts;
  std::string best;
  for (const Bundle& one : bundles) {
    const std::string text = fact.of(one.manifest);
    if (!text.empty()) ++counts[text];
    if (best.empty()) best = text;
  }
  for (const auto& [text, count] : counts) {
    if (count > counts[best]) best = text;
  }
  return best;
}

/// Leaves the bundles that agree in all facts; the first fact in which another differs is a problem of it.
std::vector<Bundle> of_one_check(std::vector<Bundle> bundles, Problems& problems) {
  for (const Fact& fact : kFacts) {
    if (bundles.empty()) break;
    const std::string wanted = usual(bundles, fact);
    std::erase_if(bundles, [&](const Bundle& one) {
      const std::string found = fact.of(one.manifest);
      if (found == wanted || found.empty()) return false;
      problems.add(bad_input(label(one) + ": of another " + fact.name + ": " + found_wanted(found, wanted) +
                             "; run that shard again as the others were run"));
      return true;
    });
  }
  return bundles;
}

/// The bundles by shard; one that is there again is a problem.
std::map<std::size_t, const Bundle*> by_shard(const std::vector<Bundle>& bundles, Problems& problems) {
  std::map<std::size_t, const Bundle*> found;
  for (const Bundle& one : bundles) {
    const auto [at, is_new] = found.emplace(one.manifest.shard, &one);
    if (is_new) continue;
    problems.add(bad_input(label(one) + ": is there twice: " + at->second->folder.string() +
                           " holds it too; leave one of them out"));
  }
  return found;
}

/// Whether a file is one that a failed case of these left; names: in order.
bool is_left_of(const std::vector<std::string>& names, const std::string& file) {
  const fs::path path(file);
  return std::distance(path.begin(), path.end()) == 3 && *path.begin() == "cases" &&
         std::ranges::binary_search(names, std::next(path.begin())->string());
}

/// The cases and the canaries of a bundle against the rule that assigns them, and against what was judged. Where all
/// bundles pass, each canary was asked once: they agree in the list of all, and its names differ.
Status check_cases(const Bundle& bundle) {
  const Manifest& m = bundle.manifest;
  const auto damaged = [&](const std::string& how) {
    return Error{ErrorKind::kDamaged, label(bundle) + ": " + how + "; run that shard again"};
  };
  for (const std::string& name : m.facts.expected) {
    const std::size_t owner = shard_of_name(name, m.shards);
    if (owner != m.shard) return damaged("holds the case " + in_quotes(name) + " of shard " + std::to_string(owner));
  }
  if (m.judged != m.facts.expected) {
    return damaged(std::to_string(m.facts.expected.size()) + " cases fell to it and " +
                   std::to_string(m.judged.size()) + " are judged, wanted the same cases");
  }
  std::vector<std::string> canaries;
  for (const std::string& name : m.facts.canaries) {
    if (shard_of_name(name, m.shards) == m.shard) canaries.push_back(name);
  }
  if (m.canaries != canaries) {
    return damaged(count_text(canaries.size(), "canary") + " fell to it and " + std::to_string(m.canaries.size()) +
                   " were asked, wanted the same canaries");
  }
  for (const BundleFile& file : m.files) {
    if (file.path != kReportFile && !is_left_of(m.judged, file.path)) {
      return damaged("names the file " + in_quotes(file.path) + ", wanted cases/NAME/FILE of one of its cases");
    }
  }
  if (std::ranges::find(m.files, kReportFile, &BundleFile::path) == m.files.end()) {
    return damaged(std::string("does not name its ") + kReportFile);
  }
  return {};
}

Status check_files(const Bundle& bundle) {
  for (const BundleFile& wanted : bundle.manifest.files) {
    const fs::path path = bundle.folder / wanted.path;
    const auto damaged = [&](const std::string& how) {
      return Error{ErrorKind::kDamaged, label(bundle) + ": " + wanted.path + ": " + how + "; run that shard again"};
    };
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (!fs::exists(status)) return damaged("is missing");
    const fs::path place = fs::canonical(bundle.folder, error) / wanted.path;
    if (!fs::is_regular_file(status) || fs::canonical(path, error) != place) {
      return damaged("is a link or no file, wanted the file that the shard wrote");
    }
    const Result<FileHash> found = hash_file(path);
    if (!found.ok()) return damaged(found.error().message);
    if (found->bytes != wanted.bytes) {
      return damaged(found_wanted(std::to_string(found->bytes) + " bytes", std::to_string(wanted.bytes)));
    }
    if (found->hash != wanted.hash)
      return damaged("its content has changed: " + found_wanted("hash " + found->hash, wanted.hash));
  }
  return {};
}

/// The cases of all bundles together, against the selection.
Status check_whole(const std::map<std::size_t, const Bundle*>& shards, const Manifest& any) {
  std::vector<std::string> names;
  for (const auto& [number, bundle] : shards) {
    names.insert(names.end(), bundle->manifest.facts.expected.begin(), bundle->manifest.facts.expected.end());
  }
  std::ranges::sort(names);
  if (names.size() == any.selected && names_hash(names) == any.facts.selected_hash) return {};
  return Error{ErrorKind::kDamaged, "all shards together have " + std::to_string(names.size()) +
                                        " cases that are not the " + std::to_string(any.selected) + " selected ones"};
}

}  // namespace

Result<std::vector<Bundle>> open_bundles(const std::vector<fs::path>& folders) {
  Problems problems;
  std::vector<Bundle> bundles;
  for (const fs::path& folder : folders) {
    Result<Manifest> manifest = read_manifest(folder);
    if (manifest.ok()) {
      bundles.push_back({folder, *std::move(manifest)});
    } else {
      problems.add(manifest.error());
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> claimed;  // by bundles that are of use or a problem of their own
  for (const Bundle& one : bundles) claimed.emplace(one.manifest.shard, one.manifest.shards);
  bundles = of_one_check(std::move(bundles), problems);
  const std::map<std::size_t, const Bundle*> shards = by_shard(bundles, problems);
  for (const auto& [number, bundle] : shards) {
    if (Status ok = check_cases(*bundle); !ok.ok()) problems.add(ok.error());
    if (Status ok = check_files(*bundle); !ok.ok()) problems.add(ok.error());
  }
  if (bundles.empty()) {
    problems.add(bad_input("no folder holds a bundle that can be read"));
    return problems.status().error();
  }
  const Manifest& any = bundles.front().manifest;
  for (std::size_t k = 1; k <= any.shards; ++k) {
    if (claimed.contains({k, any.shards})) continue;
    problems.add(bad_input(shard_text(k, any.shards) +
                           ": is missing: none of the folders holds it; run it with --shard " + std::to_string(k) +
                           '/' + std::to_string(any.shards)));
  }
  if (problems.status().ok()) {
    if (Status ok = check_whole(shards, any); !ok.ok()) problems.add(ok.error());
  }
  if (Status ok = problems.status(); !ok.ok()) return ok.error();
  std::ranges::sort(bundles, {}, [](const Bundle& one) { return one.manifest.shard; });
  return bundles;
}

}  // namespace tumble::golden
