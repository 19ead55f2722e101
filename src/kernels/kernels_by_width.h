#pragma once

#include "src/kernels/lane_width.h"

namespace tumble::sim {

/// Functions that are compiled once for each width; null where the compiler does not make it.
template <class Kernels>
struct KernelsByWidth {
  const Kernels* one;
  const Kernels* two;
  const Kernels* four;
  const Kernels* eight;

  /// Null where this machine or this build does not run the width.
  [[nodiscard]] const Kernels* of(LaneWidth width) const {
    if (!machine_has_lanes(width)) return nullptr;
    switch (width) {
      case LaneWidth::kOne:
        return one;
      case LaneWidth::kTwo:
        return two;
      case LaneWidth::kFour:
        return four;
      case LaneWidth::kEight:
        return eight;
      case LaneWidth::kWidest:
        break;
    }
    if (const Kernels* kernels = of(LaneWidth::kEight)) return kernels;
    const Kernels* kernels = of(LaneWidth::kFour);
    return kernels != nullptr ? kernels : two;
  }
};

}  // namespace tumble::sim
