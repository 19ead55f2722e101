#include "src/kernels/contact_kernels.h"

#include "src/kernels/body_kernels.h"
#include "src/kernels/box_tests.h"
#include "src/kernels/kernels_by_width.h"

namespace tumble::sim {
namespace {

KernelsByWidth<ContactKernels> all() {
  return {contact_kernels_one(), contact_kernels_two(), contact_kernels_four(), contact_kernels_eight()};
}

}  // namespace

bool runs_lanes(LaneWidth width) {
  return all().of(width) != nullptr && box_test_kernels(width) != nullptr && body_kernels(width) != nullptr;
}

const ContactKernels& contact_kernels(LaneWidth width) { return *all().of(width); }

}  // namespace tumble::sim
