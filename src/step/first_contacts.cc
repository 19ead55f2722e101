#include "src/step/first_contacts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "src/collide/box_pair.h"
#include "src/layered/find/contact_memory.h"
#include "src/layered/find/find_manifolds.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/thesis/contact_objects.h"
#include "src/thesis/find_pairs.h"
#include "src/world/edit_bodies.h"
#include "src/world/forget_contacts.h"
#include "src/world/scratch.h"
#include "tumble/sim/limits.h"

namespace tumble::sim {
namespace {

constexpr double kFirstTouch = 1e-3;  // m apart
constexpr double kOneWay = 0.99;      // cosine between normals that count as one direction

// The state with boxes grown by half of kFirstTouch on every side: the copies overlap where the originals touch.
WorldState grown(const WorldState& state) {
  WorldState copy = state;
  Bodies& bodies = copy.bodies;
  const Vec3 growth = Vec3::Constant(kFirstTouch / 2);
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies.half_extent.set(i, bodies.half_extent[i] + growth);
  return copy;
}

// The direction in which two grown boxes touch; none if they meet only at an edge or a corner, where they barely
// overlap in more than one direction.
std::optional<Vec3> touch_normal(const BoxPair& pair) {
  if (pair.separating(kFaces | kEdges) != 0) return std::nullopt;
  const BestAxes best = pair.best(kFaces);
  if (best.axes == 0) return std::nullopt;
  const Vec3 normal = pair.normal(std::countr_zero(best.axes));
  for (int axis = 0; axis < 6; ++axis) {
    const BestAxes other = pair.best(only(axis));
    const bool barely = other.axes != 0 && other.separation > -2 * kFirstTouch;
    if (barely && std::fabs(dot(pair.normal(axis), normal)) < kOneWay) return std::nullopt;
  }
  return normal;
}

Contacts touching_contacts(WorldState& copy) {
  Scratch scratch;
  (void)find_pairs(copy, scratch, 0);
  Contacts contacts;
  const auto add = [&](BodyIndex a, BodyIndex b, const Vec3& normal) {
    contacts.a.push_back(a);
    contacts.b.push_back(b);
    contacts.normal.push_back(normal);
  };
  const PairTable& pairs = copy.pairs;
  const std::vector<BoxFrame>& frames = scratch.frames;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto normal = touch_normal(BoxPair(frames[pairs.a[k]], frames[pairs.b[k]]));
    if (normal) add(pairs.a[k], pairs.b[k], *normal);
  }
  const bool ground = copy.def.ground;
  for (BodyIndex i = 0; ground && i < frames.size(); ++i) {
    if (reach_along(frames[i], 2) > frames[i].position.z()) add(i, kGround, Vec3(0, 0, -1));
  }
  return contacts;
}

void find_objects(WorldState& state, const std::vector<std::uint8_t>& wanted) {
  WorldState copy = grown(state);
  const Contacts contacts = touching_contacts(copy);
  FreezeScratch freezing;
  for (const std::uint8_t ready : wanted) {
    freezing.candidates.push_back({ready != 0, std::numeric_limits<double>::infinity()});
  }
  collect_contact_objects(copy, contacts, freezing);
  const ContactObjects& found = freezing.found;
  ContactObjects& objects = state.contact_objects;
  ContactObjects merged;
  std::size_t k = 0;
  for (std::size_t j = 0; j <= found.size(); ++j) {
    const BodyIndex limit = j < found.size() ? found.body[j] : kGround;
    for (; k < objects.size() && objects.body[k] < limit; ++k) merged.push_back(objects.body[k], objects.object[k]);
    if (j < found.size()) merged.push_back(found.body[j], found.object[j]);
  }
  objects = merged;
}

// Finds the contacts in a copy of the state in which all bodies are awake; the impulses start at zero.
void find_memory(WorldState& state, const std::vector<std::uint8_t>& wanted) {
  const Bodies& bodies = state.bodies;
  WorldState awake = state;
  std::fill(awake.bodies.frozen.begin(), awake.bodies.frozen.end(), std::uint8_t{0});
  Scratch scratch;
  (void)find_near_pairs(awake, scratch, kDtMin);
  (void)find_manifolds(awake, scratch, kDtMin);
  const auto is_wanted = [&](BodyIndex i) { return i != kGround && wanted[i] != 0; };
  const auto rests = [&](BodyIndex i) { return i == kGround || !bodies.moves(i); };
  ManifoldList kept;
  for (const Manifold& m : scratch.manifolds) {
    const auto points = points_of(std::as_const(scratch), m);
    const bool close = std::any_of(points.begin(), points.end(),
                                   [](const ManifoldPoint& point) { return point.separation < kFirstTouch; });
    if (!close || !((is_wanted(m.a) && rests(m.b)) || (is_wanted(m.b) && rests(m.a)))) continue;
    kept.manifolds.push_back(m);
    kept.manifolds.back().first = static_cast<std::uint32_t>(kept.points.size());
    kept.points.insert(kept.points.end(), points.begin(), points.end());
  }
  const ContactMemory before = state.contact_memory;
  remember_contacts(kept.manifolds, kept.points, &before, {}, nullptr, state.contact_memory);
}

}  // namespace

void find_first_contacts(WorldState& state, std::optional<BodyIndex> body) {
  const Bodies& bodies = state.bodies;
  std::vector<std::uint8_t> wanted(bodies.size(), 0);
  for (BodyIndex i = 0; i < bodies.size(); ++i)
    wanted[i] = body ? static_cast<std::uint8_t>(i == *body) : bodies.frozen[i];
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) return;
  if (state.def.method == Method::kThesis) {
    find_objects(state, wanted);
  } else {
    find_memory(state, wanted);
  }
}

void wake_touched(WorldState& state, BodyIndex i) {
  const Bodies& bodies = state.bodies;
  const auto frame = [&](BodyIndex k) {
    const Vec3 half_extent = bodies.half_extent[k] + Vec3::Constant(kFirstTouch / 2);
    return BoxFrame{bodies.position[k], axes_of(bodies.orientation[k]), half_extent};
  };
  const BoxFrame thrown = frame(i);
  std::vector<std::uint8_t> wakes(bodies.size(), 0);
  for (BodyIndex k = 0; k < bodies.size(); ++k) {
    if (k == i || wakes[k] != 0 || bodies.is_static[k] != 0) continue;
    if (BoxPair(thrown, frame(k)).best_of_all().separation >= 0) continue;
    wakes[k] = 1;
    for (const BodyIndex other : connected_with(state, k)) wakes[other] = 1;
  }
  for (BodyIndex k = 0; k < bodies.size(); ++k) {
    if (wakes[k] != 0 && bodies.is_static[k] == 0) wake_body(state, k);
  }
}

}  // namespace tumble::sim
