#pragma once

#include <cstdint>
#include <set>
#include <utility>

#include "tumble/replay/extras.h"

namespace tumble::replay {

/// Declares the bodies that a log begins with, and each shape once, however many of them have it.
class DeclaredBodies {
 public:
  /// shape: that of the body, with the hash info.shape; null: none. Each body once. `declared` is the same in all
  /// calls.
  void add(BodyInfo info, const Shape* shape, Declared& declared) {
    const bool is_new = shape != nullptr && shapes_.emplace(info.shape.high, info.shape.low).second;
    if (is_new) declared.shapes.push_back(*shape);
    declared.bodies.push_back(std::move(info));
  }

 private:
  std::set<std::pair<std::uint64_t, std::uint64_t>> shapes_;  // hashes of those declared
};

}  // namespace tumble::replay
