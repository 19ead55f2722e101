#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/arguments/arguments.h"
#include "tumble/sim/result.h"
#include "tumble/sim/transform.h"

/// The arguments of `record` that transform a scene.
namespace tumble::tools {

struct TransformArguments {
  std::string mirror;
  std::string shift;
  std::optional<std::uint64_t> permute;
};

/// Declares `--mirror`, `--shift` and `--permute`, none of which goes with `excluded`.
void add_transform(Arguments& arguments, TransformArguments& target, Argument excluded);

/// Errors (kBadInput): another mirror than x, y and diagonal, a shift that is not two numbers on the grid of positions.
Result<sim::Transform> parse_transform(const TransformArguments& arguments);

}  // namespace tumble::tools
