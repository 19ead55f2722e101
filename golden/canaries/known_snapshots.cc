#include <array>
#include <limits>
#include <string>
#include <vector>

#include "golden/canaries/canary_roll.h"
#include "golden/canaries/known_answers.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world_state.h"

namespace tumble::golden {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// Snapshots that no session wrote.
const std::vector<WrongValue<sim::WorldState>>& wrong_snapshots() {
  static const std::vector<WrongValue<sim::WorldState>> kWrongSnapshots = {
      {"as it must be", [](auto&) {}, "taken"},
      {"a column too short", [](auto& s) { s.bodies.friction.pop_back(); },
       "snapshot: the columns of the bodies differ in length"},
      {"id 0", [](auto& s) { s.bodies.id[0] = 0; }, "snapshot: ids do not ascend within 1 … 2^53 − 1"},
      {"id 2^53", [](auto& s) { s.bodies.id[2] = 1ULL << 53U; }, "snapshot: ids do not ascend within 1 … 2^53 − 1"},
      {"the greatest id", [](auto& s) { s.bodies.id[2] = (1ULL << 53U) - 1; }, "taken"},
      {"ids that do not ascend", [](auto& s) { s.bodies.id[1] = 1; },
       "snapshot: ids do not ascend within 1 … 2^53 − 1"},
      {"no substeps", [](auto& s) { s.def.substeps = 0; }, "world: found 0 substeps, wanted 1 … 1024"},
      {"a position beyond", [](auto& s) { s.bodies.position.x[0] = -32769; },
       "snapshot: body 1: found position (-32769, 0, 0.5) m, wanted finite and within ±32768 m; it left the world: "
       "start nearer to the origin, stop it, or remove it before"},
      {"a velocity beyond", [](auto& s) { s.bodies.velocity.x[1] = 8193; },
       "snapshot: body 2: found velocity (8193, 0, 7.27595761e-12) m/s, wanted finite and within ±8192 m/s; use "
       "smaller speeds, a smaller dt or less extreme masses"},
      {"a spin that is no number", [](auto& s) { s.bodies.spin.x[1] = kNotANumber; },
       "snapshot: body 2: found spin (nan, 0, 0) rad/s, wanted finite and within ±8192 rad/s; use smaller speeds, a "
       "smaller dt or less extreme masses"},
      {"an orientation of no unit length", [](auto& s) { s.bodies.orientation.w[1] = 1.5; },
       "snapshot: body 2: found an orientation of squared length 2.250000, wanted 1"},
      {"no mass", [](auto& s) { s.bodies.mass[1] = 0; },
       "snapshot: body 2 has a size, mass, inertia or material out of range"},
      {"no half extent", [](auto& s) { s.bodies.half_extent.y[1] = 0; },
       "snapshot: body 2 has a size, mass, inertia or material out of range"},
      {"an inertia below 0", [](auto& s) { s.bodies.inertia.y[1] = -1; },
       "snapshot: body 2 has a size, mass, inertia or material out of range"},
      {"a flag of 2", [](auto& s) { s.bodies.frozen[0] = 2; },
       "snapshot: body 1 has a size, mass, inertia or material out of range"},
  };
  return kWrongSnapshots;
}

// Those whose bodies are as they must be.
const std::vector<WrongValue<sim::WorldState>>& wrong_lists() {
  static const std::vector<WrongValue<sim::WorldState>> kWrongLists = {
      {"a pair in the wrong order",
       [](auto& s) { s.pairs.a.push_back(1), s.pairs.b.push_back(0), s.pairs.planes.push_back(0); },
       "snapshot: pair 1 is out of order or out of range"},
      {"a pair of one body with itself",
       [](auto& s) { s.pairs.a.push_back(1), s.pairs.b.push_back(1), s.pairs.planes.push_back(0); },
       "snapshot: pair 1 is out of order or out of range"},
      {"a pair with nobody",
       [](auto& s) { s.pairs.a.push_back(1), s.pairs.b.push_back(3), s.pairs.planes.push_back(0); },
       "snapshot: pair 1 is out of order or out of range"},
      {"a pair twice", [](auto& s) { s.pairs.a.push_back(0), s.pairs.b.push_back(1), s.pairs.planes.push_back(0); },
       "snapshot: pair 1 is out of order or out of range"},
      {"a pair more", [](auto& s) { s.pairs.a.push_back(1), s.pairs.b.push_back(2), s.pairs.planes.push_back(0x7fff); },
       "taken"},
      {"a pair of planes beyond all axes",
       [](auto& s) { s.pairs.a.push_back(1), s.pairs.b.push_back(2), s.pairs.planes.push_back(0x8000); },
       "snapshot: pair 1 is out of order or out of range"},
      {"pairs of two lengths", [](auto& s) { s.pairs.a.push_back(1); },
       "snapshot: the columns of the pair list differ in length"},
      {"a contact object of nobody",
       [](auto& s) { s.contact_objects.body.push_back(9), s.contact_objects.object.push_back(0); },
       "snapshot: contact object 0 is out of order or out of range"},
      {"contact objects",
       [](auto& s) {
         s.contact_objects.body = {0, 1, 1}, s.contact_objects.object = {sim::kGround, 0, 2};
       },
       "taken"},
      {"a contact object that is nobody", [](auto& s) { s.contact_objects.body = {0}, s.contact_objects.object = {3}; },
       "snapshot: contact object 0 is out of order or out of range"},
      {"contact objects in the wrong order",
       [](auto& s) {
         s.contact_objects.body = {1, 0}, s.contact_objects.object = {0, 1};
       },
       "snapshot: contact object 1 is out of order or out of range"},
      {"contact objects of two lengths", [](auto& s) { s.contact_objects.body.push_back(0); },
       "snapshot: contact objects differ in length"},
      {"contact memory of two lengths", [](auto& s) { s.contact_memory.a.push_back(0); },
       "snapshot: the columns of the contact memory differ in length"},
      {"contact memory without its points", [](auto& s) { s.contact_memory.count[0] += 1; },
       "snapshot: the contact memory's points do not add up"},
      {"contact memory with a point too many", [](auto& s) { s.contact_memory.impulse.push_back(0); },
       "snapshot: the contact memory's points do not add up"},
      {"contact memory by nobody", [](auto& s) { s.contact_memory.a[0] = 3; },
       "snapshot: contact memory 0 is out of range"},
      {"contact memory of nobody", [](auto& s) { s.contact_memory.b[0] = 9; },
       "snapshot: contact memory 0 is out of range"},
  };
  return kWrongLists;
}

// The columns of the bodies, by name.
template <class Visit>
void for_each_column(sim::Bodies& b, Visit visit) {
  const auto vectors = [&](auto& of) { visit(of.x), visit(of.y), visit(of.z); };
  for (auto* of : {&b.position, &b.velocity, &b.spin, &b.half_extent, &b.inertia, &b.inverse_inertia}) vectors(*of);
  visit(b.orientation.w);
  vectors(b.orientation);
  for (auto* of : {&b.low_energy_time, &b.mass, &b.inverse_mass, &b.friction, &b.friction_dynamic, &b.restitution})
    visit(*of);
  visit(b.frozen);
  visit(b.is_static);
}

// How many columns of the bodies a snapshot may lack a row of; none.
std::string columns_cut(const sim::WorldState& good) {
  int columns = 0, taken = 0;
  sim::WorldState copy = good;
  for_each_column(copy.bodies, [&](auto&) { ++columns; });
  for (int cut = 0; cut < columns; ++cut) {
    sim::WorldState state = good;
    int at = 0;
    for_each_column(state.bodies, [&](auto& column) {
      if (at++ == cut) column.pop_back();
    });
    if (sim::World::restore(state).ok()) ++taken;
  }
  return std::to_string(taken) + " of " + std::to_string(columns);
}

// Asks of the state after a step.
template <class Find>
auto of_step(Find find) {
  return [find]() -> std::string {
    Result<sim::World> world = sim::create_world(three_crates(sim::Method::kLayered));
    if (!world.ok() || !sim::step(*world).ok()) return "no world: " + status_text(status_of(world));
    return find(world->state());
  };
}

std::string taken_all(const std::vector<WrongValue<sim::WorldState>>& all, const sim::WorldState& good) {
  return ask_all(all, good, [](const auto& state) { return status_of(sim::World::restore(state)); });
}

}  // namespace

void run_known_snapshots(CanaryRoll& roll) {
  roll.known("snapshots that no session wrote are refused",
             of_step([](const sim::WorldState& good) { return taken_all(wrong_snapshots(), good); }));
  roll.known("snapshots whose lists no session wrote are refused",
             of_step([](const sim::WorldState& good) { return taken_all(wrong_lists(), good); }));
  roll.known("a snapshot lacks no row of any column", of_step(columns_cut), "0 of 30");
}

}  // namespace tumble::golden
