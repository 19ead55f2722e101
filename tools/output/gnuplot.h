#pragma once

#include <cstddef>
#include <string>

#include "tumble/sim/result.h"

/// Plots for `--plot`, drawn by gnuplot.
namespace tumble::tools {

/// Points of a plot: more than a picture can show apart.
inline constexpr std::size_t kPlotPointsMax = 4000;

/// Channels that get a panel of their own.
inline constexpr std::size_t kPlotChannelsMax = 6;

/// Errors (kBadInput): a name that ends with neither .svg nor .png.
Status check_plot_path(const std::string& path);

/// A text in gnuplot's single quotes.
std::string gnuplot_quoted(const std::string& text);

/// Runs a script of gnuplot with terminal and output set, width × height pixels. The file appears whole or not at all.
/// Errors. kCannotFinish: no gnuplot, a disk that is full. kBadInput: a path that cannot be written to.
Status run_gnuplot(const std::string& path, int width, int height, const std::string& script);

}  // namespace tumble::tools
