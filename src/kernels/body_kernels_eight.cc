#include "src/kernels/body_kernels_impl.h"

namespace tumble::sim {

const BodyKernels* body_kernels_eight() {
#ifdef __AVX512F__
  static constexpr BodyKernels kKernels = body_kernels_of<8>();
  return &kKernels;
#else
  return nullptr;
#endif
}

}  // namespace tumble::sim
