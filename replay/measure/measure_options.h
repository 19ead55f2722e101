#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/body_table.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// A choice of the bodies that are measured. Static bodies never count, chosen or not.
struct BodyChoice {
  struct Ids {
    sim::BodyId first;
    sim::BodyId last;
    [[nodiscard]] bool holds(const sim::BoxDef& box) const;
    friend bool operator==(const Ids&, const Ids&) = default;
  };
  /// All bodies that one kind of scene table made, or only those of one table of that kind.
  struct Table {
    sim::Origin::Kind kind;
    std::optional<std::uint32_t> index;  ///< 0-based
    [[nodiscard]] bool holds(const sim::BoxDef& box) const;
    friend bool operator==(const Table&, const Table&) = default;
  };
  std::vector<Ids> ids;
  std::vector<Table> tables;

  /// Nothing chosen means every body.
  [[nodiscard]] bool all() const { return ids.empty() && tables.empty(); }
  [[nodiscard]] bool holds(const sim::BoxDef& box) const;
  friend bool operator==(const BodyChoice&, const BodyChoice&) = default;
};

/// Reads "all", or a list joined by commas: ids ("7"), ranges of ids ("3-9"), tables of the scene ("grid": every
/// [[grid]], "grid:1": the second one; box, grid, tower, pyramid, wall, pile, and input for bodies thrown in). Errors
/// (kBadInput): any other text.
Result<BodyChoice> parse_bodies(const std::string& text);
/// Likewise, with names of bodies beside ids. Errors (kBadInput): also a name that reads as the ids of other bodies.
Result<BodyChoice> parse_bodies(const std::string& text, const BodyTable& named);
/// The id of one body, as an id or a name says it.
Result<sim::BodyId> parse_body(const std::string& text, const BodyTable& named);
std::string to_string(const BodyChoice& choice);

/// Finds the parts of a choice that no body belongs to.
class ChoiceWatch {
 public:
  explicit ChoiceWatch(BodyChoice choice);
  /// A body that is there at any time.
  void add(const sim::BoxDef& box);
  /// The parts without a body: "body 7777", "bodies 3-9", "tower:4". Empty: each has one.
  [[nodiscard]] std::vector<std::string> missing() const;

 private:
  BodyChoice choice_;
  std::vector<bool> ids_, tables_;  // whether a body belongs to it
};

enum class LateralAxis : std::uint8_t { kX = 0, kY = 1 };

/// Bodies, axis and steps of a measurement. docs/metrics.md lists which metrics follow which option.
struct MeasureOptions {
  BodyChoice bodies = {};
  LateralAxis lateral = LateralAxis::kX;  ///< the axis along which no body should move
  std::uint64_t from_step = 0;            ///< the state after this step replaces the start
  std::uint32_t overlap_every = 1;        ///< steps between two measurements of overlap; 0 measures the end only
};

}  // namespace tumble::replay
