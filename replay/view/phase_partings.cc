#include "replay/view/phase_partings.h"

#include <algorithm>
#include <set>

namespace tumble::replay {

Result<PhasePartings> phase_partings(LogReader& a, LogReader& b, std::uint64_t from, const Progress& progress) {
  const auto engine = [](const LogReader& log) { return log.header().engine.value_or(EngineName()).name; };
  if (engine(a) != engine(b)) return bad_input("the logs are of two engines, whose phase hashes mean different things");
  if (!same_phase_words(a.header(), b.header())) return bad_input("phase hashes of the two logs cannot be compared");
  PhasePartings found;
  found.from = from;
  found.last = std::min(a.last_step(), b.last_step());
  for (const std::string& name : a.header().phases) found.phases.push_back({name, {}, 0, 0});
  const std::size_t count = found.phases.size();
  if (count == 0 || a.header().hashes.every == 0 || b.header().hashes.every == 0)
    return bad_input("a log holds no phase hashes");
  for (std::uint64_t k = from; k <= found.last; ++k) {
    if (!a.holds(k) || !b.holds(k) || !same_phase_words(a.header(), b.header(), k)) continue;
    const Result<const StepRecord*> in_a = a.read_hashes(k);
    if (!in_a.ok()) return in_a.error();
    const Result<const StepRecord*> in_b = b.read_hashes(k);
    if (!in_b.ok()) return in_b.error();
    const auto &one = (*in_a)->phase_words, &other = (*in_b)->phase_words;
    std::set<std::size_t> parted;
    for (std::size_t w = 0; w < std::max(one.size(), other.size()); ++w) {
      if (w < one.size() && w < other.size() && one[w] == other[w]) continue;
      PhaseParting& phase = found.phases[w % count];
      if (parted.insert(w % count).second) ++phase.steps;
      if (phase.step) continue;
      phase.step = k;
      phase.substep = static_cast<std::uint32_t>(w / count);
    }
    if (progress && !progress(k - from, found.last - from)) return cannot_finish("interrupted");
  }
  return found;
}

}  // namespace tumble::replay
