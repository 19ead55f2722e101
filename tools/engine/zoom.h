#pragma once

#include <cstdint>
#include <string>

#include "replay/probe/compare_probes.h"
#include "replay/probe/probe_file.h"
#include "tools/output/divergence_output.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The programs that compute the sessions of two logs again. For another engine's log: a folder with a tumble.toml,
/// that file, or a command line with {log}; empty: the nearest tumble.toml. For a log of ours: a program `tumble`;
/// empty: this one.
struct ZoomPrograms {
  std::string a;
  std::string b;
};

/// One step of two sessions, computed again with probes.
struct Zoom {
  std::uint64_t step = 0;
  bool after_inputs =
      false;  ///< inputs of an earlier step are the first difference; this step has the first other hash
  replay::ProbeFile a, b;
  replay::ProbeComparison compared;
  std::string command_a, command_b;
  /// The first step in which a program's new session differs from its own log; empty: none up to `step`.
  std::string stray_a, stray_b;
};

/// Runs both programs with probes in the step of the first difference alone, and compares the probes. Where that is one
/// of inputs, the step is the first from there on whose phases or state differ. Errors: a program that cannot be run,
/// no probes in that step, a step before the first of a log, inputs that changed nothing (kBadInput).
Result<Zoom> zoom_into(replay::LogReader& a, replay::LogReader& b, const replay::Divergence& first,
                       const ZoomPrograms& programs);

/// Prints the first probe that differs, with its place, and the probes just before that are the same.
void print_zoom(const Zoom& zoom, const Sides& sides);
Json zoom_json(const Zoom& zoom);

}  // namespace tumble::tools
