#pragma once

#include <span>

#include "src/kernels/contacts/contact_batch.h"
#include "src/world/scratch.h"

namespace tumble::sim {

/// A contact of a batch, whose impulses are summed on a grid that fits its lighter body.
struct ContactLane {
  const ContactBatch& batch;
  const PointBatch* points;  ///< of the batch
  unsigned lane;
  bool bounced;  ///< or was taken along by what bounces
};

/// N·s, the sum of the impulses of the contact's points; exact, whatever their order.
double impulse_of(const ContactLane& contact, std::span<const ManifoldPoint> points);

/// Whether keep_borne may take something: where no point met its body, and the impulse has at most doubled since
/// `before`, it takes nothing, and needs neither loads nor weights. before: as for keep_borne.
bool grew(const ContactLane& contact, double before, std::span<const ManifoldPoint> points);

/// Takes from the impulses with which a step ended what stopped or threw bodies in the step, so that the next step
/// starts from what the contact bears. before: N·s, what impulse_of said when the step began; weight: N·s, the weight
/// of the lighter body for a substep.
void keep_borne(const ContactLane& contact, double before, double weight, Manifold& m, std::span<ManifoldPoint> points);

}  // namespace tumble::sim
