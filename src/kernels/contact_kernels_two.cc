#include "src/kernels/contact_kernels_impl.h"

namespace tumble::sim {

const ContactKernels* contact_kernels_two() {
  static constexpr ContactKernels kKernels = kernels_of<2>();
  return &kKernels;
}

}  // namespace tumble::sim
