#pragma once

#include "tumble/sim/result.h"

namespace tumble::sim {

/// Errors unless doubles round to nearest even and subnormal numbers survive. A library built with -ffast-math that is
/// loaded later can switch on flush-to-zero for the whole process, and every bit would change from there on.
Status check_float_environment();

/// Sets the calling thread's floating-point environment back to the default: to nearest even, subnormal numbers kept,
/// no exception trapped. For programs that load other people's drivers into their process; call between two steps.
void restore_float_environment();

}  // namespace tumble::sim
