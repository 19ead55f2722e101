#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "src/world/scratch.h"

namespace tumble::sim {

/// What one of several workers does of a walk through bodies in waves: the bodies of a wave are treated at the same
/// time, and push those of the next one. Each body is pushed once at most. The bodies of a wave are those that the
/// first worker has pushed, then those of the next one, and so on, cut evenly: so a worker mostly treats bodies that it
/// has pushed itself, whose lines its processor holds. Where bodies have homes, each worker treats its own. Which order
/// they have depends on the workers, so no result may.
class Waves {
 public:
  /// bodies: all of the world. homes: of these; where they fit, each worker treats its own.
  Waves(std::vector<WaveScratch>& memory, std::size_t bodies, const Homes& homes, const Worker& worker)
      : worker_(worker), homes_(homes.fit(bodies, worker.parts) ? &homes : nullptr) {
    if (worker.first() && memory.size() < worker.parts) memory.resize(worker.parts);
    worker.meet();
    all_ = std::span(memory).first(worker.parts);
    own_ = &memory[worker.part];
    for (std::vector<BodyIndex>* const list : {&own_->pushed[0], &own_->pushed[1], &own_->taken}) {
      list->clear();
      list->reserve(bodies);  // so that a warm step allocates nothing
    }
    for (std::vector<BodyIndex>& sent : own_->sent) {
      sent.clear();
      if (homes_ != nullptr) sent.reserve(bodies);
    }
    own_->start.assign(1, 0);
  }

  [[nodiscard]] const Worker& worker() const { return worker_; }

  /// Adds a body to the next wave, or to the first one.
  void push(BodyIndex i) {
    const bool at_home = homes_ == nullptr || homes_->worker_of(i) == worker_.part;
    (at_home ? own_->pushed : own_->sent)[wave_ % 2].push_back(i);
  }

  /// Treats wave after wave, until none pushes a body: visit(body).
  template <class Visit>
  void walk(Visit visit) {
    for (;;) {
      worker_.meet();
      const unsigned now = wave_++ % 2;
      // Of the wave before, which all have treated.
      own_->pushed[wave_ % 2].clear();
      own_->sent[wave_ % 2].clear();
      if (homes_ != nullptr ? !take_home(now) : !take(now)) return;
      for (std::size_t k = own_->start[wave_ - 1]; k < own_->start[wave_]; ++k) visit(own_->taken[k]);
    }
  }

  /// Treats the waves again, the last one first.
  template <class Visit>
  void walk_back(Visit visit) const {
    for (std::size_t wave = own_->start.size() - 1; wave-- > 0;) walk_through(wave, visit);
  }
  /// Treats the waves again, the first one first.
  template <class Visit>
  void walk_again(Visit visit) const {
    for (std::size_t wave = 0; wave + 1 < own_->start.size(); ++wave) walk_through(wave, visit);
  }
  /// Treats all bodies of the waves at the same time.
  template <class Visit>
  void for_all(Visit visit) const {
    worker_.meet();
    for (const BodyIndex i : own_->taken) visit(i);
  }

 private:
  static constexpr std::size_t kAlone = 32;  // bodies of a wave that one worker treats alone

  // Takes this worker's share of a wave; false: the wave is empty.
  bool take(unsigned now) {
    std::size_t count = 0;
    for (const WaveScratch& of : all_) count += of.pushed[now].size();
    if (count == 0) return false;
    const Worker::Share share = worker_.share(count, count < kAlone ? 1 : worker_.parts);
    std::size_t before = 0;
    for (const WaveScratch& of : all_) {
      const std::vector<BodyIndex>& pushed = of.pushed[now];
      const std::size_t begin = std::max(share.begin, before), end = std::min(share.end, before + pushed.size());
      for (std::size_t k = begin; k < end; ++k) own_->taken.push_back(pushed[k - before]);
      before += pushed.size();
    }
    own_->start.push_back(static_cast<std::uint32_t>(own_->taken.size()));
    return true;
  }
  // Likewise the bodies that are at home with this worker.
  bool take_home(unsigned now) {
    std::size_t count = 0;
    for (const WaveScratch& of : all_) count += of.pushed[now].size() + of.sent[now].size();
    if (count == 0) return false;
    own_->taken.insert(own_->taken.end(), own_->pushed[now].begin(), own_->pushed[now].end());
    for (const WaveScratch& of : all_) {
      for (const BodyIndex i : of.sent[now]) {
        if (homes_->worker_of(i) == worker_.part) own_->taken.push_back(i);
      }
    }
    own_->start.push_back(static_cast<std::uint32_t>(own_->taken.size()));
    return true;
  }
  template <class Visit>
  void walk_through(std::size_t wave, Visit visit) const {
    worker_.meet();
    for (std::size_t k = own_->start[wave]; k < own_->start[wave + 1]; ++k) visit(own_->taken[k]);
  }

  Worker worker_;
  const Homes* homes_ = nullptr;
  std::span<const WaveScratch> all_;
  WaveScratch* own_ = nullptr;
  std::uint32_t wave_ = 0;  // that is pushed to
};

}  // namespace tumble::sim
