#pragma once

#include <string>

#include "tumble/sim/result.h"

namespace tumble::render {

/// The library that makes the off-screen context. Both give equal pixels.
enum class Backend { kAuto, kOsmesa, kEgl };

/// "auto", "osmesa" or "egl". Errors (kBadInput): anything else.
Result<Backend> parse_backend(const std::string& word);

}  // namespace tumble::render
