// Compiled once for each lane width: TUMBLE_LANES is the width, and the flags of the file are the instructions that it
// needs. src/kernels/CMakeLists.txt and tools/scripts/checks/determinism.sh list the widths. The headers included here
// keep every function to themselves; src/kernels/lane_vector.h says why.
#include "src/kernels/kernels.h"

#include "src/kernels/body_kernels_impl.h"
#include "src/kernels/box_tests_impl.h"
#include "src/kernels/contact_kernels_impl.h"

#ifndef TUMBLE_LANES
#error "TUMBLE_LANES must be 1, 2, 4 or 8"
#endif

namespace tumble::sim {

#if (TUMBLE_LANES == 4 && !defined(__AVX2__)) || (TUMBLE_LANES == 8 && !defined(__AVX512F__))

template <>
const Kernels* compiled_kernels<TUMBLE_LANES>() {
  return nullptr;
}

#else

template <>
const Kernels* compiled_kernels<TUMBLE_LANES>() {
  static constexpr Kernels kKernels = {body_kernels_of<TUMBLE_LANES>(), box_test_kernels_of<TUMBLE_LANES>(),
                                       contact_kernels_of<TUMBLE_LANES>()};
  return &kKernels;
}

#endif

}  // namespace tumble::sim
