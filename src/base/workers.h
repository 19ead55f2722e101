#pragma once

#include <algorithm>
#include <cstddef>

namespace tumble {

/// Hands that work at the same time, and all that the simulation knows of threads: it says what may be done side by
/// side, and somebody else (src/threads) owns the threads that do it. Which hand does what, and when, must not show in
/// any result.
class Workers {
 public:
  virtual ~Workers() = default;

  /// How many, the caller's own included; at least 1.
  [[nodiscard]] virtual unsigned count() const = 0;

  /// How many items a part must have for a split to pay, where a phase has measured `least`.
  [[nodiscard]] virtual std::size_t worth(std::size_t least) const { return least; }

  /// Calls task(context, part) for every part < parts <= count(), at the same time, and returns when all have
  /// returned. Tasks do not throw.
  virtual void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) = 0;
};

/// Items that a part must have for a split to pay, as measured on two cores: bodies, and batches of eight manifolds.
inline constexpr std::size_t kBodiesAPart = 32768, kBatchesAPart = 2048;

/// How many parts n items are split into, when a part should have `least` items for the split to pay.
inline unsigned part_count(const Workers* workers, std::size_t n, std::size_t least) {
  if (workers == nullptr) return 1;
  return static_cast<unsigned>(std::clamp<std::size_t>(n / workers->worth(least), 1, workers->count()));
}

/// Calls visit(part) for every part < parts, side by side.
template <class Visit>
void for_parts(Workers* workers, unsigned parts, Visit visit) {
  if (parts <= 1) return visit(0U);
  workers->run(
      parts, [](void* context, unsigned part) { (*static_cast<Visit*>(context))(part); }, &visit);
}

/// Calls visit(begin, end) for ranges that make up [0, n), side by side where each has `least` items or more.
template <class Visit>
void for_ranges(Workers* workers, std::size_t n, std::size_t least, Visit visit) {
  const unsigned parts = part_count(workers, n, least);
  for_parts(workers, parts, [&](unsigned part) { visit(n * part / parts, n * (part + 1) / parts); });
}

}  // namespace tumble
