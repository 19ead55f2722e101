#pragma once

#include <cstdint>

namespace tumble {

/// A random number without a generator's state: a function of seed, counter and draw. A body gets one jitter, however
/// many numbers were drawn before, on every platform.
///
/// Source: SplitMix64's output mix (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014;
/// constants of Stafford's variant 13), chained over the three words.
inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t counter, std::uint64_t draw) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;  // 2⁶⁴ / golden ratio, odd
  const auto mix = [](std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  };
  return mix(mix(mix(seed + kGolden) + counter + kGolden) + draw + kGolden);
}

/// Uniform in [−1, 1), a multiple of 2⁻⁵².
inline double random_symmetric(std::uint64_t seed, std::uint64_t counter, std::uint64_t draw) {
  return static_cast<double>(random_bits(seed, counter, draw) >> 11) * 0x1p-52 - 1.0;
}

}  // namespace tumble
