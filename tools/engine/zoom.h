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
  replay::ProbeFile a, b;
  replay::ProbeComparison compared;
  std::string command_a, command_b;
  /// The first step in which a program's new session differs from its own log; empty: none up to `step`.
  std::string stray_a, stray_b;
};

/// Runs both programs with probes in that step alone, and compares the probes. Errors: a program that cannot be run, no
/// probes in that step, a step before the first of a log (kBadInput).
Result<Zoom> zoom_into(replay::LogReader& a, replay::LogReader& b, std::uint64_t step, const ZoomPrograms& programs);

/// Prints the first probe that differs, with its place, and the probes just before that are the same.
void print_zoom(const Zoom& zoom, const Sides& sides);
Json zoom_json(const Zoom& zoom);

}  // namespace tumble::tools
