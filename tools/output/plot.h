#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay/measure/measure.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `measure --plot`: energies, heights and overlap over time, drawn by gnuplot.
class Plot {
 public:
  /// path: ends with .svg or .png. Errors (kBadInput): another ending.
  static Result<Plot> for_file(const std::string& path);

  void add(const replay::SeriesRow& row);

  /// Draws what was added, under a title. Errors (kCannotFinish): no gnuplot, a file that cannot be written.
  [[nodiscard]] Status draw(const std::string& title) const;

 private:
  struct Point {
    double time, kinetic, potential, own;  // s, J; own: the total without the work of inputs
    double highest, mean, lowest;          // m
    double penetration;                    // m
    std::optional<double> overlap;         // m
  };

  explicit Plot(std::string path) : path_(std::move(path)) {}
  [[nodiscard]] std::string data() const;

  std::string path_;
  std::vector<Point> points_;
};

}  // namespace tumble::tools
