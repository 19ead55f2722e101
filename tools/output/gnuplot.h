#pragma once

#include <string>

#include "src/base/result.h"

/// Plots for `--plot`, drawn by gnuplot.
namespace tumble::tools {

/// Errors (kBadInput): a name that ends with neither .svg nor .png.
Status check_plot_path(const std::string& path);

/// As gnuplot wants a text, in its single quotes.
std::string gnuplot_quoted(const std::string& text);

/// Draws what a script plots, so many pixels wide and high; terminal and output are set before it. The file appears
/// whole or not at all. Errors (kCannotFinish): no gnuplot, a file that cannot be written.
Status run_gnuplot(const std::string& path, int width, int height, const std::string& script);

}  // namespace tumble::tools
