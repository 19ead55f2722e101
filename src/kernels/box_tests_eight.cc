#include "src/kernels/box_tests_impl.h"

namespace tumble::sim {

const BoxTestKernels* box_test_kernels_eight() {
#ifdef __AVX512F__
  static constexpr BoxTestKernels kKernels = box_test_kernels_of<8>();
  return &kKernels;
#else
  return nullptr;
#endif
}

}  // namespace tumble::sim
