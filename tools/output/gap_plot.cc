#include "tools/output/gap_plot.h"

#include "tools/output/gnuplot.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

// Colours that stay apart without colour vision. A separation of 0 has no place on a logarithmic scale.
constexpr const char* kStyle = R"(
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

}  // namespace

Status draw_gap(const std::string& path, const std::string& title, const replay::GapStory& story) {
  std::string rows = "$rows << EOD\n";
  const std::size_t stride = story.rows.size() / kPlotPointsMax + 1;
  double low = story.largest.gap > 0 ? story.largest.gap : 1;
  for (std::size_t i = 0; i < story.rows.size(); ++i) {
    const replay::GapRow& row = story.rows[i];
    if (row.gap > 0 && row.gap < low) low = row.gap;
    if (i % stride != 0 && i + 1 != story.rows.size()) continue;
    rows +=
        std::to_string(row.step) + ' ' + (row.gap > 0 ? exact(row.gap) : "?") + ' ' + std::to_string(row.bodies) + '\n';
  }
  const std::uint64_t first = story.rows.front().step, last = story.rows.back().step;
  // Without any separation the axis would have no scale.
  if (story.largest.gap == 0)
    rows += std::to_string(first) + " 1e-16 " + std::to_string(story.rows.front().bodies) + '\n';
  return run_gnuplot(path, 900, 700,
                     "title_text = " + gnuplot_quoted(title) + "\nfirst = " + std::to_string(first) +
                         "\nlast = " + std::to_string(last > first ? last : first + 1) + "\nlow = " + exact(low / 2) +
                         '\n' + rows + "EOD\n" + kStyle);
}

}  // namespace tumble::tools
