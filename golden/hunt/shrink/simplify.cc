#include "golden/hunt/shrink/simplify.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

#include "replay/session/boxes_at.h"
#include "src/base/text.h"

namespace tumble::hunt {
namespace {

using sim::BoxDef;
using sim::SceneDef;
using sim::Vec3;

// The body that an input is about; 0: none.
sim::BodyId named_by(const sim::Command& command) {
  struct Name {
    sim::BodyId operator()(const sim::Throw& input) const { return input.box.id; }
    sim::BodyId operator()(const sim::Push& input) const { return input.id; }
    sim::BodyId operator()(const sim::Remove& input) const { return input.id; }
    sim::BodyId operator()(const sim::Wake& input) const { return input.id; }
    sim::BodyId operator()(const sim::SetVelocity& input) const { return input.id; }
    sim::BodyId operator()(const sim::SetGravity&) const { return 0; }
    sim::BodyId operator()(const sim::SetDt&) const { return 0; }
  };
  return std::visit(Name{}, command);
}

std::vector<sim::BodyId> ids_of(const SceneDef& scene) {
  std::vector<sim::BodyId> ids;
  for (const BoxDef& box : scene.boxes) ids.push_back(box.id);
  for (const sim::TimedCommand& input : scene.inputs) {
    if (std::holds_alternative<sim::Throw>(input.command)) ids.push_back(named_by(input.command));
  }
  return ids;
}

SceneDef without(const SceneDef& scene, const std::set<sim::BodyId>& gone) {
  SceneDef out = scene;
  std::erase_if(out.boxes, [&](const BoxDef& box) { return gone.contains(box.id); });
  std::erase_if(out.inputs, [&](const sim::TimedCommand& input) { return gone.contains(named_by(input.command)); });
  return out;
}

// Adds the scene with one change, if that changes anything.
template <class Change>
void add(Candidates& out, const SceneDef& scene, Change change) {
  SceneDef changed = scene;
  change(changed);
  if (!(changed == scene)) out.push_back(std::move(changed));
}

template <class Visit>
void for_boxes(SceneDef& scene, Visit visit) {
  for (BoxDef& box : scene.boxes) visit(box);
  for (sim::TimedCommand& input : scene.inputs) {
    if (auto* thrown = std::get_if<sim::Throw>(&input.command)) visit(thrown->box);
  }
}

// Adds the scene with a change of all boxes, then of each alone.
template <class Change>
void add_for_boxes(Candidates& out, const SceneDef& scene, Change change) {
  add(out, scene, [&](SceneDef& all) { for_boxes(all, [&](BoxDef& box) { change(box); }); });
  const std::size_t count = ids_of(scene).size();
  for (std::size_t k = 0; k < count && count > 1; ++k) {
    add(out, scene, [&](SceneDef& one) {
      std::size_t at = 0;
      for_boxes(one, [&](BoxDef& box) {
        if (at++ == k) change(box);
      });
    });
  }
}

}  // namespace

Candidates fewer_bodies(const SceneDef& scene) {
  Candidates out;
  const std::vector<sim::BodyId> ids = ids_of(scene);
  for (std::size_t part = ids.size() / 2; part >= 1; part /= 2) {
    for (std::size_t begin = 0; begin < ids.size(); begin += part) {
      const std::size_t end = std::min(begin + part, ids.size());
      std::set<sim::BodyId> gone;
      for (std::size_t k = begin; k < end; ++k) gone.insert(ids[k]);
      if (gone.size() < ids.size()) out.push_back(without(scene, gone));
    }
  }
  return out;
}

Candidates fewer_inputs(const SceneDef& scene) {
  Candidates out;
  for (std::size_t part = scene.inputs.size(); part >= 1; part /= 2) {
    for (std::size_t begin = 0; begin < scene.inputs.size(); begin += part) {
      SceneDef less = scene;
      const auto first = less.inputs.begin() + static_cast<std::ptrdiff_t>(begin);
      less.inputs.erase(first, first + static_cast<std::ptrdiff_t>(std::min(part, scene.inputs.size() - begin)));
      out.push_back(std::move(less));
    }
  }
  return out;
}

Candidates fewer_steps(const SceneDef& scene, std::uint64_t broken) {
  Candidates out;
  std::set<std::uint64_t> lengths;
  for (const std::uint64_t steps : {std::uint64_t{1}, broken / 4, broken / 2, broken - broken / 4, broken}) {
    if (steps >= 1 && steps < scene.steps) lengths.insert(steps);
  }
  for (const std::uint64_t steps : lengths) {
    SceneDef shorter = scene;
    shorter.steps = steps;
    std::erase_if(shorter.inputs, [steps](const sim::TimedCommand& input) { return input.step > steps; });
    out.push_back(std::move(shorter));
  }
  return out;
}

Candidates later_starts(const Trace& trace, std::uint64_t broken) {
  Candidates out;
  std::vector<BoxDef> known = trace.scene.boxes;
  for (const sim::TimedCommand& input : trace.scene.inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input.command)) known.push_back(thrown->box);
  }
  std::uint64_t back = 1;
  for (; back < broken; back *= 2) {
    const std::uint64_t from = broken - back;
    if (from >= trace.states.size()) continue;
    const sim::WorldState& state = trace.states[from];
    SceneDef later = trace.scene;
    later.boxes = replay::boxes_at(state.bodies, known);
    later.world.gravity = state.def.gravity;
    later.world.dt = state.def.dt;
    later.steps = trace.scene.steps - from;
    std::erase_if(later.inputs, [from](const sim::TimedCommand& input) { return input.step <= from; });
    for (sim::TimedCommand& input : later.inputs) input.step -= from;
    out.push_back(std::move(later));
  }
  return out;
}

Candidates plainer(const SceneDef& scene) {
  Candidates out;
  const sim::WorldDef usual;
  const auto world = [&](auto member) { add(out, scene, [&](SceneDef& one) { one.world.*member = usual.*member; }); };
  add(out, scene, [](SceneDef& one) { one.world.freezing = false; });
  world(&sim::WorldDef::air_drag);
  world(&sim::WorldDef::split_collisions);
  world(&sim::WorldDef::freeze_time);
  world(&sim::WorldDef::freeze_energy);
  world(&sim::WorldDef::slip_speed);
  world(&sim::WorldDef::dt);
  add(out, scene, [](SceneDef& one) { one.world.substeps = 1; });
  add(out, scene, [](SceneDef& one) { one.world.ground = false; });
  // From any value to zero or the default, and from zero to the default: never back.
  if (scene.world.gravity != usual.gravity) add(out, scene, [](SceneDef& one) { one.world.gravity = {0, 0, 0}; });
  world(&sim::WorldDef::gravity);
  add(out, scene,
      [](SceneDef& one) { for_boxes(one, [&](BoxDef& box) { box.material = one.world.ground_material; }); });
  for (const bool rough : {false, true}) {
    if (!rough && scene.world.ground_material == sim::Material{}) continue;
    add(out, scene, [rough](SceneDef& one) {
      const sim::Material material =
          rough ? sim::Material{} : sim::Material{.friction = 0, .friction_dynamic = 0, .restitution = 0};
      one.world.ground_material = material;
      for_boxes(one, [&](BoxDef& box) { box.material = material; });
    });
  }
  add_for_boxes(out, scene, [](BoxDef& box) { box.frozen = false; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.is_static = false; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.spin = {0, 0, 0}; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.velocity = {0, 0, 0}; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.orientation = {}; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.mass = 1; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.size = {1, 1, 1}; });
  add_for_boxes(out, scene, [](BoxDef& box) { box.size = Vec3::Constant(box.size.maxCoeff()); });
  return out;
}

Candidates renumbered(const SceneDef& scene) {
  Candidates out;
  add(out, scene, [](SceneDef& one) {
    std::vector<sim::BodyId> ids = ids_of(one);
    std::ranges::sort(ids);
    const auto rank = [&](sim::BodyId& id) {
      id = static_cast<sim::BodyId>(std::ranges::lower_bound(ids, id) - ids.begin()) + 1;
    };
    for_boxes(one, [&](BoxDef& box) { rank(box.id); });
    for (sim::TimedCommand& input : one.inputs) {
      if (auto* push = std::get_if<sim::Push>(&input.command)) rank(push->id);
      if (auto* remove = std::get_if<sim::Remove>(&input.command)) rank(remove->id);
      if (auto* wake = std::get_if<sim::Wake>(&input.command)) rank(wake->id);
      if (auto* set = std::get_if<sim::SetVelocity>(&input.command)) rank(set->id);
    }
  });
  return out;
}

std::vector<double*> numbers_of(SceneDef& scene) {
  std::vector<double*> out;
  const auto put = [&](double& x) { out.push_back(&x); };
  const auto put_vector = [&](Vec3& v) {
    for (int k = 0; k < 3; ++k) out.push_back(&v[k]);
  };
  for_boxes(scene, [&](BoxDef& box) {
    put_vector(box.size);
    put_vector(box.position);
    put_vector(box.velocity);
    put_vector(box.spin);
    for (double* part : {&box.orientation.w, &box.orientation.x, &box.orientation.y, &box.orientation.z}) put(*part);
    put(box.mass);
    put(box.material.friction);
    put(box.material.friction_dynamic);
    put(box.material.restitution);
  });
  if (scene.world.dt != sim::WorldDef{}.dt) put(scene.world.dt);
  if (scene.world.gravity != sim::WorldDef{}.gravity) put_vector(scene.world.gravity);
  put(scene.world.air_drag);
  put(scene.world.freeze_time);
  put(scene.world.ground_material.friction);
  put(scene.world.ground_material.friction_dynamic);
  put(scene.world.ground_material.restitution);
  for (sim::TimedCommand& input : scene.inputs) {
    if (auto* push = std::get_if<sim::Push>(&input.command)) put_vector(push->impulse);
    if (auto* set = std::get_if<sim::SetVelocity>(&input.command)) put_vector(set->velocity), put_vector(set->spin);
    if (auto* set = std::get_if<sim::SetGravity>(&input.command)) put_vector(set->gravity);
    if (auto* set = std::get_if<sim::SetDt>(&input.command)) put(set->dt);
  }
  return out;
}

std::vector<double> fewer_digits(double value) {
  std::vector<double> out;
  const std::size_t length = exact(value).size();
  if (value == 0 || length <= 3) return out;
  out.push_back(0);
  for (const int digits : {1, 2, 3, 4, 6, 9}) {
    char text[40];
    const std::to_chars_result end =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::scientific, digits - 1);
    const std::optional<double> shorter = parse_exact(std::string_view(std::begin(text), end.ptr));
    if (shorter && exact(*shorter).size() < length) out.push_back(*shorter);
  }
  return out;
}

}  // namespace tumble::hunt
