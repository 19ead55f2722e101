#pragma once

#include <string>
#include <vector>

#include "replay/view/bound_scan.h"
#include "tumble/replay/body_table.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The bounds that a timeline shows, and what is left out of them.
struct CaseBounds {
  std::vector<replay::ViewedBound> bounds;
  std::vector<std::string> notes;  ///< for people: metrics that no timeline has
};

/// The bounds of a case's metrics.toml: one for each limit of each metric. Limits of lengths, m in the file, are in the
/// session's unit, as --require has them. axes and names: of the session. Errors: read_rules', options_of()'s.
Result<CaseBounds> bounds_of_case(const std::string& file, const replay::EngineAxes& axes,
                                  const replay::BodyTable& named);

}  // namespace tumble::tools
