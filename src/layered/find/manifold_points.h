#pragma once

#include <vector>

#include "src/base/large_vector.h"
#include "src/collide/box_pair.h"
#include "tumble/sim/manifold.h"

namespace tumble::sim {

/// Two boxes of a manifold. The manifold is built on a face or an edge of the reference box.
struct ManifoldSide {
  const BoxFrame* reference;
  const BoxFrame* incident;
  Vec3 d;                       ///< m, from the reference's centre to the incident's
  bool reference_is_lower_row;  ///< decides the names of features
  double margin;                ///< m; points farther apart are left out
};

/// Finds the contact points on a reference face: corners of the incident box inside the face, corners of the face
/// inside the incident face, and crossings of edges. Each kind is found on its own, not by clipping one edge after the
/// other, so the points depend on no order of edges. Where two incident faces tie exactly, both count. Writes n, t1,
/// t2, d, offset, first, count of the manifold and appends its points.
void face_manifold(const ManifoldSide& side, int axis, Manifold& manifold, LargeVector<ManifoldPoint>& points);

/// Whether one edge of the box in the direction of axis `edge` lies farthest out along n; two tie where boxes lie on a
/// lattice.
bool one_farthest_edge(const BoxFrame& box, int edge, const Vec3& n);

/// Finds the contact point of two crossing edges. axis: 6 + 3i + j as in box_pair.h, of (reference, incident).
void edge_manifold(const ManifoldSide& side, const BoxPair& pair, int axis, double separation, Manifold& manifold,
                   LargeVector<ManifoldPoint>& points);

/// Finds the corners of a box that are at most `reach` (m) above the ground z = 0.
void ground_manifold(const BoxFrame& frame, double reach, Manifold& manifold, LargeVector<ManifoldPoint>& points);

}  // namespace tumble::sim
