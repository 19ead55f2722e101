#include "src/kernels/kernels_by_width.h"

#include <array>
#include <cstddef>

#include "src/base/check.h"

namespace tumble::sim {
namespace {

// Null where this machine or this build does not run the width.
const Kernels* find_kernels(LaneWidth width) {
  if (!machine_has_lanes(width)) return nullptr;
  switch (width) {
    case LaneWidth::kOne:
      return compiled_kernels<1>();
    case LaneWidth::kTwo:
      return compiled_kernels<2>();
    case LaneWidth::kFour:
      return compiled_kernels<4>();
    case LaneWidth::kEight:
      return compiled_kernels<8>();
    case LaneWidth::kWidest:
      break;
  }
  for (const LaneWidth wide : {LaneWidth::kEight, LaneWidth::kFour}) {
    if (const Kernels* found = find_kernels(wide)) return found;
  }
  return compiled_kernels<2>();
}

}  // namespace

bool runs_lanes(LaneWidth width) { return find_kernels(width) != nullptr; }

const Kernels& kernels(LaneWidth width) {
  // A substep of a few bodies asks often.
  static const std::array kFound = {find_kernels(LaneWidth::kWidest), find_kernels(LaneWidth::kOne),
                                    find_kernels(LaneWidth::kTwo), find_kernels(LaneWidth::kFour),
                                    find_kernels(LaneWidth::kEight)};
  const Kernels* found = kFound[static_cast<std::size_t>(width)];
  SIM_CHECK(found != nullptr, std::string_view(name_of(width)));
  return *found;
}

}  // namespace tumble::sim
