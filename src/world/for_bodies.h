#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "src/world/scratch.h"

/// Loops over bodies and manifolds by several workers at a time, each with those that are at home with it.
namespace tumble::sim {

/// Calls visit(begin, end) for ranges of bodies that make up [0, n), by several workers at a time.
template <class Visit>
void for_bodies(const Scratch& scratch, std::size_t n, Visit visit) {
  scratch.homes.for_all(scratch.workers, n, kBodiesAPart, visit);
}
/// Likewise ranges of manifolds that make up [0, n).
template <class Visit>
void for_manifolds(const Scratch& scratch, std::size_t n, Visit visit) {
  scratch.manifold_homes.for_all(scratch.workers, n, kManifoldsAPart, visit);
}
/// Gives a column by body n equal values, by several workers at a time.
template <class Value>
void fill_bodies(const Scratch& scratch, std::size_t n, std::vector<Value>& column, const Value& value) {
  column.resize(n);
  for_bodies(scratch, n, [&](std::size_t begin, std::size_t end) {
    std::fill(column.begin() + static_cast<std::ptrdiff_t>(begin), column.begin() + static_cast<std::ptrdiff_t>(end),
              value);
  });
}

}  // namespace tumble::sim
