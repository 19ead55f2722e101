#include "tools/arguments/kept_arguments.h"

namespace tumble::tools {

void add_kept(Arguments& arguments, KeptArguments& target) {
  arguments
      .option("--states", "MODE", target.states,
              "States in the log: all (if not given), every:N (one step in N) or hashes (none); the others "
              "can be simulated again")
      .offers({"all", "every:2", "hashes"});
  arguments
      .option("--hashes", "MODE", target.hashes,
              "Hashes of phases in the log: all (if not given), every:N (one step in N) or states (none, only "
              "the hash of each state); diff and replay tell what they could not compare")
      .offers({"all", "every:2", "states"});
}

Result<Kept> parse_kept(const KeptArguments& arguments) {
  const Result<replay::StatesMode> states = replay::parse_states_mode(arguments.states);
  if (!states.ok()) return bad_input("--" + states.error().message);
  const Result<replay::HashesMode> hashes = replay::parse_hashes_mode(arguments.hashes);
  if (!hashes.ok()) return bad_input("--" + hashes.error().message);
  return Kept{*states, *hashes};
}

}  // namespace tumble::tools
