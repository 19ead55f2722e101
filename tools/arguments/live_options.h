#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/arguments/arguments.h"

namespace tumble::tools {

/// The arguments of `tumble live`, as given. The program `tumble` and its helper `tumble-live` read the same.
struct LiveArguments {
  std::string scene, from, log;
  bool no_inputs = false;
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> threads, samples;
  bool even = false;
  std::string states = "all", size = "960x600", effects = "all";
  std::optional<double> measure;  ///< s
  bool json = false;
};
void declare_arguments(Arguments& arguments, LiveArguments& target);

/// The command line that gives equal arguments.
std::vector<std::string> words_of(const LiveArguments& arguments);

}  // namespace tumble::tools
