#include "replay/recover/salvage_choice.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "replay/format/chain.h"

namespace tumble::replay {
namespace {

/// The best sequence of chunks that ends with a given chunk.
struct Way {
  std::uint64_t steps = 0;
  std::uint64_t runs_missing = 0;
  std::optional<std::size_t> before;  // the chunk before; none: the sequence begins here
  Hash128 chain;                      // before the chunk, if linked
  bool linked = false;
};

bool better(const Way& a, const Way& b) {
  return std::make_pair(a.steps, b.runs_missing) > std::make_pair(b.steps, a.runs_missing);
}

/// Chooses by dynamic programming over the chunks in ascending order of their first step.
///
/// A damaged file may hold chunks of several sessions, second copies, and chunks whose prelude, and so whose place in
/// the chain, is lost. Taking the first chunk that fits may lead to a dead end, so for each chunk the best sequence
/// that ends with it is kept: the one with the most steps. A chunk follows either a chunk that it is linked to (its
/// first step comes next, and state hash and chain match), or any chunk that ends earlier, with missing steps between.
/// Among those that end earlier only the best one matters, and a queue ordered by end finds it, so the whole choice
/// costs n log n for n chunks. This is weighted interval scheduling (Kleinberg and Tardos, Algorithm Design, 2005,
/// section 6.1) with links.
///
/// A chunk with a lost prelude is accepted only where it is linked, because nothing else shows which session it belongs
/// to.
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
  /// Whether chunk i can be part of the session. Finds the best sequence that ends with it.
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
    if (chunk.chain_known) consider_missing(chunk, consider);
    if (!way || (!chunk.chain_known && !complete(chunk, *way))) return false;
    way->steps += chunk.prelude.step_count;
    ways_[i] = *way;
    by_end_.emplace(chunk.end_step(), i);
    ending_.emplace(chunk.end_step(), i);
    return true;
  }

  [[nodiscard]] Way after(std::size_t before, std::uint64_t runs_missing, bool linked) const {
    const Way& way = *ways_[before];
    return {way.steps, way.runs_missing + runs_missing, before, chunks_[before].prelude.chain_after, linked};
  }

  [[nodiscard]] std::optional<Hash128> start_chain(const SavedChunk& chunk) const {
    if (chunk.first_step() != start_.first_step) return std::nullopt;
    const bool known = chunk.chain_known;
    if (start_.continuation) {
      const std::optional<Hash128> chain = known ? std::optional(chunk.prelude.chain_before) : start_.chain;
      const bool fits = *start_.continuation == chunk.continuation_hash && (!start_.chain || chain == start_.chain);
      return fits ? chain : std::nullopt;
    }
    const bool header_lost = !start_.chain && known && chunk.prelude.major >= kExtrasMajor;
    if (header_lost) return chunk.prelude.chain_before;  // the values of the first state were in the header
    const Hash128 begin = chain_start(chunk.keyframe_hash, start_.extras);
    const bool fits = begin == start_.chain.value_or(begin) && (!known || begin == chunk.prelude.chain_before);
    return fits ? std::optional(begin) : std::nullopt;
  }

  static bool linked(const SavedChunk& a, const SavedChunk& b) {
    return a.final_hash == b.keyframe_hash && (!b.chain_known || a.prelude.chain_after == b.prelude.chain_before);
  }

  /// Considers missing steps before the chunk: behind the best sequence that ends earlier, or behind the start.
  template <class Consider>
  void consider_missing(const SavedChunk& chunk, const Consider& consider) {
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
