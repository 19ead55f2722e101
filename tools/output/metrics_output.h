#pragma once

#include <fstream>
#include <string>

#include "replay/measure/measure.h"
#include "tools/output/text.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `measure --json`: the keys of docs/metrics.md. log: its path; axes: those of the session, whose unit lengths get.
Json metrics_json(const std::string& log, const replay::EngineAxes& axes, const replay::Metrics& metrics);

/// Prints the metrics for people, with units.
void print_metrics(const std::string& log, const replay::EngineAxes& axes, const replay::Metrics& metrics);

/// `measure --series`: a CSV file with one row a step.
class SeriesFile {
 public:
  /// Opens the file and writes the header. Errors (kBadInput): a path that cannot be written to.
  Status open(const std::string& path);
  void add(const replay::SeriesRow& row);
  /// Errors (kCannotFinish): any write since open() that failed.
  Status close();

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace tumble::tools
