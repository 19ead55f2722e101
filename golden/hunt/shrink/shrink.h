#pragma once

#include <cstdint>
#include <functional>

#include "golden/hunt/judge/relation.h"
#include "golden/hunt/scene/scene_text.h"

namespace tumble::hunt {

/// Judges a candidate by the relation that its original breaks. The trace is of the candidate.
using Test = std::function<Judgement(const Trace& trace, const TextScene& scene)>;

/// Computes the session of a candidate.
using Tracer = std::function<Result<Trace>(const sim::SceneDef& scene)>;

struct Shrunk {
  TextScene scene;
  Judgement judgement;
  std::uint64_t tried = 0;  ///< candidates that were judged
  bool least = false;       ///< nothing more can go; false: the bound on candidates, or the time, ended the search
};

/// The smallest scene that still breaks the relation, by delta debugging (Zeller and Hildebrandt 2002, Simplifying and
/// isolating failure-inducing input): bodies, inputs, steps, the past, settings and digits go one after the other until
/// none can. Counts candidates and no time, so the result is the same on every machine, unless `enough`, asked before
/// each candidate, ends the search. Precondition: `scene` breaks it, as `judgement` says.
Shrunk shrink(const TextScene& scene, const Judgement& judgement, const Test& test, const Tracer& tracer,
              std::uint64_t tries_most, const std::function<bool()>& enough = {});

}  // namespace tumble::hunt
