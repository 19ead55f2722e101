#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "src/base/ids.h"
#include "src/math/vec.h"
#include "src/world/manifold.h"
#include "src/world/world_state.h"

/// What single phases need for themselves while they run: parts of Scratch, so that a warm step does not allocate. No
/// other phase may read them.
namespace tumble::sim {

/// A body that may freeze in this sub-step, and how low the lowest thing it touches lies.
struct FreezeCandidate {
  bool ready = false;
  double lowest = 0;  ///< m, height of the contact object's centre over the body's; −infinity for the ground
};

/// Of update_freezing.
struct FreezeScratch {
  std::vector<BodyIndex> ready;             ///< to freeze
  std::vector<FreezeCandidate> candidates;  ///< of each body, where any is ready
  std::vector<std::uint8_t> frozen_before;
  std::vector<std::pair<BodyIndex, BodyIndex>> carriers;  ///< bodies and what carries them, as it is found
  ContactObjects found;
  ContactObjects merged;
};

/// Of wake_islands.
struct WakeScratch {
  std::vector<BodyIndex> disturbed;  ///< sleeping bodies whose islands a lively body is about to touch
  std::vector<std::uint8_t> wakes;   ///< of the body that stands for an island
};

/// Of assign_levels.
struct LevelScratch {
  std::vector<std::uint32_t> touching;     ///< manifolds that join two bodies
  std::vector<std::uint32_t> start, next;  ///< of each body in `neighbours`; of each layer while manifolds are sorted
  std::vector<BodyIndex> neighbours;       ///< what each body touches
  std::vector<BodyIndex> front, reached;   ///< bodies of one level and of the next
  std::vector<BodyIndex> slender;          ///< bodies, as they are met
  std::vector<std::uint8_t> marked, in_slender;  ///< by the body that stands for an island; of each body
};

/// Of carry_weights.
struct WeightScratch {
  /// A manifold through which one body rests on another.
  struct Support {
    std::uint32_t manifold = 0;
    BodyIndex upper = 0, lower = 0;
    Vec3 origin;      ///< m, from the upper body's centre to where p, q and offset are measured from
    double pull = 0;  ///< m/s², gravity along the normal
    std::uint32_t first_bearing = 0, end_bearing = 0;
  };
  /// A point that bears.
  struct Bearing {
    ManifoldPoint* point = nullptr;
    double x = 0, y = 0;  ///< m, its place across from the upper body's centre
    double load = 0;      ///< kg, before all is scaled to fit
  };
  std::vector<Support> found;              ///< in the order of the layers
  std::vector<Support> supports;           ///< by upper body
  std::vector<std::uint32_t> start, next;  ///< of each body in `supports`
  std::vector<Bearing> bearings;           ///< of one body at a time
  std::vector<std::uint32_t> waiting_for;  ///< supports that have not handed down yet
  std::vector<BodyIndex> ready;            ///< bodies for which nothing is waited any more
  std::vector<double> carried;             ///< kg, of the body and all that rests on it
  std::vector<double> moment_x, moment_y;  ///< kg·m, of what rests on it about its centre
};

/// Of update_sleeping.
struct SleepScratch {
  std::vector<std::uint8_t> touching;  ///< bodies that touch anything
  std::vector<std::uint8_t> restless;  ///< of the body that stands for an island
};

}  // namespace tumble::sim
