#pragma once

#include <string>

#include "tools/arguments/arguments.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

/// The arguments of `record` that say what the log holds of each step.
namespace tumble::tools {

struct KeptArguments {
  std::string states = "all";
  std::string hashes = "all";
};

struct Kept {
  replay::StatesMode states;
  replay::HashesMode hashes;
};

/// Declares `--states` and `--hashes`.
void add_kept(Arguments& arguments, KeptArguments& target);

/// Errors (kBadInput): an unknown word, or a number that is none.
Result<Kept> parse_kept(const KeptArguments& arguments);

}  // namespace tumble::tools
