#include "tools/view/thinned_rows.h"

#include <algorithm>
#include <cmath>

#include "replay/format/not_finite.h"
#include "src/base/check.h"

namespace tumble::tools {
namespace {

using Row = replay::TimelineRow;

// NaN stands for a channel without a number in that step.
void keep_channels(Row& row, const Row& next) {
  if (row.channels.size() < next.channels.size()) row.channels.resize(next.channels.size(), replay::kNotANumber);
  for (std::size_t c = 0; c < next.channels.size(); ++c) row.channels[c] = std::fmax(row.channels[c], next.channels[c]);
}

void keep_bounds(Row& row, const Row& next) {
  if (row.bounds.empty()) row.bounds = next.bounds;
  for (std::size_t b = 0; b < next.bounds.size(); ++b) {
    if (next.bounds[b].judged && (!row.bounds[b].judged || !next.bounds[b].holds)) row.bounds[b] = next.bounds[b];
  }
}

void keep_largest(Row& row, const Row& next) {
  row.read = row.read && next.read;
  row.inputs += next.inputs;
  if (!(next.kinetic <= row.kinetic) && !std::isnan(row.kinetic)) {  // a NaN is kept
    row.kinetic = next.kinetic;
    row.potential = next.potential;
  }
  row.contacts = std::max(row.contacts, next.contacts);
  row.bodies = std::max(row.bodies, next.bodies);
  row.frozen = std::max(row.frozen, next.frozen);
  row.not_finite = std::max(row.not_finite, next.not_finite);
  if (next.speed_max > row.speed_max) {
    row.speed_max = next.speed_max;
    row.speed_body = next.speed_body;
  }
  row.height_max = std::max(row.height_max, next.height_max);
  row.overlap = replay::largest(row.overlap, next.overlap);
  keep_channels(row, next);
  keep_bounds(row, next);
}

}  // namespace

std::vector<Row> thinned_rows(std::span<const Row> rows, std::size_t run) {
  SIM_CHECK(run > 0);
  std::vector<Row> out;
  for (std::size_t i = 0; i < rows.size(); i += run) {
    const auto of_run = rows.subspan(i, std::min(run, rows.size() - i));
    out.push_back(of_run.front());
    for (const Row& next : of_run.subspan(1)) keep_largest(out.back(), next);
  }
  return out;
}

}  // namespace tumble::tools
