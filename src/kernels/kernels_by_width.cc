#include "src/kernels/kernels_by_width.h"

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
  const Kernels* found = find_kernels(width);
  SIM_CHECK(found != nullptr, std::string_view(name_of(width)));
  return *found;
}

}  // namespace tumble::sim
