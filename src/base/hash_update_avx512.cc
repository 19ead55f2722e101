// Compiled with AVX-512. No header of the project that has functions may be included: see hash_update_avx2.cc.
#include "src/base/hash_update.h"

#ifdef __AVX512F__
// What GCC 12's own header leaves undefined on purpose is no mistake (its bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#ifndef XXH_VECTOR
#define XXH_VECTOR XXH_AVX512
#endif
#define XXH_NO_PREFETCH  // columns are read in order: such a processor fetches ahead by itself
#define XXH_INLINE_ALL
#include <xxhash.h>
#endif

namespace tumble {

HashUpdate hash_update_avx512() {
#ifdef __AVX512F__
  return [](void* state, const void* bytes, std::size_t count) {
    XXH3_128bits_update(static_cast<XXH3_state_t*>(state), bytes, count);
  };
#else
  return nullptr;
#endif
}

}  // namespace tumble
