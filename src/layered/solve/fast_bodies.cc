#include "src/layered/solve/fast_bodies.h"

#include <algorithm>

#include "src/kernels/contacts/contact_batch.h"

namespace tumble::sim {
namespace {

void list_rows(const WorldState& state, FastContacts& fast) {
  fast.place.resize(state.bodies.size());
  std::vector<BodyIndex>& rows = fast.members;
  rows.clear();
  for (const auto& [a, b] : fast.pairs) {
    rows.push_back(a);
    if (b != kGround) rows.push_back(b);
  }
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

// A contact that presses, and whether it bounces.
struct Pressing {
  std::uint32_t a, b;
  bool bounces;
};

// A contact that does not bounce from its push does not bounce in this substep, even if the bodies' turn brings points
// closer: it is found again in the next one.
void slow_approaches(ContactBatches& all, const ContactBatch& batch, unsigned lane) {
  for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
    double& approach = all.points[k].approach.of[lane];
    approach = std::max(approach, -0.5 * (kRestingSpeed + kFastBounceMin));
  }
}

// Calls visit(Pressing) for the contacts with an impulse.
template <class Visit>
void for_pressing(ContactBatches& all, Visit visit) {
  for (std::size_t at = 0; at < all.batches.size(); ++at) {
    const ContactBatch& batch = all.batches[at];
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      bool presses = false, fast = false;
      for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
        const PointBatch& point = all.points[k];
        if (point.peak.of[lane] == 0) continue;
        presses = true;
        fast |= point.approach.of[lane] <= -kFastBounceMin;
      }
      const bool bounces = fast && batch.restitution.of[lane] > 0;
      if (!bounces) slow_approaches(all, batch, lane);
      if (presses) visit(Pressing{all.sides[at].a[lane], all.sides[at].b[lane], bounces});
    }
  }
}

FastBody* body_of(FastContacts& fast, std::uint32_t row) {
  return row < fast.place.size() ? &fast.bodies[fast.place[row]] : nullptr;  // the ground is the row after the last
}

}  // namespace

void list_fast_bodies(const WorldState& state, Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  fast.batches.batches.clear();  // those of the last step
  fast.batches.points.clear();
  fast.batches.order.clear();
  fast.bodies.clear();  // their rows may be gone
  if (fast.none()) return;
  const Bodies& bodies = state.bodies;
  list_rows(state, fast);
  for (const BodyIndex i : fast.members) {
    fast.place[i] = static_cast<std::uint32_t>(fast.bodies.size());
    FastBody& body = fast.bodies.emplace_back();
    body.row = i;
    body.position = bodies.position[i];
    body.orientation = bodies.orientation[i];
    body.velocity = bodies.velocity[i];
    body.spin = bodies.spin[i];
    if (bodies.moves(i) && scratch.in_contact[i] == 0) scratch.in_contact[i] = kInFastPair;
  }
  fast.memory = state.contact_memory;
}

void mark_pressed(Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  for_pressing(fast.batches, [&](const Pressing& contact) {
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)}) {
      if (body != nullptr) body->pressed = true;
    }
  });
}

void find_flying(Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  for (FastBody& body : fast.bodies) {
    body.flying = true;
    body.waits = false;
  }
  for_pressing(fast.batches, [&](const Pressing& contact) {
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)}) {
      if (body == nullptr) continue;
      body->flying = false;
      body->waits |= contact.bounces;
    }
  });
}

void release_untouched(WorldState& state, Scratch& scratch) {
  Bodies& bodies = state.bodies;
  for (const FastBody& body : scratch.fast.bodies) {
    if (body.pressed || scratch.in_contact[body.row] != kInFastPair) continue;
    scratch.in_contact[body.row] = 0;
    bodies.position.set(body.row, body.position);
    bodies.orientation.set(body.row, body.orientation);
    bodies.velocity.set(body.row, body.velocity);
    bodies.spin.set(body.row, body.spin);
  }
}

}  // namespace tumble::sim
