#pragma once

#include <string>

#include "replay/diff/gap_story.h"
#include "src/base/result.h"

namespace tumble::tools {

/// `diff --plot`: the separation and the number of bodies that differ over the steps, the separation on a logarithmic
/// scale. Errors: run_gnuplot()'s.
Status draw_gap(const std::string& path, const std::string& title, const replay::GapStory& story);

}  // namespace tumble::tools
