#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "replay/format/not_finite.h"
#include "tumble/sim/ids.h"

namespace tumble::replay {

/// What is odd about a table that can still be imported. Of each kind of oddness the first place is kept, and a count.
class TableNotes {
 public:
  /// A body whose state is not finite, so that the body is lost. place: "t.csv:4:9: ".
  void lost(const std::string& place, const NotFinite& found);
  /// An orientation that is a rotation only roughly.
  void rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length);
  /// Bodies of the step before that the last step lacks.
  void short_end(const std::string& place, std::size_t bodies, std::size_t before, sim::BodyId first_missing);

  [[nodiscard]] std::vector<std::string> texts() const;

 private:
  std::set<sim::BodyId> lost_;
  NotFinite first_lost_;
  std::string place_of_lost_;
  std::uint64_t rough_ = 0;
  std::string first_rough_;
  std::string short_end_;
};

}  // namespace tumble::replay
