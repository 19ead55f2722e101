#include "src/kernels/contact_kernels_impl.h"

namespace tumble::sim {

const ContactKernels* contact_kernels_eight() {
#ifdef __AVX512F__
  static constexpr ContactKernels kKernels = kernels_of<8>();
  return &kKernels;
#else
  return nullptr;
#endif
}

}  // namespace tumble::sim
