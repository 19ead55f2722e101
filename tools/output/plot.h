#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay/measure/measure.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `measure --plot`: energies, heights, overlap and channels over time, drawn by gnuplot.
class Plot {
 public:
  /// path: ends with .svg or .png; unit: of the lengths. Errors (kBadInput): another ending.
  /// channels: of the log; those of numbers get a panel each, six at most, and the title counts the others.
  static Result<Plot> for_file(const std::string& path, const std::string& unit,
                               const std::vector<replay::Channel>& channels);

  void add(const replay::SeriesRow& row);

  /// Draws what was added, under a title. Errors (kCannotFinish): no gnuplot, a file that cannot be written.
  [[nodiscard]] Status draw(const std::string& title) const;

 private:
  struct Point {
    double time, kinetic, potential, own;  // s, J; own: the total without the work of inputs
    double highest, mean, lowest;          // in unit_
    double penetration;
    std::optional<double> overlap;
    std::vector<replay::ChannelRow> channels;
  };

  Plot(std::string path, std::string unit, const std::vector<replay::Channel>& channels)
      : path_(std::move(path)), unit_(std::move(unit)), channels_(channels) {}
  [[nodiscard]] std::string data() const;
  [[nodiscard]] std::string channel_panel(std::size_t channel) const;

  std::string path_;
  std::string unit_;
  std::vector<replay::Channel> channels_;
  std::vector<Point> points_;
};

}  // namespace tumble::tools
