#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/arguments/arguments.h"
#include "tools/arguments/measure_arguments.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The arguments of `tumble bisect`, as given.
struct BisectArguments {
  std::vector<std::string> logs;
  std::string good, bad;
  std::string repository;
  bool first_parent = false;
  std::string metric;
  MeasureArguments measure;
  std::string case_name;
  bool image = false;
  std::vector<std::string> build;
  std::string program;
  std::string run;
  std::string scene;
  std::optional<double> timeout;
  std::string work;
  bool resume = false;
  bool keep = false;
  bool automatic = false;
  std::optional<std::uint64_t> asks, jobs;
  std::string cache;
  std::optional<double> cache_gb;
  bool shared = false;
  bool json = false;
};
void declare_arguments(Arguments& arguments, BisectArguments& target);

/// Errors (kBadInput): an option that says how commits are asked, which two logs have no use for.
Status check_for_logs(const BisectArguments& options);

/// Errors (kBadInput): arguments that are missing, that do not go together, or that would be passed over.
Status check_for_commits(const BisectArguments& options);

}  // namespace tumble::tools
