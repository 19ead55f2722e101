#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "replay/format/not_finite.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/ids.h"

namespace tumble::replay {

/// The first place of an oddness, and how often there is one.
class FirstOf {
 public:
  /// say: gives the text; called for the first alone.
  template <class Say>
  void add(Say say) {
    if (++count_ == 1) text_ = say();
  }
  /// "t.csv:4:9: … , and 4 rows more likewise"; empty without one. one: "row"; empty: "and 4 more likewise".
  [[nodiscard]] std::string text(const char* one = "") const;

 private:
  std::uint64_t count_ = 0;
  std::string text_;
};

/// Contacts that none can be: a number that is not finite, a normal that is no direction. Keeps the first, and counts.
class ContactCheck {
 public:
  void add(std::uint64_t step, const std::vector<EngineContact>& contacts);
  void without_points(std::uint64_t step, sim::BodyId a, sim::BodyId b);
  /// "step 3, contact of 1 and 2: depth is nan, and 4 more likewise"; empty without one.
  [[nodiscard]] std::string not_finite() const { return not_finite_.text(); }
  /// "step 3, contact of 1 and 2: the normal has a length of 7, wanted 1".
  [[nodiscard]] std::string no_direction() const { return no_direction_.text(); }
  /// "step 3, contact of 1 and 2: has no points, so the log keeps it in a channel, …".
  [[nodiscard]] std::string pointless() const { return pointless_.text(); }

 private:
  FirstOf not_finite_, no_direction_, pointless_;
};

/// What is odd about a table that can still be imported. Of each kind of oddness the first place is kept, and a count.
class TableNotes {
 public:
  /// A body whose state is not finite, so that the body is lost. place: "t.csv:4:9: ".
  void lost(const std::string& place, const NotFinite& found);
  /// An orientation that is a rotation only roughly.
  void rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length);
  /// A body that returns after steps without it.
  void came_back(const std::string& place, sim::BodyId body, std::uint64_t step);
  /// Bodies of the step before that the last step lacks.
  void short_end(const std::string& place, std::size_t bodies, std::size_t before, sim::BodyId first_missing);
  /// A later row calls a body otherwise than its first row, whose name the log keeps.
  void renamed(const std::string& place, sim::BodyId body, std::string_view kept, std::string_view now);
  /// A body whose id is a text has another text for a name, which the log keeps.
  void called_twice(const std::string& place, sim::BodyId body, std::string_view id, std::string_view name);
  /// A new body with a name; two of one name are an oddness.
  void named(const std::string& place, sim::BodyId body, const std::string& name);

  [[nodiscard]] std::vector<std::string> texts() const;

 private:
  std::set<sim::BodyId> lost_;
  NotFinite first_lost_;
  std::string place_of_lost_;
  std::string short_end_;
  FirstOf rough_, back_, renamed_, called_twice_, same_name_;
  std::map<std::string, sim::BodyId> names_;
};

}  // namespace tumble::replay
