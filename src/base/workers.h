#pragma once

#include <algorithm>
#include <cstddef>

namespace tumble {

/// Workers that run at the same time: all that the simulation knows of threads. A phase says which parts of its work
/// are independent; src/threads owns the threads that do them. No result may depend on which worker does a part, or
/// when.
class Workers {
 public:
  virtual ~Workers() = default;

  /// The number of workers, the calling thread included; at least 1.
  [[nodiscard]] virtual unsigned count() const = 0;

  /// The number of items a part must have for a split to pay; `least` is the number that a phase has measured.
  [[nodiscard]] virtual std::size_t worth(std::size_t least) const { return least; }

  /// Calls task(context, part) for every part < parts at the same time and returns when all calls have returned.
  /// Precondition: parts <= count(). Tasks do not throw.
  virtual void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) = 0;
};

/// Items that a part must have for a split to pay, as measured on two cores: bodies, and batches of eight manifolds.
inline constexpr std::size_t kBodiesAPart = 32768, kBatchesAPart = 2048;

/// The number of parts that n items are split into, so that each part has about `least` items or more.
inline unsigned part_count(const Workers* workers, std::size_t n, std::size_t least) {
  if (workers == nullptr) return 1;
  return static_cast<unsigned>(std::clamp<std::size_t>(n / workers->worth(least), 1, workers->count()));
}

/// Calls visit(part) for every part < parts, at the same time.
template <class Visit>
void for_parts(Workers* workers, unsigned parts, Visit visit) {
  if (parts <= 1) return visit(0U);
  workers->run(
      parts, [](void* context, unsigned part) { (*static_cast<Visit*>(context))(part); }, &visit);
}

/// Calls visit(begin, end) for consecutive ranges that make up [0, n), at the same time. A range has `least` items or
/// more; too few items make one range.
template <class Visit>
void for_ranges(Workers* workers, std::size_t n, std::size_t least, Visit visit) {
  const unsigned parts = part_count(workers, n, least);
  for_parts(workers, parts, [&](unsigned part) { visit(n * part / parts, n * (part + 1) / parts); });
}

}  // namespace tumble
