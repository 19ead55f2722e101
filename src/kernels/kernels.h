#pragma once

#include "src/kernels/body_kernels.h"
#include "src/kernels/box_tests.h"
#include "src/kernels/contacts/contact_kernels.h"
#include "src/kernels/ground_contacts.h"

namespace tumble::sim {

/// All arithmetic that runs in lanes, as one table of functions for each lane width.
struct Kernels {
  BodyKernels bodies;
  BoxTestKernels box_tests;
  ContactKernels contacts;
  GroundKernels ground;
};

/// The table of a width (1, 2, 4 or 8 lanes); null where the compiler was not allowed that width's instructions. The
/// build compiles kernels.cc once for each width and so defines all four. Use kernels() of kernels_by_width.h instead,
/// which asks the machine too.
template <int kWidth>
const Kernels* compiled_kernels();
template <>
const Kernels* compiled_kernels<1>();
template <>
const Kernels* compiled_kernels<2>();
template <>
const Kernels* compiled_kernels<4>();
template <>
const Kernels* compiled_kernels<8>();

}  // namespace tumble::sim
