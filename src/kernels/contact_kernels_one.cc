#include "src/kernels/contact_kernels_impl.h"

namespace tumble::sim {

const ContactKernels* contact_kernels_one() {
  static constexpr ContactKernels kKernels = kernels_of<1>();
  return &kKernels;
}

}  // namespace tumble::sim
