#include "src/kernels/body_kernels_impl.h"

namespace tumble::sim {

const BodyKernels* body_kernels_two() {
  static constexpr BodyKernels kKernels = body_kernels_of<2>();
  return &kKernels;
}

}  // namespace tumble::sim
