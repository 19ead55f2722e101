#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/bench/thesis_table1.h"
#include "tools/output/text.h"
#include "tumble/sim/scene.h"

/// The cells of the thesis's Table I as they were run here.
namespace tumble::tools {

/// Another engine in a cell's scene, with as many substeps as ours ran.
struct PeerCell {
  std::string engine;             ///< "Bullet 3.24"
  std::uint64_t substeps = 0;     ///< of each step, all of one length: the mean of ours, rounded
  std::optional<double> seconds;  ///< CPU; none: beyond the budget, or it failed
  std::string failure;
};

struct Table1Cell {
  std::size_t half = 0, row = 0, column = 0;
  std::optional<double> seconds;  ///< CPU, median; none: beyond the budget, and nothing below is known
  double substeps_mean = 0;       ///< that a step took
  std::uint32_t substeps_largest = 0;
  double lateral = 0;  ///< m
  std::optional<double> spread;
  std::uint64_t lost = 0;
  std::vector<PeerCell> peers;

  [[nodiscard]] int cubes() const { return kTableCubes[column]; }
  [[nodiscard]] int label() const { return kTableSubsteps[row]; }
  [[nodiscard]] double dt() const { return thesis_table1()[half].dt; }  ///< s
  [[nodiscard]] double thesis() const { return *thesis_table1()[half].thesis[row][column].seconds; }
  [[nodiscard]] TableTime havok() const { return thesis_table1()[half].havok[row][column]; }
};

/// The most substeps that a step may take: method `thesis` halves a step floor(log2(label)) times, `layered` takes all.
std::uint32_t most_substeps(int label, sim::Method method);

/// A geometric mean of ratios of times.
struct MeanRatio {
  std::size_t cells = 0;
  double mean = 1, least = 0;
};

/// The means that the table states; each over the cells that were run and have both times.
struct Table1Means {
  MeanRatio thesis;                                      ///< of 2007 over ours
  MeanRatio same_most;                                   ///< likewise, of the cells whose most substeps are the label's
  MeanRatio havok;                                       ///< of cells without 'F'
  std::vector<std::pair<std::string, MeanRatio>> peers;  ///< engine over ours, with equal substeps
};
Table1Means means_of(const std::vector<Table1Cell>& cells, sim::Method method);

void print_table1(const std::vector<Table1Cell>& cells, sim::Method method);
Json table1_json(const std::vector<Table1Cell>& cells, sim::Method method);

}  // namespace tumble::tools
