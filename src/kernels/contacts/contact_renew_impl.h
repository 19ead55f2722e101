#pragma once

// Masses and responses of manifolds whose bodies have turned since `prepare`, for any number of lanes. lane_vector.h
// says who may include this.

#include "src/kernels/contacts/contact_prepare_impl.h"

namespace tumble::sim {
namespace {

// Calls visit(column) for what prepare_responses computes of manifolds.
template <class Visit>
void for_responses(ContactBatch& batch, Visit visit) {
  for (Lanes& column : batch.friction_inverse) visit(column);
  for (Lanes& column : batch.response) visit(column);
  visit(batch.relaxation);
}

template <class V>
void renew(const ContactWork& work, ContactBatch& batch, unsigned at) {
  if (batch.turns == 0) return;
  const Manifolds<V> m(work, batch, at);
  Lanes turns;
  for (unsigned lane = 0; lane < kLanes; ++lane) turns.of[lane] = batch.turns >> lane & 1U;
  const auto turned = m.get(turns) > 0.0;
  V before[sizeof(batch.friction_inverse) / sizeof(Lanes) + sizeof(batch.response) / sizeof(Lanes) + 1];
  V masses[kPointsMax];
  V* at_before = before;
  for_responses(batch, [&](const Lanes& column) { *at_before++ = m.get(column); });
  for (unsigned k = 0; k < batch.count; ++k) masses[k] = m.get(m.points[k].mass);
  prepare_responses(m);
  at_before = before;
  for_responses(batch, [&](Lanes& column) {
    const V old = *at_before++;
    m.set(column, turned ? m.get(column) : old);
  });
  // A point without a mass takes no part in a bounce (find_fast_contacts).
  for (unsigned k = 0; k < batch.count; ++k) {
    Lanes& mass = m.points[k].mass;
    m.set(mass, (turned & (masses[k] != 0.0)) ? m.get(mass) : masses[k]);
  }
}

}  // namespace
}  // namespace tumble::sim
