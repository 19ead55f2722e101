#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

  /// Whether parts take turns instead of running at the same time, to be timed: then none takes over another's work.
  [[nodiscard]] virtual bool take_turns() const { return false; }

  /// Calls task(context, part) for every part < parts at the same time and returns when all calls have returned.
  /// Precondition: parts <= count(). Tasks do not throw.
  virtual void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) = 0;

  /// Called by the task of a run, as often by each of its parts: returns when all parts have called, and then sees all
  /// that they have written. Returns whether one of them passed true.
  virtual bool meet(unsigned part, bool any) = 0;

  /// Called by the task of a run: says how far its part has come. Numbers of a part ascend within a run, from 1 on.
  virtual void post(unsigned part, std::uint32_t number) = 0;

  /// Called by the task of a run: returns when part `other` has posted `number` or more, and then sees all that it had
  /// written. Returns its last number.
  virtual std::uint32_t await(unsigned part, unsigned other, std::uint32_t number) = 0;
};

/// Items that a part must have for a split to pay: bodies, batches of eight manifolds, manifolds.
inline constexpr std::size_t kBodiesAPart = 1024, kBatchesAPart = 64, kManifoldsAPart = 512;

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

/// Numbers that several workers read and write at a time. What else a worker has written is seen by others when they
/// have met.
namespace shared {

template <class Number>
Number read(Number& number) {
  return std::atomic_ref(number).load(std::memory_order_relaxed);
}
template <class Number>
void write(Number& number, Number x) {
  std::atomic_ref(number).store(x, std::memory_order_relaxed);
}
/// Changes a number from `before` to `after`; false where it was another one.
template <class Number>
bool exchange(Number& number, Number before, Number after) {
  return std::atomic_ref(number).compare_exchange_strong(before, after, std::memory_order_relaxed);
}
/// Sets bits of a number whose other bits are set at the same time.
template <class Number>
void set_bits(Number& number, Number bits) {
  if ((read(number) & bits) != bits) std::atomic_ref(number).fetch_or(bits, std::memory_order_relaxed);
}
/// Adds to a sum to which others add at the same time, and returns what it was. Sums of doubles must be exact.
template <class Number>
Number add(Number& sum, Number x) {
  return std::atomic_ref(sum).fetch_add(x, std::memory_order_relaxed);
}
/// Lowers a minimum that others lower at the same time.
template <class Number>
void lower(Number& least, Number x) {
  for (Number now = read(least); x < now; now = read(least)) {
    if (exchange(least, now, x)) return;
  }
}

/// Likewise a maximum.
template <class Number>
void raise(Number& most, Number x) {
  for (Number now = read(most); now < x; now = read(most)) {
    if (exchange(most, now, x)) return;
  }
}

}  // namespace shared

/// Sets a byte that several workers may set at a time, all to 1. One that is set is not written, so that its line stays
/// with all who read it.
inline void mark(std::uint8_t& byte) {
  if (shared::read(byte) == 0) shared::write(byte, std::uint8_t{1});
}

/// A list that one worker fills while others fill theirs: where it ends stands in cache lines of its own, so that no
/// line travels between processors with each item.
template <class Item>
struct alignas(128) OwnList : std::vector<Item> {
  using std::vector<Item>::vector;
};

/// One of the workers that do a task together and meet on the way.
struct Worker {
  Workers* all = nullptr;
  unsigned part = 0, parts = 1;

  /// Waits for the others; whether one of them passed true.
  bool meet(bool any = false) const { return parts == 1 ? any : all->meet(part, any); }
  /// Tells the others how far this worker has come.
  void post(std::uint32_t number) const { all->post(part, number); }
  /// Waits until another worker has come as far; its last number.
  std::uint32_t await(unsigned other, std::uint32_t number) const { return all->await(part, other, number); }
  [[nodiscard]] bool first() const { return part == 0; }

  /// A range of items.
  struct Share {
    std::size_t begin = 0, end = 0;
  };
  /// This worker's range of n items; the first `of` workers have all of them.
  [[nodiscard]] Share share(std::size_t n, unsigned of) const {
    return part < of ? Share{n * part / of, n * (part + 1) / of} : Share{n, n};
  }
  [[nodiscard]] Share share(std::size_t n) const { return share(n, parts); }

  /// This worker's range of groups, whole ones, so that all workers get about one number of items. start: by group, its
  /// first item; one more at the end.
  [[nodiscard]] Share share_groups(std::span<const std::uint32_t> start) const {
    const std::span<const std::uint32_t> groups = start.first(start.size() - 1);
    const auto first_of = [&](unsigned worker) {
      const std::size_t item = std::size_t{start.back()} * worker / parts;
      return static_cast<std::size_t>(std::lower_bound(groups.begin(), groups.end(), item) - groups.begin());
    };
    return {first_of(part), part + 1 == parts ? groups.size() : first_of(part + 1)};
  }

  /// Adds to a sum to which others add at the same time, and returns what it was. Sums of doubles must be exact.
  template <class Number>
  Number add(Number& sum, Number x) const {
    if (parts > 1) return shared::add(sum, x);
    const Number before = sum;
    sum = before + x;
    return before;
  }
  /// Changes a number from `before` to `after`; false where it was another one, which others may have set.
  template <class Number>
  bool exchange(Number& number, Number before, Number after) const {
    if (parts > 1) return shared::read(number) == before && shared::exchange(number, before, after);
    if (number != before) return false;
    number = after;
    return true;
  }
  /// Sets a number that others set at the same time, all to one value.
  template <class Number>
  void put(Number& number, Number x) const {
    if (parts > 1) {
      shared::write(number, x);
    } else {
      number = x;
    }
  }
  /// Raises a maximum that others raise at the same time.
  template <class Number>
  void raise(Number& largest, Number x) const {
    if (parts == 1) {
      largest = std::max(largest, x);
      return;
    }
    const std::atomic_ref shared(largest);
    for (Number now = shared.load(std::memory_order_relaxed); now < x;) {
      if (shared.compare_exchange_weak(now, x, std::memory_order_relaxed)) return;
    }
  }
};

/// Calls task(worker) for `parts` workers at the same time: one round, however often the workers meet.
template <class Task>
void work_together(Workers* workers, unsigned parts, Task task) {
  for_parts(workers, parts, [&](unsigned part) { task(Worker{workers, part, parts}); });
}

/// Calls visit(begin, end) for consecutive ranges that make up [0, n), at the same time. A range has `least` items or
/// more; too few items make one range.
template <class Visit>
void for_ranges(Workers* workers, std::size_t n, std::size_t least, Visit visit) {
  const unsigned parts = part_count(workers, n, least);
  for_parts(workers, parts, [&](unsigned part) { visit(n * part / parts, n * (part + 1) / parts); });
}

}  // namespace tumble
