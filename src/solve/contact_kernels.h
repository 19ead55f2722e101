#pragma once

#include <cstddef>
#include <cstdint>

#include "src/world/contact_batch.h"

namespace tumble::sim {

/// VelocityGrid::kMagic, here because the kernels' files see no header with functions of its own.
inline constexpr double kMotionMagic = 6755399441055744.0 / 274877906944.0;

inline constexpr double kBounceMin = 0.5;  ///< m/s; slower impacts do not bounce

enum class Sweep : std::uint8_t { kPush, kRelax, kRestitution };

/// A body as the kernels read it: what SolverBody begins with. 16 doubles a row.
inline constexpr std::size_t kSolverBodyDoubles = 16;
/// A row of sums in progress: velocity, spin, two unused. 8 doubles.
inline constexpr std::size_t kSolverMotionDoubles = 8;

/// What the kernels work on: the manifolds of one layer, and all bodies.
struct ContactWork {
  ContactBatch* batches = nullptr;
  std::size_t count = 0;
  PointBatch* points = nullptr;
  double* bodies = nullptr;  ///< rows of SolverBody, kSolverBodyDoubles each
  double* sums = nullptr;    ///< rows of SolverMotion, kSolverMotionDoubles each
  double substep_s = 0;
};

/// The mathematics of the solver over batches of manifolds, compiled once for each lane width.
struct ContactKernels {
  /// Fills what stays fixed during a step: the masses, responses and approaches of points, where friction acts.
  void (*prepare)(const ContactWork& work);
  /// Improves the impulses against the velocities of `bodies`, adds what they do to `sums`.
  void (*solve)(const ContactWork& work, Sweep sweep);
  /// Adds what the accumulated impulses do to `sums`.
  void (*warm_start)(const ContactWork& work);
  /// Moves the separations on by one sub-step with the velocities of `bodies`.
  void (*move_on)(const ContactWork& work);
};

/// Whether this machine and this build run a width.
bool runs_lanes(LaneWidth width);

/// "one", "two", "four", "eight", "widest".
const char* name_of(LaneWidth width);

/// The kernels of a width. Precondition: runs_lanes(width).
const ContactKernels& contact_kernels(LaneWidth width);

// Each is defined where the compiler makes that width, and null elsewhere.
const ContactKernels* contact_kernels_one();
const ContactKernels* contact_kernels_two();
const ContactKernels* contact_kernels_four();
const ContactKernels* contact_kernels_eight();

}  // namespace tumble::sim
