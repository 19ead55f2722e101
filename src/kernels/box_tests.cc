#include "src/kernels/box_tests.h"

#include "src/kernels/kernels_by_width.h"

namespace tumble::sim {

const BoxTestKernels* box_test_kernels(LaneWidth width) {
  const KernelsByWidth<BoxTestKernels> all = {box_test_kernels_one(), box_test_kernels_two(), box_test_kernels_four(),
                                              box_test_kernels_eight()};
  return all.of(width);
}

}  // namespace tumble::sim
