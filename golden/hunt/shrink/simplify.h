#pragma once

#include <functional>
#include <vector>

#include "golden/hunt/judge/trace.h"
#include "tumble/sim/scene.h"

/// Simpler scenes than a given one: each function returns candidates, the boldest first.
namespace tumble::hunt {

using Candidates = std::vector<sim::SceneDef>;

/// The scene without some bodies (and all inputs that name them): halves first, then single ones.
Candidates fewer_bodies(const sim::SceneDef& scene);

/// Without some inputs: all, then single ones.
Candidates fewer_inputs(const sim::SceneDef& scene);

/// With fewer steps; `broken` is the step that leads to the state in which the relation broke.
Candidates fewer_steps(const sim::SceneDef& scene, std::uint64_t broken);

/// Beginning with a later state of the session, which then has no past: the last states before `broken` first.
Candidates later_starts(const Trace& trace, std::uint64_t broken);

/// With defaults of the world in place of the scene's own, one at a time; each body as a cube, at rest, upright, of
/// 1 kg, of the scene's material.
Candidates plainer(const sim::SceneDef& scene);

/// Ids 1, 2, …
Candidates renumbered(const sim::SceneDef& scene);

/// Every number of a scene that its text shows.
std::vector<double*> numbers_of(sim::SceneDef& scene);

/// A number with fewer digits, the fewest first; ends before the number itself.
std::vector<double> fewer_digits(double value);

}  // namespace tumble::hunt
