#include "src/layered/find/join_lists.h"

#include <algorithm>

namespace tumble::sim {
namespace {

// Of a pair, at most: a manifold for each axis of two boxes. On a face 12 corners of three tied faces, 4 of its own and
// 24 crossings of edges; one point for two edges.
constexpr std::size_t kPairManifolds = 15, kPairPoints = 6 * (12 + 4 + 24) + 9;

void copy_piece(const ManifoldPiece& piece, const ManifoldList& list, Manifold* manifolds, ManifoldPoint* points,
                std::size_t points_before) {
  for (std::size_t k = piece.begin.manifolds; k < piece.end.manifolds; ++k) {
    Manifold& m = *manifolds++ = list.manifolds[k];
    m.first = static_cast<std::uint32_t>(points_before + (m.first - piece.begin.points));
  }
  std::copy(list.points.data() + piece.begin.points, list.points.data() + piece.end.points, points + points_before);
}

}  // namespace

void join_lists(std::span<const ManifoldPiece> pieces, std::span<const ManifoldList> lists, Workers* workers,
                LargeVector<Manifold>& manifolds, LargeVector<ManifoldPoint>& points) {
  ManifoldPiece::Sizes all;
  for (const ManifoldPiece& piece : pieces) {
    all.manifolds += piece.end.manifolds - piece.begin.manifolds;
    all.points += piece.end.points - piece.begin.points;
  }
  resize_anew(manifolds, all.manifolds);
  resize_anew(points, all.points);
  work_together(workers, static_cast<unsigned>(lists.size()), [&](const Worker& worker) {
    std::size_t manifolds_before = 0, points_before = 0;
    for (const ManifoldPiece& piece : pieces) {
      if (piece.worker == worker.part) {
        copy_piece(piece, lists[piece.worker], manifolds.data() + manifolds_before, points.data(), points_before);
      }
      manifolds_before += piece.end.manifolds - piece.begin.manifolds;
      points_before += piece.end.points - piece.begin.points;
    }
  });
}

void make_room(std::span<ManifoldList> lists, std::size_t manifolds, std::size_t points) {
  for (ManifoldList& list : lists) {
    list.clear();
    reserve_anew(list.manifolds, manifolds + kPairManifolds);
    reserve_anew(list.points, points + kPairPoints);
  }
}

}  // namespace tumble::sim
