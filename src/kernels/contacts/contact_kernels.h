#pragma once

#include <cstddef>
#include <cstdint>

#include "src/kernels/contacts/contact_batch.h"

namespace tumble::sim {

/// kHold holds points as they are; kPush gives overlaps a speed that ends them; kPart does only that, without friction,
/// for bodies at rest (part_overlaps); kStop stops points that met fast and do not bounce; kRestitution makes the
/// others bounce.
enum class Sweep : std::uint8_t { kPush, kHold, kPart, kStop, kRestitution };

/// Of an overlap, removed in a substep.
inline constexpr double kPushPart = 0.05;

/// Doubles in a row of SolverBody, as the kernels read it.
inline constexpr std::size_t kSolverBodyDoubles = 16;
/// Doubles in a row of Outcome: changes of velocity and spin, then two zeros.
inline constexpr std::size_t kOutcomeDoubles = 8;
/// m/s or rad/s: changes of a motion whose magnitudes add up to less have exact sums on VelocityGrid; others need a
/// wider grid.
inline constexpr double kMotionSumMax = 8192;

/// Which manifolds a visit of a layer solves: those that these sweeps have not solved yet, and those of which a body
/// has moved since. Another solution of the others would change nothing that counts.
struct Visit {
  std::uint32_t* moved = nullptr;  ///< by row of the bodies: number of the last visit that moved it
  std::uint32_t now = 0;           ///< number of this visit; they ascend within a step
  std::uint32_t first = 0;         ///< number with which these sweeps began
  std::uint32_t sweep = 0;         ///< sweeps before this one; BatchSides has how many a manifold gets
  bool bounces = false;            ///< the sweeps are turns of a bounce
  double still = 0;                ///< m/s or rad/s; a body moves where a number of its motion changes by more
};

/// The data of the kernels: manifolds of one layer, and all bodies. The manifolds of a layer are solved as if at one
/// time: each writes the outcomes for its two bodies into rows of its own, and the bodies add the outcomes up when all
/// manifolds are done.
struct ContactWork {
  ContactBatch* batches = nullptr;
  BatchSides* sides = nullptr;  ///< of each batch
  std::size_t count = 0;        ///< batches
  PointBatch* points = nullptr;
  ImpactBatch* impacts = nullptr;
  double* bodies = nullptr;    ///< rows of SolverBody, kSolverBodyDoubles each
  double* outcomes = nullptr;  ///< rows of kOutcomeDoubles; lane l of batch k: 2 (k kLanes + l) for a, next for b
  const std::uint32_t* entries = nullptr;  ///< rows of outcomes, body by body
  double substep_s = 0;
  double push_part = kPushPart;  ///< of an overlap, removed in that time
  Visit visit;
  bool leaves_old = false;  ///< solve() leaves old outcomes where a manifold is not due, instead of zeros
  double turn_s = 0;        ///< for which `prepare` and `move_on` turn the levers of contacts; 0: not
};

/// How many of the manifolds of a layer were due.
enum class Due : std::uint8_t { kNone, kSome, kAll };

/// The arithmetic of the solver over batches of manifolds.
struct ContactKernels {
  /// Fills the fields that stay fixed during a step: masses, responses and approaches of points, friction centres.
  /// Turns the levers.
  void (*prepare)(const ContactWork& work);
  /// Improves the impulses of the manifolds that are due, given the velocities of `bodies`; writes the changes to
  /// `outcomes`. kNone: `outcomes` is old. In kStop only those that met
  /// fast and do not bounce are due; in kRestitution manifolds that do not bounce hold.
  Due (*solve)(const ContactWork& work, Sweep sweep);
  /// Writes the effect of the accumulated impulses to `outcomes`.
  void (*warm_start)(const ContactWork& work);
  /// Adds the outcomes of each body in `of` to its velocity and spin in `bodies`, and notes which bodies move. kSome:
  /// only those of manifolds that this visit has solved. Returns whether one of them moves.
  bool (*apply_outcomes)(const ContactWork& work, const BodyOutcomes* of, std::size_t count, Due due);
  /// Advances the separations by one substep with the velocities of `bodies`, and turns the levers.
  void (*move_on)(const ContactWork& work);
  /// Computes masses and responses of the manifolds in ContactBatch::turns anew, after their bodies have turned.
  void (*renew)(const ContactWork& work);
  /// Marks the manifolds that do not overlap beyond the slop as visited; returns the deepest overlap beyond it, m, or
  /// 0.
  double (*find_overlaps)(const ContactWork& work);
  /// Before the sweeps of kPart: lays the impulses aside, in the place of the largest ones, since no point has been hit
  /// in this step yet, and starts from none. Outside hard batches computes the speed of each point that they want, in
  /// the place of its load.
  void (*begin_parting)(const ContactWork& work);
  /// Before sweeps, for the impacts [begin, end) of all batches: notes the motion, and the impulses that the bodies
  /// have got already: all, or none of those that a substep begins with.
  void (*begin_impacts)(const ContactWork& work, std::size_t begin, std::size_t end, bool has_impulses);
  /// After sweeps: adds the work since then to what the impulses have taken.
  void (*end_impacts)(const ContactWork& work, std::size_t begin, std::size_t end);
  /// The same for bodies that have stayed where they met and have got all impulses since: from the speeds of the
  /// impact.
  void (*end_whole_impacts)(const ContactWork& work, std::size_t begin, std::size_t end);
};

}  // namespace tumble::sim
