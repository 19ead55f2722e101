#include "replay/probe/phase_probes.h"

#include <algorithm>
#include <array>
#include <deque>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "replay/probe/tumble_probe.h"
#include "src/world/free_flight.h"
#include "src/world/scratch.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/player.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

struct PhasePlace {
  std::string_view phase;
  std::string_view quantity;  // "position", "solver-spin"; empty: the function of the phase
  const char* file;
  std::uint32_t line;
};

/// The functions of the phases and the statements of phase_sites.txt, from their files when this was built.
constexpr PhasePlace kPlaces[] = {
#include <phase_places.inc>  // written by cmake/phase_places.cmake
};

/// The statement that writes a quantity in a phase; the function of a phase that has none.
PhasePlace place_of(std::string_view phase, std::string_view quantity) {
  PhasePlace found = {"", "", "src/step/step.cc", 0};
  for (const PhasePlace& place : kPlaces) {
    if (place.phase != phase) continue;
    if (place.quantity == quantity) return place;
    if (place.quantity.empty()) found = place;
  }
  return found;
}

/// "position" of "position.x".
std::string quantity_of(std::string_view column) { return std::string(column.substr(0, column.find('.'))); }

/// Phases of method layered in which the bodies in contact have their motion in Scratch::solver_bodies.
bool moves_solver_bodies(std::string_view phase) {
  constexpr std::array kPhases = {"part_overlaps",  "apply_forces",         "push_contacts",  "integrate_positions",
                                  "relax_contacts", "bounce_fast_contacts", "bounce_contacts"};
  return std::ranges::any_of(kPhases, [phase](const char* one) { return phase == one; });
}

constexpr std::array<const char*, 6> kSolverNames = {"solver's velocity.x", "solver's velocity.y",
                                                     "solver's velocity.z", "solver's spin.x",
                                                     "solver's spin.y",     "solver's spin.z"};

/// The places of the probes after one phase.
struct Sites {
  TumbleProbeSite hash, depth, impulse;
  std::array<TumbleProbeSite, kColumnCount> columns, uneven_columns;
  std::array<TumbleProbeSite, kSolverNames.size()> solver;
};

/// Writes probes after each phase.
class PhaseProbes : public sim::Observer {
 public:
  PhaseProbes(TumbleProbes& probes, sim::Method method) : probes_(probes), phases_(sim::phase_table(method).phases) {
    for (const sim::Phase& phase : phases_) sites_.push_back(sites_of(phase.name));
  }

  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    Sites& sites = sites_[phase];
    write_bodies(sites, world.bodies());
    if (moves_solver_bodies(phases_[phase].name)) write_solver_bodies(sites, world);
    write_contacts(sites, substep, phase, world);
    // Last: a probe of one value names its statement, the hash of all of them the phase alone.
    hasher_.reset();
    phases_[phase].hash(world.state(), world.scratch(), hasher_);
    const Hash128 hash = hasher_.digest();
    tumble_probes_write(&probes_, &sites.hash, TUMBLE_PROBE_U64, substep, 0, hash.low);
  }

 private:
  void write_contacts(Sites& sites, std::uint32_t substep, std::size_t phase, const sim::World& world) {
    const bool is_thesis = world.state().def.method == sim::Method::kThesis;
    // Before these phases the memory holds the contacts of the step before, of bodies that may be gone. Method thesis
    // finds contacts in each substep; before, their pairs are the new ones already and their depths the old ones.
    if (is_thesis && substep != substep_) has_contacts_ = false;
    substep_ = substep;
    has_contacts_ = has_contacts_ || std::string_view(phases_[phase].name) == "find_manifolds" ||
                    std::string_view(phases_[phase].name) == "find_contacts";
    if (!has_contacts_) return;
    if (is_thesis) {
      write_thesis_contacts(sites, world);
    } else {
      write_manifolds(sites, world);
    }
  }

  /// The site of one quantity after a phase. Its texts last as long as this object.
  TumbleProbeSite site(const std::string& phase, const std::string& what, const std::string& quantity) {
    const PhasePlace place = place_of(phase, quantity);
    names_.push_back(phase + ": " + what);
    return {names_.back().c_str(), place.file, place.line, 0, 0};
  }

  Sites sites_of(const std::string& phase) {
    Sites sites{site(phase, "hash of what it wrote, by substep", ""),
                site(phase, "depth of a contact", "depth"),
                site(phase, "impulse of a contact", "impulse"),
                {},
                {},
                {}};
    for (std::size_t c = 0; c < kColumnCount; ++c) {
      const std::string quantity = quantity_of(kColumnNames[c]);
      sites.columns[c] = sites.uneven_columns[c] = site(phase, kColumnNames[c], quantity);
      const PhasePlace uneven = place_of(phase, quantity + "-uneven");
      if (uneven.quantity.empty()) continue;
      sites.uneven_columns[c].file = uneven.file;
      sites.uneven_columns[c].line = uneven.line;
    }
    for (std::size_t c = 0; c < kSolverNames.size(); ++c) {
      sites.solver[c] = site(phase, kSolverNames[c], c < 3 ? "solver-velocity" : "solver-spin");
    }
    return sites;
  }

  void write_bodies(Sites& sites, const sim::Bodies& bodies) {
    const ConstColumns columns = columns_of(bodies);
    for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
      if (!bodies.moves(i)) continue;
      auto& of_body = sim::turns_evenly(bodies.inertia[i]) ? sites.columns : sites.uneven_columns;
      for (const std::size_t c : kFieldOrder) {
        tumble_probes_write(&probes_, &of_body[c], TUMBLE_PROBE_F64, bodies.id[i], 0,
                            tumble_probe_bits((*columns[c])[i]));
      }
    }
  }

  void write_solver_bodies(Sites& sites, const sim::World& world) {
    const sim::Scratch& scratch = world.scratch();
    const sim::Bodies& bodies = world.bodies();
    for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
      if (i >= scratch.in_contact.size() || scratch.in_contact[i] == 0 || i >= scratch.solver_bodies.size()) continue;
      const sim::SolverBody& body = scratch.solver_bodies[i];
      const std::array<double, kSolverNames.size()> values = {body.velocity.x(), body.velocity.y(), body.velocity.z(),
                                                              body.spin.x(),     body.spin.y(),     body.spin.z()};
      for (std::size_t c = 0; c < values.size(); ++c) {
        tumble_probes_write(&probes_, &sites.solver[c], TUMBLE_PROBE_F64, bodies.id[i], 0,
                            tumble_probe_bits(values[c]));
      }
    }
  }

  void write_contact(Sites& sites, const sim::World& world, sim::BodyIndex a, sim::BodyIndex b, double depth,
                     double impulse) {
    const auto id = [&](sim::BodyIndex i) { return i == sim::kGround ? 0 : world.bodies().id[i]; };
    const auto [low, high] = std::minmax({id(a), id(b)});
    constexpr int kKind = TUMBLE_PROBE_F64 | TUMBLE_PROBE_OF_PAIR;
    tumble_probes_write(&probes_, &sites.depth, kKind, low, high, tumble_probe_bits(depth));
    tumble_probes_write(&probes_, &sites.impulse, kKind, low, high, tumble_probe_bits(impulse));
  }

  void write_thesis_contacts(Sites& sites, const sim::World& world) {
    const sim::Contacts& contacts = world.scratch().contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      write_contact(sites, world, contacts.a[i], contacts.b[i], contacts.depth[i],
                    i < contacts.impulse.size() ? sim::length(contacts.impulse[i]) : 0);
    }
  }

  void write_manifolds(Sites& sites, const sim::World& world) {
    const sim::Scratch& scratch = world.scratch();
    for (const sim::Manifold& manifold : scratch.manifolds) {
      if (manifold.asleep) continue;
      for (const sim::ManifoldPoint& point : sim::points_of(scratch, manifold)) {
        write_contact(sites, world, manifold.a, manifold.b, -point.separation, point.impulse);
      }
    }
  }

  TumbleProbes& probes_;
  std::span<const sim::Phase> phases_;
  std::deque<std::string> names_;
  std::vector<Sites> sites_;
  Hasher hasher_;
  std::uint32_t substep_ = 0;
  bool has_contacts_ = false;
};

}  // namespace

Status write_phase_probes(LogReader& log, std::uint64_t k, const std::string& path) {
  if (k <= log.first_state() || k > log.last_step()) {
    return bad_input(log.name() + ": found no step " + std::to_string(k) + " to take again");
  }
  Result<Player> player = Player::at(log, k - 1);
  if (!player.ok()) return player.error();
  TumbleProbes probes;
  if (tumble_probes_open(&probes, path.c_str(), k) != 0) {
    return cannot_finish(path + ": cannot be written");
  }
  PhaseProbes observer(probes, player->world().state().def.method);
  tumble_probes_step(&probes, k);
  const Result<const StepRecord*> taken = player->step(&observer);
  const bool is_written = tumble_probes_close(&probes) == 0;
  if (!taken.ok()) return taken.error();
  return is_written ? Status() : Status(cannot_finish(path + ": cannot be written to its end (full disk?)"));
}

}  // namespace tumble::replay
