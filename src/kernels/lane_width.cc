#include "src/kernels/lane_width.h"

#include <cstddef>

namespace tumble::sim {

const char* name_of(LaneWidth width) {
  static constexpr const char* kNames[] = {"widest", "one", "two", "four", "eight"};
  return kNames[static_cast<std::size_t>(width)];
}

bool machine_has_lanes(LaneWidth width) {
#if defined(__x86_64__) || defined(__i386__)
  if (width == LaneWidth::kFour) return __builtin_cpu_supports("avx2") != 0;
  if (width == LaneWidth::kEight) {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
  }
#else
  if (width == LaneWidth::kFour || width == LaneWidth::kEight) return false;
#endif
  return true;
}

}  // namespace tumble::sim
