#pragma once

#include <vector>

#include "tools/compare/spread.h"
#include "tools/output/text.h"

namespace tumble::tools {

void print_spreads(const RunsFacts& facts, const std::vector<MetricSpread>& spreads);
Json spreads_json(const RunsFacts& facts, const std::vector<MetricSpread>& spreads);

void print_bounds(const RunsFacts& facts, const std::vector<JudgedBound>& bounds);
Json bounds_json(const RunsFacts& facts, const std::vector<JudgedBound>& bounds);

}  // namespace tumble::tools
