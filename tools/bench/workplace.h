#pragma once

#include <string>
#include <vector>

#include "golden/suite/temporary_folder.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The end of a run of this program.
struct ProgramRun {
  int exit = -1;         ///< status; −1: a signal ended it
  double seconds = 0;    ///< on the wall
  double cpu = 0;        ///< s, of all its threads
  double megabytes = 0;  ///< of memory, at most
  std::string err;       ///< what it printed to its standard error
};

/// A folder that goes with this object, for benchmarks that run this program on files.
class Workplace {
 public:
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Runs this program with these arguments to its end. Errors (kCannotFinish): it does not start.
  [[nodiscard]] Result<ProgramRun> run(const std::vector<std::string>& arguments) const;

 private:
  golden::TemporaryFolder folder_{"tumble_bench"};
};

}  // namespace tumble::tools
