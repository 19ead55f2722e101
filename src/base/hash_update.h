#pragma once

#include <cstddef>

namespace tumble {

/// Adds bytes to an XXH3_state_t. Every implementation gives the same digest.
using HashUpdate = void (*)(void* state, const void* bytes, std::size_t count);

/// The implementation with AVX2; null where the compiler was not allowed AVX2. Ask the processor before calling.
HashUpdate hash_update_avx2();

}  // namespace tumble
