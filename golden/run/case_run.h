#pragma once

#include <optional>
#include <string>
#include <vector>

#include "golden/judge/judge_pictures.h"
#include "tumble/golden/case_result.h"
#include "tumble/golden/expected.h"

namespace tumble::golden {

/// A case, run and judged.
struct CaseRun {
  CaseResult result;
  CaseRules rules;
  Expected actual;
  std::vector<std::optional<double>> values;
  std::vector<DrawnPicture> pictures;
  bool unable = false;                        ///< the engine or the machine failed, and not what the case asks
  std::string incomplete = "it was not run";  ///< why the run stopped; empty: it ran to its end and was measured
};

}  // namespace tumble::golden
