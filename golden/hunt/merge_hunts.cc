#include "golden/hunt/merge_hunts.h"

#include <algorithm>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include "src/base/text.h"

namespace tumble::hunt {
namespace {

namespace fs = std::filesystem;

struct Part {
  fs::path folder;
  HuntState state;
};

std::string shard_text(const Share& share) {
  return "shard " + std::to_string(share.shard) + " of " + std::to_string(share.shards);
}

/// The hunts by shard. A folder that cannot be used is a line of `problems`.
std::map<std::uint64_t, Part> by_shard(const std::vector<fs::path>& folders, std::vector<Error>& problems) {
  std::map<std::uint64_t, Part> parts;
  for (const fs::path& folder : folders) {
    Result<HuntState> state = Folder(folder).load();
    if (!state.ok()) {
      problems.push_back(state.error());
      continue;
    }
    const std::string where = folder.string() + ": " + shard_text(state->share);
    if (!state->ended) {
      problems.push_back(bad_input(where + ": is not at its end: " + std::to_string(state->next) +
                                   " scenes are judged; run that shard again, it goes on from there"));
    }
    if (!parts.empty()) {
      HuntState wanted = parts.begin()->second.state;
      wanted.share.shard = state->share.shard;
      if (Status same = same_hunt(*state, wanted, where); !same.ok()) {
        problems.push_back(same.error());
        continue;
      }
    }
    const auto [at, is_new] = parts.emplace(state->share.shard, Part{folder, *state});
    if (is_new) continue;
    problems.push_back(
        bad_input(where + ": is there twice: " + at->second.folder.string() + " holds it too; leave one of them out"));
  }
  return parts;
}

Status all_there(const std::vector<fs::path>& folders, std::map<std::uint64_t, Part>& parts) {
  std::vector<Error> problems;
  parts = by_shard(folders, problems);
  const std::uint64_t shards = parts.empty() ? 0 : parts.begin()->second.state.share.shards;
  for (std::uint64_t k = 1; k <= shards; ++k) {
    if (parts.contains(k)) continue;
    problems.push_back(
        bad_input(shard_text({k, shards}) +
                  ": is missing: none of the folders holds one that can be merged; run it with --shard " +
                  std::to_string(k) + '/' + std::to_string(shards)));
  }
  if (problems.empty() && parts.empty())
    return bad_input("--merge: found no folder, wanted the --folder of every shard");
  if (problems.empty()) return {};
  Error all{ErrorKind::kBadInput, "the hunts cannot be merged: " + std::to_string(problems.size()) +
                                      (problems.size() == 1 ? " problem:" : " problems:")};
  for (const Error& one : problems) {
    if (one.kind == ErrorKind::kDamaged) all.kind = one.kind;
    all.message += "\n  " + one.message;
  }
  return all;
}

Status copy_files(const fs::path& from, const fs::path& to) {
  for (const char* name : {"findings", "cases"}) {
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(from / name, error))) continue;
    fs::create_directories(to / name, error);
    const auto how =
        fs::copy_options::recursive | fs::copy_options::skip_symlinks | fs::copy_options::overwrite_existing;
    fs::copy(from / name, to / name, how, error);
    if (error) return cannot_finish((to / name).string() + ": cannot be written: " + error.message());
  }
  return {};
}

}  // namespace

Result<HuntState> merge_hunts(const std::vector<fs::path>& folders, const fs::path& out) {
  std::map<std::uint64_t, Part> parts;
  if (Status ok = all_there(folders, parts); !ok.ok()) return ok.error();
  std::error_code error;
  if (fs::exists(fs::symlink_status(out / kStateFile, error)))
    return bad_input(out.string() + ": holds a hunt; give another --folder, or remove this one");
  HuntState sum = parts.begin()->second.state;
  sum.share = {};
  sum.merged = parts.size();
  sum.next = sum.no_scenes = 0;
  sum.findings.clear();
  for (auto& [name, tally] : sum.relations) tally = {};
  for (const auto& [k, part] : parts) {
    sum.next += part.state.next;
    sum.no_scenes += part.state.no_scenes;
    for (std::size_t i = 0; i < sum.relations.size(); ++i) sum.relations[i].second.add(part.state.relations[i].second);
    sum.findings.insert(sum.findings.end(), part.state.findings.begin(), part.state.findings.end());
    if (Status ok = copy_files(part.folder, out); !ok.ok()) return ok.error();
  }
  std::ranges::stable_sort(sum.findings, {}, &Finding::number);
  if (Status ok = Folder(out).save(sum); !ok.ok()) return ok.error();
  return sum;
}

}  // namespace tumble::hunt
