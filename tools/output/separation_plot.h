#pragma once

#include <string>

#include "replay/diff/separation.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `diff --plot`: draws the separation, on a logarithmic scale, the number of bodies that differ, and the distances of
/// the channels that differ (six at most; the title counts the others) over the steps.
/// Errors: run_gnuplot()'s.
Status draw_separation(const std::string& path, const std::string& title, const replay::Separation& separation);

}  // namespace tumble::tools
