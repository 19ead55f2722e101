#include "src/kernels/box_tests_impl.h"

namespace tumble::sim {

const BoxTestKernels* box_test_kernels_two() {
  static constexpr BoxTestKernels kKernels = box_test_kernels_of<2>();
  return &kKernels;
}

}  // namespace tumble::sim
