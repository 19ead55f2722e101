// Compiled with AVX2. No header of the project that has functions may be included: the linker keeps one copy of an
// inline function for the whole program, and a copy with AVX2 would crash on machines without it.
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
