#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tumble/replay/body_states.h"

namespace tumble::tools {

/// Where every body was at evenly spaced steps, as many as a line on a screen needs.
class BodyWays {
 public:
  /// Takes the states of the next step; a step that cannot be read is left out.
  void add(std::uint64_t step, const replay::BodyStates& states);

  struct Way {
    std::vector<std::uint64_t> step;
    std::vector<float> at;  ///< m, x y z of each step; NaN where the body was not there or not finite
  };
  [[nodiscard]] Way way(sim::BodyId id) const;

 private:
  static constexpr std::size_t kStepsMax = 256;

  std::map<sim::BodyId, std::size_t> rows_;
  std::vector<std::uint64_t> steps_;
  std::vector<std::vector<float>> places_;  // by step, three a row
  std::uint64_t taken_ = 0;
  std::uint64_t stride_ = 1;
};

}  // namespace tumble::tools
