#include <algorithm>
#include <array>

#include "golden/hunt/judge/laws.h"
#include "golden/hunt/judge/relation.h"
#include "golden/hunt/judge/same_bits.h"
#include "src/base/text.h"
#include "src/kernels/lane_width.h"

namespace tumble::hunt {
namespace {

Judgement judge_ids(const Trace& trace) {
  sim::Transform transform;
  transform.permute = kPermutation;
  return judge_image(trace, transform);
}
Judgement judge_mirror_x(const Trace& trace) { return judge_image(trace, {.mirror_x = true}); }
Judgement judge_mirror_y(const Trace& trace) { return judge_image(trace, {.mirror_y = true}); }
Judgement judge_swap(const Trace& trace) { return judge_image(trace, {.swap_xy = true}); }
Judgement judge_shift(const Trace& trace) { return judge_image(trace, {.shift = kShift}); }

Judgement judge_repeat(const Trace& trace) { return judge_again(trace, sim::LaneWidth::kWidest); }
Judgement judge_lanes(const Trace& trace) {
  using sim::LaneWidth;
  for (const LaneWidth lanes : {LaneWidth::kOne, LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight}) {
    if (!machine_has_lanes(lanes)) continue;
    Judgement one = judge_again(trace, lanes);
    if (one.outcome == Outcome::kHeld) continue;
    one.what = std::string("lanes of width ") + name_of(lanes) + ": " + one.what;
    return one;
  }
  return held();
}

constexpr std::array kRelations = {
    Relation{"finishes", "a session runs to its last step", true, judge_finishes},
    Relation{"start", "state 0 has the masses, sizes, materials and places of the scene", true, judge_start},
    Relation{"numbers", "every value is a number, on its grid; orientations have unit length", true, judge_numbers},
    Relation{"energy", "energy is never gained", true, judge_energy},
    Relation{"momentum", "bodies that touch nothing fixed keep their momentum", true, judge_momentum},
    Relation{"angular_momentum", "bodies that touch nothing fixed keep their angular momentum", true,
             judge_angular_momentum},
    Relation{"cone", "friction stays within Coulomb's cone", true, judge_cone},
    Relation{"overlap", "boxes do not overlap", true, judge_overlap},
    Relation{"parting", "boxes that begin inside one another part without speed", true, judge_parting},
    Relation{"unmet", "what does not meet pushes nothing", true, judge_unmet},
    Relation{"flight", "a free body flies its parabola and keeps its energy", true, judge_flight},
    Relation{"halved", "flights with half of dt end in one place", true, judge_halved},
    Relation{"slope", "a crate on a slope moves as Coulomb says", true, judge_slope},
    Relation{"bounce", "a box that lands flat bounces with its restitution", true, judge_bounce},
    Relation{"standing", "a stack whose weight lies above its faces stays", true, judge_standing},
    Relation{"ids", "other ids change no bit", false, judge_ids},
    Relation{"mirror_x", "the image mirrored in x moves as the image", false, judge_mirror_x},
    Relation{"mirror_y", "the image mirrored in y moves as the image", false, judge_mirror_y},
    Relation{"swap_xy", "the image with x and y swapped moves as the image", false, judge_swap},
    Relation{"shift", "the scene shifted horizontally moves alike", false, judge_shift},
    Relation{"repeat", "a session run again has the same bits", false, judge_repeat},
    Relation{"threads", "three threads change no bit of a step", false, judge_threads},
    Relation{"lanes", "no width of lanes changes a bit", false, judge_lanes},
    Relation{"resumed", "each step taken from a snapshot has the same bits", false, judge_resumed},
    Relation{"inserted", "the order in which bodies are added changes no bit", false, judge_inserted},
    Relation{"elsewhere", "what happens far away changes no bit", false, judge_elsewhere},
    Relation{"replayed", "a recorded session reads back and replays to the same bits", false, judge_replayed},
};

}  // namespace

std::span<const Relation> relations() { return kRelations; }

const Relation* find_relation(std::string_view name) {
  const auto found = std::ranges::find_if(kRelations, [name](const Relation& one) { return name == one.name; });
  return found == kRelations.end() ? nullptr : &*found;
}

std::string describe(const Judgement& judgement) {
  std::string text = "step " + std::to_string(judgement.step);
  if (!judgement.phase.empty()) text += ", phase " + judgement.phase;
  if (judgement.body != 0) text += ", body " + std::to_string(judgement.body);
  text += ": " + judgement.what;
  if (judgement.bound > 0) {
    text += ": " + rounded(judgement.value, judgement.unit) + ", allowed " + rounded(judgement.bound, judgement.unit);
  }
  return text;
}

}  // namespace tumble::hunt
