#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/engine/table_reading.h"
#include "replay/measure/measure_options.h"
#include "replay/measure/metric_bound.h"

namespace tumble::tools::bisect {

/// The question to every revision, and the way in which a revision becomes a program. Paths are absolute.
struct Settings {
  std::string repository;
  std::string good;  ///< revisions, as git names them; empty: one is looked for, back from the bad one
  std::string bad;
  bool first_parent = false;

  // The question. Without metric and case: whether a replay of the log agrees in every bit.
  std::string log;                            ///< the session; may be empty where a case is asked about
  std::string log_hash;                       ///< of that file: answers are about what it held
  std::optional<replay::MetricBound> metric;  ///< whether the session, recorded anew, is within this bound
  replay::MeasureOptions measure;             ///< for the metric
  std::string case_name;                      ///< whether the revision's own check of this golden case passes
  bool image = false;                         ///< of the case: the image verdict alone

  std::vector<std::string> build;     ///< command lines, run in the revision's source folder
  std::string program;                ///< that they make: a path from that folder
  std::string run;                    ///< instead of the program: a command line of an engine that writes {log}
  std::string engine_folder;          ///< in which build and run work: a path from the clone's own
  std::string engine_scene;           ///< {scene} where the log has no text of one: a path from engine_folder
  std::string scene;                  ///< {scene} of every revision, whatever the log has: an absolute path, or empty
  std::string scene_hash;             ///< of that file
  golden::TableReading engine_table;  ///< of what the engine writes
  bool shell = false;                 ///< build and run are given to sh
  bool has_project = false;           ///< build and run come from a tumble.toml
  double timeout_s = 0;               ///< of a run of the program, not of a build

  // How it is gone about; no answer depends on it.
  std::uint64_t asks = 2;  ///< times that each revision is asked, before it counts as repeatable
  std::uint64_t jobs = 1;  ///< revisions built and asked at once
  std::string cache;       ///< folder that keeps programs by commit; empty: none
  std::uint64_t cache_bytes = 5'000'000'000;

  /// One line for people: "replay of wall.tumble in every bit".
  [[nodiscard]] std::string question() const;
  /// All settings as text. An interrupted bisection and the one that resumes it must agree in it.
  [[nodiscard]] std::string fingerprint() const;
};

}  // namespace tumble::tools::bisect
