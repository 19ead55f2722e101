#include "tools/bench/peer_programs.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/run_child.h"
#include "tools/bench/bench.h"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kHowToBuild =
    "; 'tools/setup.sh --only peers' installs what it needs, the target bench/all builds it";

Peer peer_of(const std::string& word) {
  Peer peer{word, build_folder() + "/bench/peers/tumble_peer_", {}};
  peer.program += peer.is_ours() ? "tumble" : word;
  if (peer.is_ours()) peer.overrides = {"world.method=" + word};
  return peer;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

Status check_words(const std::vector<std::string>& known, const std::vector<std::string>& asked) {
  for (const std::string& word : asked) {
    if (word == "none" || has(known, word)) continue;
    std::string wanted;
    for (const std::string& other : known) wanted += other + ", ";
    return bad_input("--engine: found " + in_quotes(word) + ", wanted " + wanted + "or none");
  }
  return {};
}

}  // namespace

Result<PeerChoice> choose_peers(const std::vector<std::string>& known, const std::vector<std::string>& asked) {
  if (Status ok = check_words(known, asked); !ok.ok()) return ok.error();
  PeerChoice choice;
  for (const std::string& word : known) {
    if (!asked.empty() && !has(asked, word)) continue;
    Peer peer = peer_of(word);
    std::error_code error;
    if (fs::exists(peer.program, error)) {
      choice.peers.push_back(std::move(peer));
      continue;
    }
    const std::string why = word + " is not built, there is no " + peer.program + kHowToBuild;
    if (!asked.empty()) return cannot_finish("--engine: " + why);
    std::cerr << "tumble bench: left out: " << why << '\n';
    choice.left_out.push_back(word);
  }
  return choice;
}

std::vector<std::string> peer_command(const Peer& peer, const std::string& scene_path,
                                      const std::vector<std::string>& overrides) {
  std::vector<std::string> words = {peer.program, scene_path};
  for (const std::string& change : overrides) words.insert(words.end(), {"--set", change});
  for (const std::string& change : peer.overrides) words.insert(words.end(), {"--set", change});
  return words;
}

Result<Json> run_for_json(std::vector<std::string> words, const fs::path& folder) {
  process::Program task;
  task.words = std::move(words);
  task.out = (folder / "out.json").string();
  task.err = (folder / "words.txt").string();
  const Result<process::ChildEnd> end = process::run_child(task);
  if (!end.ok()) return end.error();
  const Result<std::string> text = golden::read_text(task.out), said = golden::read_text(task.err);
  Json json = Json::parse(text.ok() ? *text : "", nullptr, false);
  const bool is_result = json.is_object() && json.contains("engine") && json.contains("cpu_s");
  if (end->well() && is_result) return json;
  std::string words_said = said.ok() ? *said : "";
  while (!words_said.empty() && words_said.back() == '\n') words_said.pop_back();
  words_said = printable(replaced(words_said, "\n", "; "));
  if (end->well()) return cannot_finish("printed no result" + (words_said.empty() ? "" : ": " + words_said));
  return cannot_finish(end->text() + (words_said.empty() ? "" : ": " + words_said));
}

Json FailedRuns::json() const {
  Json failures = Json::array();
  for (const auto& [where, why] : all_) failures.push_back({{"run", where}, {"failure", why}});
  return failures;
}

void FailedRuns::print() const {
  for (const auto& [where, why] : all_) std::cout << where << " failed: " << printable(why) << '\n';
}

Status FailedRuns::status() const {
  if (all_.empty()) return {};
  const auto& [where, why] = all_.front();
  return cannot_finish(count_text(all_.size(), "run") + of_ + " failed" + (all_.size() > 1 ? ", first " : ": ") +
                       where + ": " + why + "; the results are those of the other runs");
}

}  // namespace tumble::tools
