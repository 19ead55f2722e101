// No header of the project that has functions may be included: one compiled for a wide machine must never be the one
// that the linker keeps for all.
#include "src/base/hash_update.h"

#ifdef __AVX2__
#ifndef XXH_VECTOR
#define XXH_VECTOR XXH_AVX2
#endif
#define XXH_INLINE_ALL
#include <xxhash.h>
#endif

namespace tumble {

HashUpdate hash_update_avx2() {
#ifdef __AVX2__
  return [](void* state, const void* bytes, std::size_t count) {
    XXH3_128bits_update(static_cast<XXH3_state_t*>(state), bytes, count);
  };
#else
  return nullptr;
#endif
}

}  // namespace tumble
