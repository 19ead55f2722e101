#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/shape.h"
#include "tumble/sim/ids.h"

namespace tumble::replay {

/// Ids from here on are made of names, by an import: they say nothing to people.
inline constexpr sim::BodyId kIdsOfNames = sim::BodyId{1} << 52U;

/// The names and shapes of the bodies of a log.
class BodyTable {
 public:
  /// A body that is in the table already keeps its first name and shape, unless it had none.
  void add(const std::vector<BodyInfo>& bodies, const std::vector<Shape>& shapes);

  /// The name of a body; empty: none.
  [[nodiscard]] std::string name(sim::BodyId id) const;
  /// The shape of a body; null: the box of its size.
  [[nodiscard]] const Shape* shape(sim::BodyId id) const;

  /// For people: "body 7", or "body 7 (wheel_fl)"; of an id that is made of the name, "body wheel_fl".
  [[nodiscard]] std::string text(sim::BodyId id) const;

  [[nodiscard]] bool empty() const { return bodies_.empty(); }
  [[nodiscard]] const std::map<sim::BodyId, BodyInfo>& bodies() const { return bodies_; }
  [[nodiscard]] std::size_t shape_count() const { return shapes_.size(); }

 private:
  std::map<sim::BodyId, BodyInfo> bodies_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, Shape> shapes_;  // by hash
};

}  // namespace tumble::replay
