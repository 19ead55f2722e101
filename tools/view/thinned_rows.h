#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "replay/view/timeline.h"

namespace tumble::tools {

/// Rows as one row for each `run` of them, so that nothing that stands out is lost: the largest of each number, of
/// channels and contacts too; the sum of what inputs put in; kinetic and potential energy of the state with the most
/// kinetic energy, so that their sum is that of a state; a bound that is broken in any. Step and time are those of the
/// first. A run with a row that was not read counts as not read. run: from 1 on, which leaves all as they are.
std::vector<replay::TimelineRow> thinned_rows(std::span<const replay::TimelineRow> rows, std::size_t run);

}  // namespace tumble::tools
