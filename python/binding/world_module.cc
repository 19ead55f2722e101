// The class that Python steps a world with; tumble/_world.py makes more of it.
#include <pybind11/stl.h>

#include <utility>

#include "python/binding/arrays.h"
#include "python/binding/values.h"
#include "python/binding/world.h"
#include "tumble/replay/body_states.h"
#include "tumble/sim/world_state.h"

namespace tumble::python {
namespace {

std::shared_ptr<StateBlock> states_of(LiveWorld& live) {
  return live.read([](const sim::World& world) {
    replay::BodyStates states;
    replay::copy_visible(world.bodies(), states);
    return std::make_shared<StateBlock>(block_of(states));
  });
}

/// Of the bodies that the world has now.
py::dict constants_of(LiveWorld& live) {
  const sim::Bodies bodies = live.read([](const sim::World& world) { return world.bodies(); });
  const auto n = static_cast<py::ssize_t>(bodies.size());
  std::vector<double> size(bodies.size() * 3);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const sim::Vec3 half = bodies.half_extent[i];
    for (int k = 0; k < 3; ++k) size[3 * i + static_cast<std::size_t>(k)] = 2 * half[k];
  }
  py::dict columns;
  columns["size"] = array_of(std::move(size), {n, 3});
  columns["mass"] = array_of(bodies.mass);
  columns["is_static"] = array_of(bodies.is_static).attr("view")("bool");
  return columns;
}

struct Now {
  std::uint64_t step;
  double dt;
  sim::Vec3 gravity;
  Hash128 hash;
  sim::Energy energy;
};

py::dict now_of(LiveWorld& live) {
  const Now now = live.read([](const sim::World& world) {
    const sim::WorldState& state = world.state();
    return Now{state.step, state.def.dt, state.def.gravity, sim::state_hash(state.bodies), sim::total_energy(state)};
  });
  py::dict fields;
  fields["step"] = now.step;
  fields["dt"] = now.dt;
  fields["gravity"] = tuple_of(now.gravity);
  fields["hash"] = to_string(now.hash);
  fields["kinetic"] = now.energy.kinetic;
  fields["potential"] = now.energy.potential;
  return fields;
}

py::list world_contacts(LiveWorld& live) {
  const auto points = live.read([](const sim::World& world) {
    return world.state().step == 0 ? std::vector<replay::ContactPoint>() : replay::contact_points(world);
  });
  py::list rows;
  for (const replay::ContactPoint& point : points) {
    rows.append(py::make_tuple(point.a, point.b ? py::object(py::int_(*point.b)) : py::none(), tuple_of(point.at),
                               tuple_of(point.normal), point.depth, point.impulse));
  }
  return rows;
}

py::object summary_of(const std::optional<replay::LogSummary>& summary) {
  if (!summary) return py::none();
  return dict_of(*summary);
}

}  // namespace

void add_world(py::module_& module) {
  const auto make = [](std::string text, std::string file, std::vector<std::string> overrides, std::string log,
                       std::string states, std::string hashes, std::uint64_t threads) {
    return std::unique_ptr<LiveWorld, InOwnProcess>(
        new LiveWorld({std::move(text), std::move(file), std::move(overrides), std::move(log), std::move(states),
                       std::move(hashes), threads}));
  };
  const auto go_on = [](LogFile& from, std::uint64_t k, bool inputs, std::optional<std::uint64_t> steps,
                        std::string log, std::string states, std::string hashes, std::uint64_t threads) {
    return std::unique_ptr<LiveWorld, InOwnProcess>(
        new LiveWorld(from, {k, inputs, steps, std::move(log), std::move(states), std::move(hashes), threads}));
  };
  const auto step = [](LiveWorld& live, std::uint64_t count) {
    if (live.step(count) < count) raise_interruption();
  };
  py::class_<LiveWorld, std::unique_ptr<LiveWorld, InOwnProcess>>(module, "LiveWorld")
      .def(py::init(make))
      .def_static("go_on", go_on)
      .def("add_input", [](LiveWorld& live, const py::dict& fields) { live.add_input(command_of(fields)); })
      .def("next_id", &LiveWorld::next_id)
      .def("step", step)
      .def("states", &states_of)
      .def("constants", &constants_of)
      .def("now", &now_of)
      .def("contacts", &world_contacts)
      .def("finish", [](LiveWorld& live) { return summary_of(live.finish()); })
      .def_property_readonly("finished", &LiveWorld::is_finished)
      .def_property_readonly("planned_steps", [](const LiveWorld& live) { return live.scene().steps; })
      .def_property_readonly("scene", [](const LiveWorld& live) { return text_of_bytes(live.scene().name); });
}

}  // namespace tumble::python
