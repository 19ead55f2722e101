#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tumble/render/snapshot.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/vec.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

/// One state of a played session as a window shows it, and the figures beside it.
struct LiveFrame {
  std::uint64_t serial = 0;  ///< 1, 2, … in the order in which the session hands frames over
  std::uint64_t step = 0;    ///< number of the state in its log
  double time = 0;           ///< simulated since the session's start, s
  double dt = 0;             ///< of the step that led here, s
  double scene_dt = 0;       ///< that the clock asks for, s
  sim::Vec3 gravity = {0, 0, 0};

  render::Snapshot snapshot;            ///< bodies in ascending id; camera and light are the scene's
  std::vector<std::uint8_t> is_moving;  ///< by body: neither frozen nor static
  std::vector<double> mass;             ///< by body, kg
  std::uint64_t moving = 0;             ///< bodies

  double step_seconds = 0;  ///< that the last step took to compute and to log
  std::vector<const char*> phase_names;
  std::vector<double> phase_seconds;  ///< of the last step
  double hash_seconds = 0;            ///< of the hashes of its phases

  std::uint64_t inputs_done = 0;  ///< inputs posted that are in this state, or were refused
  std::uint64_t restored = 0;     ///< times that the floating-point environment was not the default
  std::string log;                ///< the log that is open
  std::string notice;             ///< the last input that was refused, or the last change of the log
  std::string ended;              ///< the reason why the session cannot step on; empty while it can
};

/// Fills in bodies and counts of a frame from a world. `looks`: the texture of each body by id.
void fill_bodies(LiveFrame& frame, const sim::World& world, const std::map<sim::BodyId, sim::Texture>& looks);

}  // namespace tumble::replay
