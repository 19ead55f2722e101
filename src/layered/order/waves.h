#pragma once

#include <array>
#include <cstdint>

#include "src/world/scratch.h"

namespace tumble::sim {

/// What one of several workers does of a walk through bodies in waves: the bodies of a wave are treated at the same
/// time, and push those of the next one. Each body is pushed once at most. Which order the bodies of a wave have
/// depends on the workers, so no result may.
class Waves {
 public:
  /// bodies: the most that are pushed. All workers make one before they meet.
  Waves(WaveScratch& memory, std::size_t bodies, const Worker& worker) : memory_(memory), worker_(worker) {
    if (!worker.first()) return;
    memory_.bodies.resize(bodies);
    memory_.start.assign(1, 0);
    for (std::uint32_t& count : memory_.pushed) count = 0;
  }

  [[nodiscard]] const Worker& worker() const { return worker_; }

  /// Adds a body to the next wave, or to the first one.
  void push(BodyIndex i) {
    if (held_ == kHeld) flush();
    waiting_[held_++] = i;
  }

  /// Treats wave after wave, until none pushes a body: visit(body).
  template <class Visit>
  void walk(Visit visit) {
    for (;;) {
      flush();
      worker_.meet();
      const std::uint32_t begin = end_, count = memory_.pushed[wave_ % 3];
      end_ = begin + count;
      // Read by all before they met, and pushed to after they have met again.
      if (worker_.first()) memory_.pushed[(wave_ + 2) % 3] = 0;
      ++wave_;
      if (count == 0) return;
      if (worker_.first()) memory_.start.push_back(end_);
      const Worker::Share share = share_of(count);
      for (std::size_t k = share.begin; k < share.end; ++k) visit(memory_.bodies[begin + k]);
    }
  }

  /// Treats the waves again, the last one first.
  template <class Visit>
  void walk_back(Visit visit) const {
    for (std::size_t wave = memory_.start.size() - 1; wave-- > 0;) walk_through(wave, visit);
  }
  /// Treats the waves again, the first one first.
  template <class Visit>
  void walk_again(Visit visit) const {
    for (std::size_t wave = 0; wave + 1 < memory_.start.size(); ++wave) walk_through(wave, visit);
  }
  /// Treats all bodies of the waves at the same time.
  template <class Visit>
  void for_all(Visit visit) const {
    worker_.meet();
    const Worker::Share share = worker_.share(memory_.start.back());
    for (std::size_t k = share.begin; k < share.end; ++k) visit(memory_.bodies[k]);
  }

 private:
  static constexpr std::uint32_t kHeld = 32;  // bodies that a worker adds at a time
  static constexpr std::size_t kAlone = 32;   // bodies of a wave that one worker treats alone

  [[nodiscard]] Worker::Share share_of(std::size_t count) const {
    return worker_.share(count, count < kAlone ? 1 : worker_.parts);
  }
  template <class Visit>
  void walk_through(std::size_t wave, Visit visit) const {
    worker_.meet();
    const std::uint32_t begin = memory_.start[wave];
    const Worker::Share share = share_of(memory_.start[wave + 1] - begin);
    for (std::size_t k = share.begin; k < share.end; ++k) visit(memory_.bodies[begin + k]);
  }
  void flush() {
    if (held_ == 0) return;
    const std::uint32_t at = end_ + worker_.add(memory_.pushed[wave_ % 3], held_);
    for (std::uint32_t k = 0; k < held_; ++k) memory_.bodies[at + k] = waiting_[k];
    held_ = 0;
  }

  WaveScratch& memory_;
  Worker worker_;
  std::uint32_t wave_ = 0, end_ = 0;  // the wave that is pushed to; where it begins
  std::uint32_t held_ = 0;
  std::array<BodyIndex, kHeld> waiting_;
};

}  // namespace tumble::sim
