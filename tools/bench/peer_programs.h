#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tools/output/text.h"
#include "tumble/sim/result.h"

/// The programs of bench/peers: one engine each, behind one command line.
namespace tumble::tools {

/// One engine, and what its program is given besides a scene.
struct Peer {
  std::string word;                    ///< "layered" and "thesis" (ours), "bullet", "ode", "mujoco"
  std::string program;                 ///< path
  std::vector<std::string> overrides;  ///< of the scene: the method of ours

  [[nodiscard]] bool is_ours() const { return word == "layered" || word == "thesis"; }
};

/// The engines that a benchmark runs, and those that it would have run if their programs were built.
struct PeerChoice {
  std::vector<Peer> peers;
  std::vector<std::string> left_out;
};

/// Of the engines `known` those in `asked`, or all if it is empty, in the order of `known`; "none" asks for no engine.
/// The methods of ours share one program. Says on stderr which of all engines are left out because they are not built.
/// Errors: an engine that is not known (kBadInput), or asked for by name and not built (kCannotFinish).
Result<PeerChoice> choose_peers(const std::vector<std::string>& known, const std::vector<std::string>& asked);

/// The command that runs a scene file through an engine.
std::vector<std::string> peer_command(const Peer& peer, const std::string& scene_path,
                                      const std::vector<std::string>& overrides);

/// Runs a program and reads the JSON that it prints. Errors (kCannotFinish): it failed; with its end and its message.
Result<Json> run_for_json(std::vector<std::string> words, const std::filesystem::path& folder);

/// Runs that failed. A benchmark goes on without them, and does not end well.
class FailedRuns {
 public:
  /// of: for messages, of what the runs are: " of engines".
  explicit FailedRuns(std::string of = "") : of_(std::move(of)) {}
  /// "ode in grid_20".
  void add(const std::string& where, const std::string& why) { all_.emplace_back(where, why); }
  /// [{`run`, `failure`}].
  [[nodiscard]] Json json() const;
  /// For people: a line each.
  void print() const;
  /// Errors (kCannotFinish): the first failure, and how many there are.
  [[nodiscard]] Status status() const;

 private:
  std::string of_;
  std::vector<std::pair<std::string, std::string>> all_;
};

}  // namespace tumble::tools
