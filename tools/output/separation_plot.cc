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
set multiplot layout panels,1 title title_text noenhanced font ',14'
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
)";

constexpr int kSeparationPanelHeight = 350;  // pixels

bool is_drawn(const replay::ChannelSeparation& channel) {
  return channel.is_number && std::ranges::any_of(channel.distance, [](double d) { return std::isfinite(d) && d > 0; });
}

/// One panel: the largest distance of the values of a channel in each step.
std::string channel_panel(const replay::Separation& separation, const replay::ChannelSeparation& channel,
                          std::size_t stride) {
  std::string rows = "$channel << EOD\n";
  for (std::size_t i = 0; i < separation.rows.size(); ++i) {
    if (i % stride != 0 && i + 1 != separation.rows.size()) continue;
    const double distance = channel.distance[i];
    rows += std::to_string(separation.rows[i].step) + ' ' + (std::isfinite(distance) ? exact(distance) : "?") + '\n';
  }
  const std::string label = "channel " + channel.name + ", apart" + (channel.unit.empty() ? "" : ", " + channel.unit);
  return rows + "EOD\nset ylabel " + gnuplot_quoted(label) +
         " noenhanced\nset format y '%.3g'\nset yrange [0:*]\nplot $channel using 1:2 with linespoints linetype 1\n";
}

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
  std::string panels;
  std::size_t drawn = 0, others = 0;
  for (const replay::ChannelSeparation& channel : separation.channels) {
    if (!is_drawn(channel) || drawn == kPlotChannelsMax) {
      ++others;
      continue;
    }
    panels += channel_panel(separation, channel, stride);
    ++drawn;
  }
  const std::string more = others == 0 ? "" : "; " + count_text(others, "other channel") + " that differ not drawn";
  const int height = kSeparationPanelHeight * static_cast<int>(2 + drawn);
  return run_gnuplot(path, 900, height,
                     "panels = " + std::to_string(2 + drawn) + "\ntitle_text = " + gnuplot_quoted(title + more) +
                         "\nfirst = " + std::to_string(first) +
                         "\nlast = " + std::to_string(last > first ? last : first + 1) + "\nlow = " + exact(low / 2) +
                         '\n' + rows + "EOD\n" + kSeparationStyle + panels + "unset multiplot\n");
}

}  // namespace tumble::tools
