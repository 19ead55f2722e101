#pragma once

#include <cstddef>

namespace tumble {

/// Adds bytes to an XXH3_state_t. The digest is the same whatever instructions it is done with.
using HashUpdate = void (*)(void* state, const void* bytes, std::size_t count);

/// With AVX2, which this machine may lack; null where the compiler had none.
HashUpdate hash_update_avx2();

}  // namespace tumble
