#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/scenes/problem.h"
#include "tumble/sim/ids.h"

namespace tumble::scenes {

/// Gives bodies their ids. All ids that the scene states are reserved first, wherever they stand in the file. Bodies
/// without an id then take the next free numbers, from 1, in the order of the calls of next().
class BodyIds {
 public:
  /// Takes the numbers first … first + count − 1. what: for messages, "[[box]] key \"id\"". Reports a range beyond the
  /// largest id.
  void reserve(sim::BodyId first, std::uint64_t count, const Place& place, const std::string& what, Problem& problem);

  /// Call once after the last reserve(): reports numbers that are taken twice.
  void finish_reserving(Problem& problem);

  sim::BodyId next();

 private:
  struct Range {
    sim::BodyId first;
    sim::BodyId last;
    std::size_t asked;  // how many ranges were reserved before
    Place place;
    std::string what;
  };
  std::vector<Range> reserved_;  // ascending once finished
  std::size_t skipped_ = 0;      // ranges that end below next_
  sim::BodyId next_ = 1;
};

}  // namespace tumble::scenes
