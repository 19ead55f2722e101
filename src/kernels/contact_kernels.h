#pragma once

#include <cstddef>
#include <cstdint>

#include "src/kernels/contact_batch.h"

namespace tumble::sim {

inline constexpr double kBounceMin = 0.5;  ///< m/s; slower impacts do not bounce

enum class Sweep : std::uint8_t { kPush, kRelax, kRestitution };

/// A body as the kernels read it: what SolverBody begins with. 16 doubles a row.
inline constexpr std::size_t kSolverBodyDoubles = 16;
/// What a manifold does to one of its bodies: changes of velocity and spin, then two zeros.
inline constexpr std::size_t kOutcomeDoubles = 8;

/// What the kernels work on: manifolds of one layer, and all bodies. Manifolds are solved at the same time: each writes
/// what it does to its two bodies as a row of its own, and the bodies take those up when all have.
struct ContactWork {
  ContactBatch* batches = nullptr;
  std::size_t count = 0;
  PointBatch* points = nullptr;
  double* bodies = nullptr;    ///< rows of SolverBody, kSolverBodyDoubles each
  double* outcomes = nullptr;  ///< rows of kOutcomeDoubles: of lane l of batch k, a's is 2 (k kLanes + l), then b's
  const std::uint32_t* entries = nullptr;  ///< rows of outcomes, body by body
  double substep_s = 0;
};

/// The mathematics of the solver over batches of manifolds, compiled once for each lane width.
struct ContactKernels {
  /// Fills what stays fixed during a step: the masses, responses and approaches of points, where friction acts.
  void (*prepare)(const ContactWork& work);
  /// Improves the impulses against the velocities of `bodies`, writes what that does to `outcomes`.
  void (*solve)(const ContactWork& work, Sweep sweep);
  /// Writes what the accumulated impulses do to `outcomes`.
  void (*warm_start)(const ContactWork& work);
  /// Adds their outcomes to the velocities and spins of `bodies`.
  void (*apply_outcomes)(const ContactWork& work, const BodyOutcomes* of, std::size_t count);
  /// Moves the separations on by one sub-step with the velocities of `bodies`.
  void (*move_on)(const ContactWork& work);
  /// Fits masses and responses of slender batches to bodies that have turned.
  void (*renew)(const ContactWork& work);
};

}  // namespace tumble::sim
