#include "golden/hunt/judge/features.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "golden/hunt/judge/mechanics.h"
#include "golden/hunt/judge/relation.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;

class Words {
 public:
  explicit Words(sim::Method method) : front_(method == sim::Method::kThesis ? "thesis: " : "layered: ") {}

  void add(const std::string& word) { all_.insert(front_ + word); }
  void add_if(bool yes, const char* word) {
    if (yes) add(word);
  }
  /// Every power of two up to a number: "4 contacts or more".
  void count(std::uint64_t n, const char* of) {
    for (std::uint64_t least = 1; least <= n; least *= 2) add(std::to_string(least) + " " + of + " or more");
  }
  /// Every thousandfold up to a ratio.
  void ratio(double largest, double smallest, const char* of) {
    for (double least = 1e3; smallest > 0 && largest / smallest >= least; least *= 1e3) {
      add(std::string(of) + " differ 10^" + std::to_string(std::lround(std::log10(least))) + " times");
    }
  }

  [[nodiscard]] std::vector<std::string> sorted() const { return {all_.begin(), all_.end()}; }

 private:
  std::string front_;
  std::set<std::string> all_;
};

void add_start(const Trace& trace, Words& words) {
  const Bodies& bodies = trace.states[0].bodies;
  if (bodies.size() == 0) return;
  words.ratio(std::ranges::max(bodies.mass), std::ranges::min(bodies.mass), "masses");
  double widest = 0, thinnest = bodies.half_extent[0].x();
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    widest = std::max(widest, bodies.half_extent[i].maxCoeff());
    thinnest = std::min(thinnest, bodies.half_extent[i].minCoeff());
    words.add_if(bodies.is_static[i] != 0, "a static body");
  }
  words.ratio(widest, thinnest, "edges");
  words.add_if(!trace.scene.world.ground, "no ground");
  words.add_if(trace.scene.world.air_drag > 0, "air drag");
  words.add_if(!begins_apart(trace, 1e-3), "boxes begin inside one another");
}

void add_freezing(const Trace& trace, std::size_t k, Words& words) {
  const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
  for (BodyIndex i = 0; i < begun.size(); ++i) {
    const auto j = after.find(begun.id[i]);
    if (!j || begun.is_static[i] != 0) continue;
    words.add_if(begun.frozen[i] == 0 && after.frozen[*j] != 0, "a body falls asleep");
    words.add_if(begun.frozen[i] != 0 && after.frozen[*j] == 0, "a body is woken by another");
  }
}

void add_ties(const sim::WorldState& state, Words& words) {
  words.add_if(std::ranges::any_of(state.pairs.planes, [](std::uint16_t axes) { return std::popcount(axes) > 1; }),
               "tied planes");
  const sim::ContactMemory& memory = state.contact_memory;
  for (std::size_t k = 0; k + 1 < memory.size(); ++k) {
    words.add_if(memory.a[k] == memory.b[k + 1] && memory.b[k] == memory.a[k + 1], "a pair of two tied manifolds");
  }
  words.add_if(std::ranges::any_of(memory.feature, [](sim::Feature f) { return f >= sim::crossing_feature(0, 0); }),
               "crossing edges");
}

bool sleeps(const Bodies& bodies, sim::BodyId id) {
  const auto row = bodies.find(id);
  return !row || bodies.frozen[*row] != 0;
}

// An island of the step before whose bodies, all awake still, meet in two groups or more.
void add_splits(const Trace& trace, std::size_t k, const std::vector<TouchingGroup>& before,
                const std::vector<TouchingGroup>& now, Words& words) {
  std::map<sim::BodyId, std::size_t> group_of;
  for (std::size_t g = 0; g < now.size(); ++g) {
    for (const sim::BodyId id : now[g].bodies) group_of[id] = g;
  }
  for (const TouchingGroup& island : before) {
    const bool asleep = std::ranges::any_of(
        island.bodies, [&](sim::BodyId id) { return !group_of.contains(id) || sleeps(trace.after(k).bodies, id); });
    if (island.bodies.size() < 2 || asleep) continue;
    std::set<std::size_t> parts, islands;
    for (const sim::BodyId id : island.bodies) {
      parts.insert(group_of[id]);
      if (now[group_of[id]].bodies.size() > 1) islands.insert(group_of[id]);
    }
    words.add_if(parts.size() > 1, "an island splits");
    words.add_if(islands.size() > 1, "an island splits into islands");
  }
}

// How near each law's bound came, in three classes.
void add_bounds(const Trace& trace, Words& words) {
  if (trace.external || !trace.failure.empty()) return;
  for (const Relation& law : relations()) {
    if (!law.is_law) continue;
    const Judgement one = law.judge(trace);
    for (const double percent : {50.0, 90.0, 99.0}) {
      if (one.outcome == Outcome::kHeld && one.bound > 0 && 100 * one.value >= percent * one.bound)
        words.add(std::string(law.name) + " reaches " + std::to_string(std::lround(percent)) + " % of its bound");
    }
  }
}

// before: the groups of the step before, which those of this one replace.
void add_step(const Trace& trace, std::size_t k, std::vector<TouchingGroup>& before, Words& words) {
  const TracedStep& step = trace.steps[k];
  words.count(step.counters.contacts, "contacts");
  if (trace.scene.world.method == sim::Method::kThesis) words.count(step.counters.substeps, "substeps");
  std::uint64_t islands = 0, largest = 0;
  std::vector<TouchingGroup> groups = groups_of(trace, k);
  for (const TouchingGroup& group : groups) {
    if (group.bodies.size() > 1) ++islands;
    largest = std::max<std::uint64_t>(largest, group.bodies.size());
  }
  add_splits(trace, k, before, groups, words);
  before = std::move(groups);
  words.count(islands, "islands");
  words.count(largest > 1 ? largest : 0, "bodies in an island");
  for (const sim::Command& input : step.inputs) words.add(std::string("input ") + name_of(input));
  words.add_if(step.counters.removed > 0, "energy of separation is taken back");
  words.add_if(step.fast_pairs, "a fast pair");
  words.add_if(step.hard_islands, "a hard island");
  words.add_if(step.lent_inertia, "lent inertia");
  words.add_if(step.parted, "overlaps are parted");
  add_freezing(trace, k, words);
  add_ties(trace.after(k), words);
}

}  // namespace

std::vector<std::string> features_of(const Trace& trace) {
  Words words(trace.scene.world.method);
  add_start(trace, words);
  std::vector<TouchingGroup> groups;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) add_step(trace, k, groups, words);
  add_bounds(trace, words);
  return words.sorted();
}

}  // namespace tumble::hunt
