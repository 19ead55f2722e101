#pragma once

#include "src/base/result.h"

namespace tumble::sim {

/// Errors unless doubles round to nearest even and subnormals survive: a library built with -ffast-math that is loaded
/// later can switch on flush-to-zero for the whole process, and every bit would change from there.
Status check_float_environment();

}  // namespace tumble::sim
