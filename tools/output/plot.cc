#include "tools/output/plot.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "tools/output/gnuplot.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

// Colours that stay apart without colour vision.
constexpr const char* kSeriesStyle = R"(
set multiplot layout panels,1 title title_text noenhanced font ',14'
set format y '%.4g'
set key outside top center horizontal maxrows 1
set linetype 1 linecolor rgb '#0072b2' linewidth 1.5
set linetype 2 linecolor rgb '#e69f00' linewidth 1.5
set linetype 3 linecolor rgb '#000000' linewidth 2
set linetype 4 linecolor rgb '#d55e00' linewidth 1.5 pointtype 7 pointsize 0.4
set xrange [first:last]
set offsets 0, 0, graph 0.05, graph 0.05
set ylabel 'energy, J'
plot $rows using 1:2 title 'kinetic' linetype 1, \
     $rows using 1:3 title 'potential' linetype 2, \
     $rows using 1:4 title 'total less inputs' linetype 3
set ylabel 'height of centres, '.unit
plot $rows using 1:5 title 'highest' linetype 1, \
     $rows using 1:6 title 'mean' linetype 3, \
     $rows using 1:7 title 'lowest' linetype 2
set ylabel 'depth, '.unit
set yrange [0:*]
set xlabel 'time, s'
plot $rows using 1:8 title 'in the ground' linetype 2, \
     $overlaps using 1:2 title 'deepest overlap of two boxes' with linespoints linetype 4
)";

constexpr int kPanelHeight = 333;  // pixels

}  // namespace

Result<Plot> Plot::for_file(const std::string& path, const std::string& unit,
                            const std::vector<replay::Channel>& channels) {
  if (Status ok = check_plot_path(path); !ok.ok()) return ok.error();
  return Plot(path, unit, channels);
}

void Plot::add(const replay::SeriesRow& row) {
  const replay::StateMeasures& state = row.state;
  points_.push_back({row.time, row.kinetic, row.potential, row.kinetic + row.potential - row.inputs, state.height_max,
                     state.height_mean, state.height_min, state.ground_penetration_max, row.overlap, row.channels});
}

std::string Plot::data() const {
  std::string rows = "$rows << EOD\n", overlaps = "$overlaps << EOD\n";
  const std::size_t stride = points_.size() / kPlotPointsMax + 1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    if (p.overlap) overlaps += exact(p.time) + ' ' + exact(*p.overlap) + '\n';
    if (i % stride != 0 && i + 1 != points_.size()) continue;
    for (const double value : {p.time, p.kinetic, p.potential, p.own, p.highest, p.mean, p.lowest, p.penetration}) {
      rows += exact(value) + ' ';
    }
    rows += '\n';
  }
  return rows + "EOD\n" + overlaps + "EOD\n";
}

/// The value of the world, or the least and the largest of bodies or pairs.
std::string Plot::channel_panel(std::size_t channel) const {
  const replay::Channel& about = channels_[channel];
  std::string rows = "$channel << EOD\n";
  const std::size_t stride = points_.size() / kPlotPointsMax + 1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i % stride != 0 && i + 1 != points_.size()) continue;
    const replay::ChannelRow& row = points_[i].channels[channel];
    const auto cell = [&](double value) { return row.values > 0 && std::isfinite(value) ? exact(value) : "?"; };
    rows += exact(points_[i].time) + ' ' + cell(row.min) + ' ' + cell(row.max) + '\n';
  }
  const std::string label = "channel " + about.name + (about.unit.empty() ? "" : ", " + about.unit);
  const bool is_world = about.type.scope == replay::ChannelScope::kWorld;
  return rows + "EOD\nset ylabel " + gnuplot_quoted(label) + " noenhanced\nset yrange [*:*]\nplot $channel using 1:3 " +
         (is_world ? "title 'value' linetype 1\n"
                   : "title 'largest' linetype 1, $channel using 1:2 title 'least' linetype 2\n");
}

Status Plot::draw(const std::string& title) const {
  std::string panels;
  std::size_t drawn = 0;
  for (std::size_t c = 0; c < channels_.size() && drawn < kPlotChannelsMax; ++c) {
    const bool has_value =
        std::ranges::any_of(points_, [c](const Point& point) { return point.channels[c].values > 0; });
    if (!is_number(channels_[c].type.kind) || !has_value) continue;
    panels += channel_panel(c);
    ++drawn;
  }
  const std::size_t others = channels_.size() - drawn;
  const std::string more = others == 0 ? "" : "; " + count_text(others, "channel") + " not drawn";
  const double first = points_.front().time, last = points_.back().time;
  return run_gnuplot(path_, 900, kPanelHeight * static_cast<int>(3 + drawn) + 1,
                     "panels = " + std::to_string(3 + drawn) + "\ntitle_text = " + gnuplot_quoted(title + more) +
                         "\nunit = " + gnuplot_quoted(unit_) + "\nfirst = " + exact(first) +
                         "\nlast = " + exact(last > first ? last : first + 1) + '\n' + data() + kSeriesStyle + panels +
                         "unset multiplot\n");
}

}  // namespace tumble::tools
