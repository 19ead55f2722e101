#include "src/kernels/contact_kernels_impl.h"

namespace tumble::sim {

const ContactKernels* contact_kernels_four() {
#ifdef __AVX2__
  static constexpr ContactKernels kKernels = kernels_of<4>();
  return &kKernels;
#else
  return nullptr;
#endif
}

}  // namespace tumble::sim
