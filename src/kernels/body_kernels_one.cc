#include "src/kernels/body_kernels_impl.h"

namespace tumble::sim {

const BodyKernels* body_kernels_one() {
  static constexpr BodyKernels kKernels = body_kernels_of<1>();
  return &kKernels;
}

}  // namespace tumble::sim
