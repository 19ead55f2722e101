#include "src/kernels/box_tests.h"

#include <cstddef>

#include "src/kernels/box_pair.h"

namespace tumble::sim {
namespace {

BoxPair pair_of(const BoxTests& tests, std::size_t k) {
  const Vec3 offset(tests.offset[0][k], tests.offset[1][k], tests.offset[2][k]);
  return {tests.frames[tests.a[k]], tests.frames[tests.b[k]], offset};
}

void put(BoxTests::Best& to, std::size_t k, const BestAxes& best) {
  to.axes[k] = best.axes;
  to.separation[k] = best.separation;
}

}  // namespace

void find_faces_singly(BoxTests& tests) {
  for (std::size_t k = 0; k < tests.count; ++k) {
    const BoxPair pair = pair_of(tests, k);
    put(tests.faces_of_a, k, pair.best(kFacesOfA));
    put(tests.faces_of_b, k, pair.best(kFacesOfB));
  }
}

void find_edges_singly(BoxTests& tests) {
  for (std::size_t k = 0; k < tests.count; ++k) put(tests.edges, k, pair_of(tests, k).best(kEdges));
}

}  // namespace tumble::sim
