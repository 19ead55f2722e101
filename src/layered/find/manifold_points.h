#pragma once

#include <vector>

#include "src/kernels/box_pair.h"
#include "src/world/manifold.h"

namespace tumble::sim {

/// Two boxes seen from the one whose face or edge the manifold is built on.
struct ManifoldSide {
  const BoxFrame* reference;
  const BoxFrame* incident;
  Vec3 d;                       ///< from the reference's centre to the incident's
  bool reference_is_lower_row;  ///< for the names of features
  double margin;                ///< m; points farther apart are left out
};

/// The contact points on a reference face: corners of the incident box inside it, its own corners inside the incident
/// face, crossings of edges. Each kind is found on its own, never by clipping one polygon after the other, so no order
/// of edges shows; where two incident faces tie exactly, both count.
/// Writes n, t1, t2, d, offset, count of the manifold and appends its points.
void face_manifold(const ManifoldSide& side, int axis, Manifold& manifold, std::vector<ManifoldPoint>& points);

/// The one contact point of two crossing edges; axis: 6 + 3i + j as in box_pair.h, of (reference, incident).
void edge_manifold(const ManifoldSide& side, const BoxPair& pair, int axis, double separation, Manifold& manifold,
                   std::vector<ManifoldPoint>& points);

/// The corners of a box near the ground z = 0.
void ground_manifold(const BoxFrame& frame, double reach, Manifold& manifold, std::vector<ManifoldPoint>& points);

}  // namespace tumble::sim
