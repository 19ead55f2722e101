#include "src/solve/contact_kernels.h"

namespace tumble::sim {
namespace {

bool has_avx2() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

bool has_avx512() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
#else
  return false;
#endif
}

LaneWidth widest() {
  if (runs_lanes(LaneWidth::kEight)) return LaneWidth::kEight;
  return runs_lanes(LaneWidth::kFour) ? LaneWidth::kFour : LaneWidth::kTwo;
}

}  // namespace

bool runs_lanes(LaneWidth width) {
  switch (width) {
    case LaneWidth::kWidest:
    case LaneWidth::kOne:
    case LaneWidth::kTwo:
      return true;
    case LaneWidth::kFour:
      return has_avx2() && contact_kernels_four() != nullptr;
    case LaneWidth::kEight:
      return has_avx512() && contact_kernels_eight() != nullptr;
  }
  return false;
}

const char* name_of(LaneWidth width) {
  static constexpr const char* kNames[] = {"widest", "one", "two", "four", "eight"};
  return kNames[static_cast<std::size_t>(width)];
}

const ContactKernels& contact_kernels(LaneWidth width) {
  switch (width) {
    case LaneWidth::kOne:
      return *contact_kernels_one();
    case LaneWidth::kFour:
      return *contact_kernels_four();
    case LaneWidth::kEight:
      return *contact_kernels_eight();
    case LaneWidth::kTwo:
      return *contact_kernels_two();
    case LaneWidth::kWidest:
      break;
  }
  static const ContactKernels& kernels = contact_kernels(widest());
  return kernels;
}

}  // namespace tumble::sim
