#include "tools/bench/peer_programs.h"

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "golden/suite/text_files.h"
#include "src/process/run_child.h"
#include "tools/bench/bench.h"

namespace tumble::tools {

namespace fs = std::filesystem;

std::vector<Peer> built_peers(const std::vector<std::string>& words) {
  std::vector<Peer> peers;
  for (const std::string& word : words) {
    Peer peer{word, build_folder() + "/bench/peers/tumble_peer_", {}};
    peer.program += peer.is_ours() ? "tumble" : word;
    if (peer.is_ours()) peer.overrides = {"world.method=" + word};
    std::error_code error;
    if (fs::exists(peer.program, error)) peers.push_back(std::move(peer));
  }
  return peers;
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
  if (end->well() && !json.is_discarded()) return json;
  return cannot_finish(end->text() + (said.ok() && !said->empty() ? ": " + *said : ""));
}

}  // namespace tumble::tools
