#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"
#include "tumble/sim/vec.h"

/// Everything that touched one body in one step. No log holds it; this build computes it by taking the step again.
namespace tumble::replay {

struct BodyContactPoint {
  sim::Vec3 at = sim::Vec3::Zero();  ///< m, world
  double depth = 0;                  ///< m; negative: apart
  double impulse = 0;                ///< N·s along the normal, on the body, in this substep
  double load = 0;                   ///< N·s a substep that it bears at rest; 0 in method thesis
};

/// The contact of the body with one other, or with the ground, in one substep.
struct BodyContact {
  std::uint32_t substep = 0;             ///< 0-based
  std::optional<sim::BodyId> other;      ///< none: the ground
  sim::Vec3 normal = sim::Vec3::Zero();  ///< towards the body
  std::vector<BodyContactPoint> points;
  double impulse = 0;                      ///< N·s, of all points
  sim::Vec3 friction = sim::Vec3::Zero();  ///< N·s, on the body
  double twist = 0;                        ///< N·m·s, on the body about the normal; 0 in method thesis
  bool asleep = false;                     ///< both rest: not solved; impulses are those of the step that fell asleep
  bool fast = false;                       ///< of a fast pair: found in this substep
};

struct BodyContacts {
  std::uint64_t step = 0;
  sim::BodyId body = 0;
  double mass = 0;                    ///< kg
  std::vector<BodyContact> contacts;  ///< by substep, then as the step found them
  std::vector<sim::BodyId> island;    ///< bodies that contacts of this step connect with it, itself included, ascending
  std::optional<double> borne;        ///< kg, everything that rests on it; none in method thesis
  std::optional<double> lent;         ///< kg of inertia that the solver lends it; none in method thesis
  std::vector<std::string> notes;     ///< for people
};

/// The contacts of a body in step k of first_state() + 1 … last_step(). Errors: as blame()'s.
Result<BodyContacts> contacts_of_body(LogReader& log, sim::BodyId body, std::uint64_t k, const Progress& progress = {});

}  // namespace tumble::replay
