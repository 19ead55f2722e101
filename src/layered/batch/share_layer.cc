#include "src/layered/batch/share_layer.h"

namespace tumble::sim {
namespace {

// All manifolds of a layer start from one velocity of a body and correct it fully, so k manifolds together would
// overshoot by k times. Mass splitting gives each manifold a body of 1/k of the mass; the k outcomes then add up to one
// correction (Tonge, Benevolenski and Voroshilov 2012, Mass splitting for jitter-free parallel rigid body simulation).
class Sharing {
 public:
  // uses: by body, zeros, as afterwards.
  Sharing(const Bodies& bodies, ContactBatches& all, std::vector<std::uint32_t>& uses)
      : bodies_(bodies), all_(all), uses_(uses) {}

  // first: row of the layer's first body in `touched`, and of its first outcome in `entries`.
  void share(std::uint32_t layer, std::uint32_t first) {
    const std::uint32_t begin = all_.layer_start[layer], end = all_.layer_start[layer + 1];
    BodyOutcomes* const touched = all_.touched.data() + first;
    std::uint32_t count = 0, entries = first;
    for_sides(begin, end, [&](BodyIndex i, Lanes&, unsigned, std::uint32_t) {
      if (uses_[i]++ == 0) touched[count++] = {i, 0, 0};
    });
    for (std::uint32_t k = 0; k < count; ++k) {
      BodyOutcomes& of = touched[k];
      of.begin = of.end = entries;
      entries += uses_[of.body];
      uses_[of.body] = k;
    }
    for_sides(begin, end,
              [&](BodyIndex i, Lanes&, unsigned, std::uint32_t row) { all_.entries[touched[uses_[i]].end++] = row; });
    for_sides(begin, end, [&](BodyIndex i, Lanes& split, unsigned lane, std::uint32_t) {
      const BodyOutcomes& of = touched[uses_[i]];
      split.of[lane] = of.end - of.begin;
    });
    for (std::uint32_t k = 0; k < count; ++k) uses_[touched[k].body] = 0;
    all_.touched_start[layer] = first;
    all_.touched_end[layer] = first + count;
  }

 private:
  // Calls visit(body, split, lane, row of outcomes) for both bodies of every manifold of batches [begin, end), if they
  // move.
  template <class Visit>
  void for_sides(std::uint32_t begin, std::uint32_t end, Visit visit) {
    for (std::uint32_t k = begin; k < end; ++k) {
      ContactBatch& batch = all_.batches[k];
      for (unsigned lane = 0; lane < batch.used; ++lane) {
        const std::uint32_t row = 2 * ((k - begin) * kLanes + lane);
        const BodyIndex a = all_.sides[k].a[lane], b = all_.sides[k].b[lane];
        if (a < bodies_.size() && bodies_.moves(a)) visit(a, batch.split_a, lane, row);
        if (bodies_.moves(b)) visit(b, batch.split_b, lane, row + 1);
      }
    }
  }

  const Bodies& bodies_;
  ContactBatches& all_;
  std::vector<std::uint32_t>& uses_;
};

}  // namespace

void share_layer(const Bodies& bodies, std::uint32_t layer, std::uint32_t members_before,
                 std::vector<std::uint32_t>& uses, ContactBatches& all) {
  Sharing(bodies, all, uses).share(layer, 2 * members_before);  // a manifold has two bodies at most
}

}  // namespace tumble::sim
