#include "src/kernels/body_kernels.h"

#include "src/kernels/kernels_by_width.h"

namespace tumble::sim {

const BodyKernels* body_kernels(LaneWidth width) {
  const KernelsByWidth<BodyKernels> all = {body_kernels_one(), body_kernels_two(), body_kernels_four(),
                                           body_kernels_eight()};
  return all.of(width);
}

}  // namespace tumble::sim
