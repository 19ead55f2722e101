#include "replay/recover/salvage_choice.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "replay/format/chain.h"

namespace tumble::replay {
namespace {

/// The best way to come to a chunk, as a chain of chunks that ends with it.
struct Way {
  std::uint64_t steps = 0;
  std::uint64_t gaps = 0;
  std::optional<std::size_t> before;  // the chunk before it
  Hash128 chain;                      // before the chunk, where it is linked
  bool linked = false;
};

bool better(const Way& a, const Way& b) { return std::make_pair(a.steps, b.gaps) > std::make_pair(b.steps, a.gaps); }

class Chooser {
 public:
  Chooser(std::vector<SavedChunk> candidates, const SessionStart& start, const ChainAfter& chain_after)
      : chunks_(std::move(candidates)), start_(start), chain_after_(chain_after), ways_(chunks_.size()) {
    std::ranges::sort(chunks_, {}, [](const SavedChunk& c) { return std::make_tuple(c.first_step(), c.payload); });
  }

  std::vector<SavedChunk> run() {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      if (!reach(i)) continue;
      if (!best || better(*ways_[i], *ways_[*best])) best = i;
    }
    std::vector<SavedChunk> chosen;
    for (; best; best = ways_[*best]->before) chosen.push_back(chunks_[*best]);
    std::ranges::reverse(chosen);
    return chosen;
  }

 private:
  /// Whether chunk i can be part of the session; if so, its best way is known.
  bool reach(std::size_t i) {
    SavedChunk& chunk = chunks_[i];
    std::optional<Way> way;
    const auto consider = [&](const Way& other) {
      if (!way || better(other, *way)) way = other;
    };
    if (const std::optional<Hash128> chain = start_chain(chunk)) consider({0, 0, std::nullopt, *chain, true});
    const auto [from, to] = by_end_.equal_range(chunk.first_step());
    for (auto it = from; it != to; ++it) {
      if (linked(chunks_[it->second], chunk)) consider(after(it->second, 0, true));
    }
    if (chunk.chain_known) consider_gap(chunk, consider);
    if (!way || (!chunk.chain_known && !complete(chunk, *way))) return false;
    way->steps += chunk.prelude.step_count;
    ways_[i] = *way;
    by_end_.emplace(chunk.end_step(), i);
    ending_.emplace(chunk.end_step(), i);
    return true;
  }

  [[nodiscard]] Way after(std::size_t before, std::uint64_t gaps, bool linked) const {
    const Way& way = *ways_[before];
    return {way.steps, way.gaps + gaps, before, chunks_[before].prelude.chain_after, linked};
  }

  [[nodiscard]] std::optional<Hash128> start_chain(const SavedChunk& chunk) const {
    if (chunk.first_step() != start_.first_step) return std::nullopt;
    const bool known = chunk.chain_known;
    if (start_.continuation) {
      const std::optional<Hash128> chain = known ? std::optional(chunk.prelude.chain_before) : start_.chain;
      const bool fits = *start_.continuation == chunk.continuation_hash && (!start_.chain || chain == start_.chain);
      return fits ? chain : std::nullopt;
    }
    const Hash128 begin = chain_start(chunk.keyframe_hash);
    const bool fits = begin == start_.chain.value_or(begin) && (!known || begin == chunk.prelude.chain_before);
    return fits ? std::optional(begin) : std::nullopt;
  }

  static bool linked(const SavedChunk& a, const SavedChunk& b) {
    return a.final_hash == b.keyframe_hash && (!b.chain_known || a.prelude.chain_after == b.prelude.chain_before);
  }

  /// After the best of the chunks that end before the step before this one; or as the first of all.
  template <class Consider>
  void consider_gap(const SavedChunk& chunk, const Consider& consider) {
    while (!ending_.empty() && ending_.top().first < chunk.first_step()) {
      const std::size_t i = ending_.top().second;
      ending_.pop();
      if (!best_ended_ || better(*ways_[i], *ways_[*best_ended_])) best_ended_ = i;
    }
    const bool may_begin =
        chunk.first_step() > start_.first_step;  // what begins like the session but is not it may not
    if (may_begin) consider({0, 1, std::nullopt, chunk.prelude.chain_before, false});
    if (best_ended_) consider(after(*best_ended_, 1, false));
  }

  bool complete(SavedChunk& chunk, const Way& way) const {
    const std::optional<Hash128> chain = chain_after_(chunk, way.chain);
    if (!chain) return false;
    chunk.prelude.chain_before = way.chain;
    chunk.prelude.chain_after = *chain;
    return true;
  }

  std::vector<SavedChunk> chunks_;
  const SessionStart& start_;
  const ChainAfter& chain_after_;
  std::vector<std::optional<Way>> ways_;
  std::multimap<std::uint64_t, std::size_t> by_end_;
  using Ending = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Ending, std::vector<Ending>, std::greater<>> ending_;
  std::optional<std::size_t> best_ended_;
};

}  // namespace

std::vector<SavedChunk> choose_chunks(std::vector<SavedChunk> candidates, const SessionStart& start,
                                      const ChainAfter& chain_after) {
  return Chooser(std::move(candidates), start, chain_after).run();
}

}  // namespace tumble::replay
