#include "golden/hunt/engine/engine_relations.h"

#include <algorithm>

#include "golden/hunt/judge/same_bits.h"
#include "golden/hunt/scene/neighbours.h"

namespace tumble::hunt {
namespace {

// Two sessions of the engine, the second of the scene under a transform.
Judgement compare(const Trace& one, const Trace& other, const sim::Transform& transform, const sim::IdMap& ids,
                  Others others = Others::kNone) {
  if (!one.failure.empty()) return not_applicable("the first session: " + one.failure);
  if (other.other_bodies) return broken(*other.other_bodies, 0, "the other session: " + other.failure);
  const std::size_t states = std::min(one.states.size(), other.states.size());
  for (std::size_t k = 0; k < states; ++k) {
    const auto difference =
        first_difference(one.states[k].bodies, other.states[k].bodies, transform, ids, Signs::kAlike, others);
    if (difference) return parted(k, *difference);
  }
  if (one.states.size() == other.states.size() && other.failure.empty()) return held();
  return broken(states, 0, "the other session ends there: " + other.failure);
}

Judgement compare_with(const Trace& trace, const sim::SceneDef& scene) {
  const Result<Trace> other = trace.again(scene);
  return other.ok() ? compare(trace, *other, {}, {}) : not_applicable("no such scene: " + other.error().message);
}

// An image is taken of the resolved scene, whose numbers lie on grids that a transform keeps.
Judgement judge_engine_image(const Trace& trace, const sim::Transform& transform) {
  const sim::SceneDef resolved = image_of(trace.scene, {}, {});
  const sim::IdMap ids = ids_under(resolved, transform);
  const Result<Trace> one = trace.again(resolved), other = trace.again(image_of(resolved, transform, ids));
  if (!one.ok()) return not_applicable("the resolved scene is none: " + one.error().message);
  if (!other.ok()) return not_applicable("the image is no scene: " + other.error().message);
  return compare(*one, *other, transform, ids);
}

Judgement judge_engine_inserted(const Trace& trace) {
  if (trace.scene.boxes.size() < 2) return not_applicable("one body has one order");
  sim::SceneDef reversed = trace.scene;
  std::ranges::reverse(reversed.boxes);
  return compare_with(trace, reversed);
}

Judgement judge_engine_elsewhere(const Trace& trace) {
  const std::optional<Neighboured> both = with_neighbours(trace.scene);
  if (!both) return not_applicable("no room for others");
  const Result<Trace> other = trace.again(both->scene);
  if (!other.ok()) return not_applicable("no scene with others: " + other.error().message);
  return compare(trace, *other, {}, {}, Others::kAllowed);
}

}  // namespace

Judgement judge_engine(const std::string& relation, const Trace& trace) {
  sim::Transform transform;
  if (relation == "repeat") return compare_with(trace, trace.scene);
  if (relation == "inserted") return judge_engine_inserted(trace);
  if (relation == "elsewhere") return judge_engine_elsewhere(trace);
  if (relation == "ids") {
    transform.permute = kPermutation;
  } else if (relation == "mirror_x") {
    transform.mirror_x = true;
  } else if (relation == "mirror_y") {
    transform.mirror_y = true;
  } else if (relation == "swap_xy") {
    transform.swap_xy = true;
  } else if (relation == "shift") {
    transform.shift = kShift;
  } else {
    return not_applicable("a relation between parts of Tumble");
  }
  return judge_engine_image(trace, transform);
}

}  // namespace tumble::hunt
