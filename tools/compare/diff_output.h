#pragma once

#include <optional>
#include <string>

#include "replay/diff/difference_report.h"
#include "tools/compare/session_time.h"
#include "tools/engine/zoom.h"
#include "tools/output/divergence_output.h"
#include "tumble/replay/compare.h"

namespace tumble::tools {

using Difference = std::optional<replay::DifferenceReport>;

/// What `diff` was asked for, as far as it shows in its output.
struct DiffQuestion {
  std::string a;  ///< paths of the logs
  std::string b;
  bool exact_bits = true;  ///< without tolerances
  bool brief = false;
  bool json = false;
  bool zoom = false;
  std::optional<double> apart;  ///< m
  std::string excused;          ///< data that one log alone has, which is no difference as asked; empty: none
};

/// What was found besides the comparison.
struct Further {
  Sides sides;
  std::string read;  ///< the bytes that were read: "every byte of both logs"
  std::optional<Zoom> zoom;
  std::optional<Parting> parting;
};

/// What --brief read: hashes, and states where hashes did not decide.
std::string read_in_brief(const replay::DiffReport& report);

/// Prints the result of `diff` of two logs, as text or as JSON.
void print_result(const DiffQuestion& question, const replay::DiffReport& report, const Difference& difference,
                  const Further& further);

}  // namespace tumble::tools
