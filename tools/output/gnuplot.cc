#include "tools/output/gnuplot.h"

#include <cstdio>
#include <span>

#include "src/base/text.h"
#include "src/process/child_pipe.h"

namespace tumble::tools {
namespace {

// Axes and data of every plot; a script may change them.
constexpr const char* kStyle = R"(
set lmargin 13
set rmargin 3
set grid xtics ytics linetype 1 linecolor rgb '#c8c8c8' linewidth 0.5
set border 3 linecolor rgb '#606060'
set tics nomirror
set datafile missing '?'
set style data lines
)";

}  // namespace

Status check_plot_path(const std::string& path) {
  if (path.ends_with(".svg") || path.ends_with(".png")) return {};
  return bad_input("--plot: found " + in_quotes(path) + ", wanted a name that ends with .svg or .png");
}

std::string gnuplot_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : printable(text)) out += c == '\'' ? "''" : std::string(1, c);  // nothing else means anything
  return out + "'";
}

Status run_gnuplot(const std::string& path, int width, int height, const std::string& script) {
  const std::string part = path + ".part";
  const std::string size = std::to_string(width) + ',' + std::to_string(height);
  const std::string terminal =
      path.ends_with(".svg") ? "svg size " + size + " background 'white'" : "pngcairo size " + size;
  const std::string text =
      "set terminal " + terminal + " font 'sans,11'\nset output " + gnuplot_quoted(part) + kStyle + script;
  process::ChildPipe gnuplot;
  if (Status ok = gnuplot.start({"gnuplot", "--default-settings", "-"}, "plots", "gnuplot-nox"); !ok.ok()) return ok;
  const bool written = gnuplot.write(std::as_bytes(std::span(text)));
  if (gnuplot.finish() && written && std::rename(part.c_str(), path.c_str()) == 0) return {};
  std::remove(part.c_str());
  return cannot_finish("--plot: " + path + ": gnuplot could not write it; its message is above");
}

}  // namespace tumble::tools
