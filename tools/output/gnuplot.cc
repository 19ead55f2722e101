#include "tools/output/gnuplot.h"

#include <fstream>
#include <iterator>
#include <span>

#include "golden/suite/temporary_folder.h"
#include "src/base/text.h"
#include "src/files/output_file.h"
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

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// gnuplot ends with status 0 also where the disk took only a part of its file.
bool is_complete(const std::string& picture, bool is_svg) {
  const std::size_t end = picture.rfind(is_svg ? "</svg>" : "IEND");
  constexpr std::size_t kTail = 16;  // the last checksum, or a newline
  return end != std::string::npos && picture.size() - end <= kTail;
}

}  // namespace

Status check_plot_path(const std::string& path) {
  if (printable(path) != path) {
    return bad_input("--plot: found " + in_quotes(path) + ", wanted a name without control characters");
  }
  if (path.ends_with(".svg") || path.ends_with(".png")) return {};
  return bad_input("--plot: found " + in_quotes(path) + ", wanted a name that ends with .svg or .png");
}

std::string gnuplot_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : printable(text)) out += c == '\'' ? "''" : std::string(1, c);  // nothing else means anything
  return out + "'";
}

Status run_gnuplot(const std::string& path, int width, int height, const std::string& script) {
  Result<files::OutputFile> file = files::OutputFile::create(path);
  if (!file.ok()) return Error{file.error().kind, "--plot: " + file.error().message};
  if (file->is_device()) return bad_input("--plot: " + path + ": found a device or a pipe, wanted a file");
  const bool is_svg = path.ends_with(".svg");
  const std::string size = std::to_string(width) + ',' + std::to_string(height);
  const std::string terminal = is_svg ? "svg size " + size + " background 'white'" : "pngcairo size " + size;
  const std::string text =
      "set terminal " + terminal + " font 'sans,11'\nset output " + gnuplot_quoted(file->part()) + kStyle + script;
  // Warnings of gnuplot's, as about an axis without extent, tell a user nothing; an error of gnuplot's is passed on.
  const golden::TemporaryFolder folder("tumble-plot");
  const std::string errors = folder.path().empty() ? "/dev/null" : (folder.path() / "errors").string();
  process::ChildPipe gnuplot;
  if (Status ok = gnuplot.start({"gnuplot", "--default-settings", "-"}, "plots", "gnuplot-nox", errors); !ok.ok()) {
    return ok;
  }
  const bool written = gnuplot.write(std::as_bytes(std::span(text)));
  if (gnuplot.finish() && written && is_complete(content_of(file->part()), is_svg)) return file->commit();
  return cannot_finish("--plot: " + path + ": gnuplot could not write it" + process::last_words(content_of(errors)));
}

}  // namespace tumble::tools
