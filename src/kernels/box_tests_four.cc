#include "src/kernels/box_tests_impl.h"

namespace tumble::sim {

const BoxTestKernels* box_test_kernels_four() {
#ifdef __AVX2__
  static constexpr BoxTestKernels kKernels = box_test_kernels_of<4>();
  return &kKernels;
#else
  return nullptr;
#endif
}

}  // namespace tumble::sim
