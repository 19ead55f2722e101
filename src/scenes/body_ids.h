#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/base/ids.h"
#include "src/scenes/problem.h"

namespace tumble::scenes {

/// Who gets which id. First every id that the scene gives is reserved, whether it stands before or after; then the
/// bodies without one take the next free number, from 1, in the order they ask.
class BodyIds {
 public:
  /// Numbers first … first + count − 1 are taken. what: for messages, "[[box]] key \"id\"". Reports a range that leaves
  /// the ids that exist.
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
