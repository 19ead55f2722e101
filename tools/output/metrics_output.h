#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay/measure/measure.h"
#include "src/files/output_file.h"
#include "tools/output/text.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `measure --json`: the keys of docs/metrics.md. log: its path; axes: those of the session, whose unit lengths get.
Json metrics_json(const std::string& log, const replay::EngineAxes& axes, const replay::Metrics& metrics);

/// Prints the metrics for people, with units.
void print_metrics(const std::string& log, const replay::EngineAxes& axes, const replay::BodyTable& bodies,
                   const replay::Metrics& metrics);

/// `measure --series`: a CSV file with one row a step. Until close() the file that was there before stays.
class SeriesFile {
 public:
  /// Begins the file with its header. channels: of the log, which get columns of their own: the value of a channel of
  /// the world, the least, the largest and the mean of one of bodies or pairs, the changes of one of bytes or text.
  /// Errors: OutputFile's.
  Status open(const std::string& path, const std::vector<replay::Channel>& channels);
  void add(const replay::SeriesRow& row);
  /// Gives the file its name; without this call what was there before stays. Errors (kCannotFinish): any write since
  /// open() that failed.
  Status close();

 private:
  std::vector<replay::Channel> channels_;
  std::optional<files::OutputFile> file_;
  Status written_;  // the first error
};

}  // namespace tumble::tools
