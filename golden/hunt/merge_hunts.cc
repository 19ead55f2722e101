#include "golden/hunt/merge_hunts.h"

#include <algorithm>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include "src/base/text.h"
#include "src/files/file_lock.h"

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

/// Why a shard cannot be a part of a whole hunt; empty: it can. Its end is that of its --count: what a time ends has
/// other scenes on another day.
std::string fault_of_end(const HuntState& state) {
  if (!state.count) return "was ended by --time alone, wanted the --count of all shards; run it again with --count";
  const std::uint64_t wanted = state.share.of(*state.count);
  if (state.ended && state.next == wanted) return "";
  return "is not at its end: " + std::to_string(state.next) + " scenes of " + std::to_string(wanted) +
         " are judged; run that shard again, it goes on from there";
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
    if (const std::string fault = fault_of_end(*state); !fault.empty()) {
      problems.push_back(bad_input(std::string(where).append(": ").append(fault)));
    }
    if (!parts.empty()) {
      HuntState wanted = parts.begin()->second.state;
      wanted.share.shard = state->share.shard;
      if (Status same = same_hunt(*state, wanted, where); !same.ok()) {
        problems.push_back(same.error());
        continue;
      }
      if (state->count && wanted.count && state->count != wanted.count) {
        std::string other = where;
        other += ": is of a hunt of another --count: ";
        other += found_wanted(std::to_string(*state->count), std::to_string(*wanted.count));
        other += "; run all shards with one --count";
        problems.push_back(bad_input(other));
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
  const Result<files::FolderLock> lock = files::FolderLock::take(out, kLockFile, "a hunt");
  if (!lock.ok()) return lock.error();
  std::error_code error;
  if (fs::exists(fs::symlink_status(out / kStateFile, error)))
    return bad_input(out.string() + ": holds a hunt; give another --folder, or remove this one");
  HuntState sum = parts.begin()->second.state;
  sum.share = {};
  sum.merged = parts.size();
  sum.next = sum.no_scenes = sum.refused = 0;
  sum.refusal.clear();
  sum.findings.clear();
  for (auto& [name, tally] : sum.relations) tally = {};
  for (const auto& [k, part] : parts) {
    sum.next += part.state.next;
    sum.no_scenes += part.state.no_scenes;
    sum.refused += part.state.refused;
    if (sum.refusal.empty()) sum.refusal = part.state.refusal;
    for (std::size_t i = 0; i < sum.relations.size(); ++i) sum.relations[i].second.add(part.state.relations[i].second);
    sum.findings.insert(sum.findings.end(), part.state.findings.begin(), part.state.findings.end());
    if (Status ok = copy_files(part.folder, out); !ok.ok()) return ok.error();
  }
  std::ranges::stable_sort(sum.findings, {}, &Finding::number);
  if (Status ok = Folder(out).save(sum); !ok.ok()) return ok.error();
  return sum;
}

}  // namespace tumble::hunt
