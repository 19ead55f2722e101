#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "src/world/for_bodies.h"
#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/workers.h"

/// What a phase writes is hashed block by block right after it is computed, while its lines lie in the nearest cache;
/// read again at the end of the phase, the same bytes take three times as long and push others out of the caches.
namespace tumble::sim {

/// Bodies and batches of manifolds that are computed and then hashed at a time: some kB.
inline constexpr std::size_t kBodiesABlock = 64, kBatchesABlock = 2;

/// Takes the hasher of a phase that feeds it all that its hash function would, in that order; null: nobody asks, or
/// several workers write, and the hash function is called when the phase is done.
inline Hasher* take_hasher(Scratch& scratch) {
  scratch.fed_hasher = scratch.hasher;
  return scratch.hasher;
}

/// As for_ranges; with a hasher, one block after the other, each followed by hash(begin, end).
template <class Visit, class Hash>
void for_hashed_ranges(Hasher* hasher, Workers* workers, std::size_t n, std::size_t least, std::size_t block,
                       Visit visit, Hash hash) {
  if (hasher == nullptr) return for_ranges(workers, n, least, visit);
  for (std::size_t begin = 0; begin < n; begin += block) {
    const std::size_t end = std::min(begin + block, n);
    visit(begin, end);
    hash(begin, end);
  }
}

/// As for_bodies; with a hasher likewise.
template <class Visit, class Hash>
void for_hashed_bodies(Hasher* hasher, const Scratch& scratch, std::size_t n, std::size_t block, Visit visit,
                       Hash hash) {
  if (hasher == nullptr) return for_bodies(scratch, n, visit);
  for_hashed_ranges(hasher, nullptr, n, kBodiesAPart, block, visit, hash);
}

/// Numbers that lie apart, gathered for a hasher. They reach it at the latest when the object ends, and before that in
/// order only if nothing else is added meanwhile. Two buffers take turns, since a number that is read right after it
/// was written waits for all that was written before.
class GatheredNumbers {
 public:
  /// Without a hasher nothing may be added.
  explicit GatheredNumbers(Hasher* hasher) : hasher_(hasher) {}
  ~GatheredNumbers() { pass_on(); }
  GatheredNumbers(const GatheredNumbers&) = delete;
  GatheredNumbers& operator=(const GatheredNumbers&) = delete;

  /// The place of the next `count` numbers, at most 32.
  double* next(std::size_t count) {
    if (count_ + count > kMost) take_turns();
    return numbers_[now_] + (count_ += count) - count;
  }
  /// Many numbers that lie together.
  void add(std::span<const double> numbers) {
    pass_on();
    hasher_->add(numbers);
  }
  void add(const Vec3& v) {
    double* const to = next(3);
    for (int k = 0; k < 3; ++k) to[k] = v[k];
  }
  void add(const Quat& q) {
    double* const to = next(4);
    to[0] = q.w, to[1] = q.x, to[2] = q.y, to[3] = q.z;
  }
  /// The hasher then has all.
  void pass_on() {
    take_turns();
    take_turns();
  }

 private:
  static constexpr std::size_t kMost = 256;  // 2 kB

  // Passes on the older numbers, which leaves their buffer for the next ones.
  void take_turns() {
    now_ = 1 - now_;
    if (older_ > 0) hasher_->add(std::span<const double>(numbers_[now_], older_));
    older_ = count_;
    count_ = 0;
  }

  Hasher* hasher_;
  unsigned now_ = 0;                   // the buffer of the next number
  std::size_t count_ = 0, older_ = 0;  // in it; in the other one
  alignas(64) double numbers_[2][kMost];
};

/// Adds numbers of the bodies in collisions, of method thesis: the phases after compute_impulses change no others, and
/// read no others. add(numbers, body) adds those of one body.
template <class Add>
void add_touched(const Scratch& scratch, Hasher& hasher, Add add) {
  GatheredNumbers numbers(&hasher);
  for (BodyIndex i = 0; i < scratch.touched.size(); ++i) {
    if (scratch.touched[i] != 0) add(numbers, i);
  }
}

}  // namespace tumble::sim
