// Loaded into a program with LD_PRELOAD: does to its arithmetic what a library built with -ffast-math does.
#include <cfenv>
#include <cstdlib>
#include <cstring>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

__attribute__((constructor)) void set_environment() {
  const char* what = std::getenv("WRONG_FLOATS");
  if (what == nullptr) return;
  if (std::strcmp(what, "upward") == 0) std::fesetround(FE_UPWARD);
#ifdef __SSE2__
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  if (std::strcmp(what, "ftz") == 0) _mm_setcsr(_mm_getcsr() | kFlushToZero);
  if (std::strcmp(what, "daz") == 0) _mm_setcsr(_mm_getcsr() | kDenormalsAreZero);
#endif
}

}  // namespace
