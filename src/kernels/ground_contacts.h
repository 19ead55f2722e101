#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble::sim {

/// m/s: slower than this there is no direction of slip to oppose.
inline constexpr double kSlipMin = 1e-12;

/// Boxes in the ground, in lanes, and the corners of each that lie in the ground.
struct GroundPoints {
  static constexpr std::size_t kMost = 8;  ///< a multiple of every width

  // Read.
  const double* frames = nullptr;       ///< rows of BoxFrame
  const std::uint32_t* body = nullptr;  ///< by contact, a row of frames
  std::size_t count = 0;                ///< contacts, at most kMost

  // Written, by contact.
  alignas(64) double depth[kMost];         ///< m
  alignas(64) double point[3][kMost];      ///< m, where Fig. 6 merges the corners, from the centre
  alignas(64) double behind[kMost];        ///< a sum of powers of two, one for each corner in the ground; 0: no contact
  alignas(64) double corner[8][3][kMost];  ///< m, from the point; meaningless for a corner that is not in the ground
};

/// Collisions of moving bodies with the ground, each body with its whole mass and in one collision with the ground.
struct GroundCollisions {
  static constexpr unsigned kGainDoubles = 10, kMaterialDoubles = 4, kEncounterDoubles = 22;  ///< of rows

  // By body.
  const double* frames = nullptr;  ///< rows of BoxFrame
  const double *velocity[3] = {}, *spin[3] = {}, *mass = nullptr, *inverse_mass = nullptr, *inverse_inertia[3] = {};
  const double *friction = nullptr, *friction_dynamic = nullptr, *restitution = nullptr;
  // Of the ground and of the substep.
  double ground_friction = 0, ground_friction_dynamic = 0, ground_restitution = 0, slip_speed = 0;
  double gained[3] = {};  ///< m/s, by gravity
  double dt_s = 0;
  // By contact, as in Contacts.
  const std::uint32_t* body = nullptr;
  const double* r[3] = {};                   ///< m, the collision point from the centre of mass
  const double* patch = nullptr;             ///< rows of three
  const std::uint32_t* patch_end = nullptr;  ///< likewise
  // Written, by contact.
  double* impulse[3] = {};          ///< N·s, on the ground
  double* gains = nullptr;          ///< rows of Gain, of every second row
  double* energy = nullptr;         ///< J, twice, of every second row: of the gain alone
  double* materials = nullptr;      ///< rows of PairMaterial
  double* approach = nullptr;       ///< m/s, in rows of Encounter
  std::uint8_t* resting = nullptr;  ///< as in Collision
};

/// The arithmetic of find_contacts and compute_impulses for the ground. Null with one lane: the phases' own functions
/// are that lane.
struct GroundKernels {
  void (*find_points)(GroundPoints& points);
  void (*collide)(const GroundCollisions& work, std::size_t begin, std::size_t end);  ///< contacts [begin, end)
};

}  // namespace tumble::sim
