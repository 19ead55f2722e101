#include "tools/output/separation_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/base/text.h"
#include "tools/output/gnuplot.h"

namespace tumble::tools {
namespace {

// Colours that stay apart without colour vision. A separation of 0 has no place on a logarithmic scale.
constexpr const char* kSeparationStyle = R"(
set multiplot layout 2,1 title title_text noenhanced font ',14'
set key off
set linetype 1 linecolor rgb '#0072b2' linewidth 1.5 pointtype 7 pointsize 0.3
set linetype 2 linecolor rgb '#d55e00' linewidth 1.5
set xrange [first:last]
set ylabel 'largest distance of a body from itself, m'
set logscale y
set format y '10^{%L}'
set yrange [low:*]
plot $rows using 1:2 with linespoints linetype 1
unset logscale y
set format y '%.0f'
set yrange [0:*]
set ylabel 'bodies that differ'
set xlabel 'step'
plot $rows using 1:3 with steps linetype 2
unset multiplot
)";

// A place on a logarithmic scale of finite length: neither 0 nor the distance of a lost body has one.
bool has_place(double separation) { return separation > 0 && std::isfinite(separation); }

}  // namespace

Status draw_separation(const std::string& path, const std::string& title, const replay::Separation& separation) {
  std::string rows = "$rows << EOD\n";
  const std::size_t stride = separation.rows.size() / kPlotPointsMax + 1;
  double low = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < separation.rows.size(); ++i) {
    const replay::SeparationRow& row = separation.rows[i];
    if (has_place(row.separation)) low = std::min(low, row.separation);
    if (i % stride != 0 && i + 1 != separation.rows.size()) continue;
    rows += std::to_string(row.step) + ' ' + (has_place(row.separation) ? exact(row.separation) : "?") + ' ' +
            std::to_string(row.bodies) + '\n';
  }
  const std::uint64_t first = separation.rows.front().step, last = separation.rows.back().step;
  if (!std::isfinite(low)) {  // one point gives the axis its scale
    low = 1e-16;
    rows += std::to_string(first) + ' ' + exact(low) + ' ' + std::to_string(separation.rows.front().bodies) + '\n';
  }
  return run_gnuplot(path, 900, 700,
                     "title_text = " + gnuplot_quoted(title) + "\nfirst = " + std::to_string(first) +
                         "\nlast = " + std::to_string(last > first ? last : first + 1) + "\nlow = " + exact(low / 2) +
                         '\n' + rows + "EOD\n" + kSeparationStyle);
}

}  // namespace tumble::tools
