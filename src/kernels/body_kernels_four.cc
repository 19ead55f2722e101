#include "src/kernels/body_kernels_impl.h"

namespace tumble::sim {

const BodyKernels* body_kernels_four() {
#ifdef __AVX2__
  static constexpr BodyKernels kKernels = body_kernels_of<4>();
  return &kKernels;
#else
  return nullptr;
#endif
}

}  // namespace tumble::sim
