#include "replay/stream_states.h"

#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace tumble::replay {
namespace {

void stream(const std::byte* from, std::byte* to, std::size_t count) {
  std::size_t i = 0;
#ifdef __SSE2__
  if (reinterpret_cast<std::uintptr_t>(to) % sizeof(__m128i) == 0) {
    for (; i + sizeof(__m128i) <= count; i += sizeof(__m128i)) {
      _mm_stream_si128(reinterpret_cast<__m128i*>(to + i), _mm_loadu_si128(reinterpret_cast<const __m128i*>(from + i)));
    }
  }
#endif
  std::memcpy(to + i, from + i, count - i);
}

template <class T>
void stream(const std::vector<T>& from, std::vector<T>& to) {
  if (from.empty()) return to.clear();
  to.resize(from.size());
  stream(reinterpret_cast<const std::byte*>(from.data()), reinterpret_cast<std::byte*>(to.data()),
         from.size() * sizeof(T));
}

void stream(const sim::Vec3Column& from, sim::Vec3Column& to) {
  stream(from.x, to.x);
  stream(from.y, to.y);
  stream(from.z, to.z);
}

}  // namespace

void stream_visible(const sim::Bodies& bodies, BodyStates& states) {
  stream(bodies.id, states.id);
  stream(bodies.position, states.position);
  stream(bodies.orientation.w, states.orientation.w);
  stream(bodies.orientation.x, states.orientation.x);
  stream(bodies.orientation.y, states.orientation.y);
  stream(bodies.orientation.z, states.orientation.z);
  stream(bodies.velocity, states.velocity);
  stream(bodies.spin, states.spin);
  stream(bodies.frozen, states.frozen);
#ifdef __SSE2__
  _mm_sfence();  // before the states are handed over
#endif
}

}  // namespace tumble::replay
