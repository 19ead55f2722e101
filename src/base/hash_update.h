#pragma once

#include <cstddef>

namespace tumble {

/// Adds bytes to an XXH3_state_t. Every implementation gives the same digest.
using HashUpdate = void (*)(void* state, const void* bytes, std::size_t count);

/// The implementations with AVX2 and with AVX-512 (F); null where the compiler was not allowed these instructions. Ask
/// the processor before calling.
HashUpdate hash_update_avx2();
HashUpdate hash_update_avx512();

}  // namespace tumble
