#include "src/layered/solve/fast_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "src/kernels/contacts/contact_batch.h"

namespace tumble::sim {
namespace {

FastBody fast_body_of(const Bodies& bodies, BodyIndex i) {
  FastBody body;
  body.row = i;
  body.position = bodies.position[i];
  body.orientation = bodies.orientation[i];
  body.velocity = bodies.velocity[i];
  body.spin = bodies.spin[i];
  return body;
}

// A contact that presses, its bodies, and whether it bounces.
struct Pressing {
  std::uint32_t a, b;
  bool bounces;
  std::size_t batch;
  unsigned lane;
};

// A contact that does not bounce from its push does not bounce in this substep, even if the bodies' turn brings points
// closer: it is found again in the next one.
void slow_approaches(ContactBatches& all, ContactBatch& batch, unsigned lane) {
  batch.bounces = static_cast<std::uint8_t>(batch.bounces & ~(1U << lane));
  for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
    double& approach = all.points[k].approach.of[lane];
    approach = std::max(approach, -0.5 * (kRestingSpeed + kFastBounceMin));
  }
}

// Calls visit(Pressing) for the contacts with an impulse, by several workers at a time.
template <class Visit>
void for_pressing(Scratch& scratch, Visit visit) {
  ContactBatches& all = scratch.fast.batches;
  for_fast_batches(scratch, 0, [&](const ContactWork&, std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      ContactBatch& batch = all.batches[at];
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
        if (presses) visit(Pressing{all.sides[at].a[lane], all.sides[at].b[lane], bounces, at, lane});
      }
    }
  });
}

FastBody* body_of(FastContacts& fast, std::uint32_t row) {
  return row < fast.place.size() ? &fast.bodies[fast.place[row]] : nullptr;  // the ground is the row after the last
}

Vec3 vector_of(const Lanes (&of)[3], unsigned lane) { return {of[0].of[lane], of[1].of[lane], of[2].of[lane]}; }

// Calls visit(point, speed) for the points of a contact, with the speed at which they part, m/s. Null: a body that
// stands still.
template <class Visit>
void for_points(const ContactBatches& all, const Pressing& contact, const SolverBody* a, const SolverBody* b,
                Visit visit) {
  const ContactBatch& batch = all.batches[contact.batch];
  const unsigned lane = contact.lane;
  const auto velocity = [](const SolverBody* of) { return of == nullptr ? Vec3(Vec3::Zero()) : of->velocity; };
  const auto spin = [](const SolverBody* of) { return of == nullptr ? Vec3(Vec3::Zero()) : of->spin; };
  const Vec3 u = (velocity(b) - velocity(a)) - cross(spin(a), vector_of(batch.d, lane)), w = spin(b) - spin(a);
  const double un = dot(u, vector_of(batch.n, lane));
  const double w1 = dot(w, vector_of(batch.t1, lane)), w2 = dot(w, vector_of(batch.t2, lane));
  for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
    const PointBatch& point = all.points[k];
    visit(point, un + (w1 * point.q.of[lane] - w2 * point.p.of[lane]));
  }
}

// How fast the points of a contact part, m/s, the slowest; negative where one closes.
double parting_of(const ContactBatches& all, const Pressing& contact, const SolverBody* a, const SolverBody* b) {
  double parting = std::numeric_limits<double>::infinity();
  for_points(all, contact, a, b, [&](const PointBatch& point, double speed) {
    if (point.peak.of[contact.lane] > 0) parting = std::min(parting, speed);
  });
  return parting;
}

// Null for a body that stands still.
const SolverBody* moving_body(const Bodies& bodies, const Scratch& scratch, std::uint32_t row) {
  return row < bodies.size() && bodies.moves(row) ? &scratch.solver_bodies[row] : nullptr;
}

// A body that waits while one that presses it goes on would be run through. So it goes on too, where that leaves less
// than half of the overlap: what is hit between two others may go into the one behind, if it goes on, and waits then.
void leave_none_waiting_alone(const Bodies& bodies, Scratch& scratch, double substep_s) {
  FastContacts& fast = scratch.fast;
  const auto moving = [&](std::uint32_t row) { return moving_body(bodies, scratch, row); };
  const auto waits = [&](std::uint32_t row) {
    return fast_body(scratch, row) != nullptr && shared::read(body_of(fast, row)->waits);
  };
  for_pressing(scratch, [&](const Pressing& contact) {
    const double parting = parting_of(fast.batches, contact, moving(contact.a), moving(contact.b));
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)})
      if (body != nullptr) shared::lower(body->parting, parting);
  });
  std::uint8_t any = 1;
  while (any != 0) {
    any = 0;
    for_pressing(scratch, [&](const Pressing& contact) {
      const auto follows = [&](std::uint32_t row, std::uint32_t other) {
        if (moving(row) == nullptr || !waits(row) || moving(other) == nullptr || waits(other)) return;
        FastBody& body = *body_of(fast, row);
        const double run_into = -(row == contact.a ? parting_of(fast.batches, contact, nullptr, moving(other))
                                                   : parting_of(fast.batches, contact, moving(other), nullptr));
        if (run_into * (substep_s - body.flown_s) <= kSlop || -body.parting > 0.5 * run_into) return;
        shared::write(body.waits, false);
        mark(any);
      };
      follows(contact.a, contact.b);
      follows(contact.b, contact.a);
    });
  }
}

}  // namespace

void list_fast_bodies(const WorldState& state, Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  fast.batches.batches.clear();  // those of the last step
  fast.batches.points.clear();
  fast.batches.impacts.clear();
  fast.batches.order.clear();
  fast.bodies.clear();  // their rows may be gone
  fast.remembers = false;
  if (fast.none()) return;
  const Bodies& bodies = state.bodies;
  const std::size_t n = bodies.size();
  fast.place.resize(n);
  fast.marked.resize(n);
  std::vector<std::uint32_t>& before = fast.members;  // bodies that the workers before list
  const unsigned parts = part_count(scratch.workers, n, kBodiesAPart);
  before.assign(parts + 1, 0);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share share = worker.share(n), pairs = worker.share(fast.pairs.size());
    std::fill(fast.marked.begin() + static_cast<std::ptrdiff_t>(share.begin),
              fast.marked.begin() + static_cast<std::ptrdiff_t>(share.end), std::uint8_t{0});
    worker.meet();
    for (std::size_t k = pairs.begin; k < pairs.end; ++k) {
      mark(fast.marked[fast.pairs[k].first]);
      if (fast.pairs[k].second != kGround) mark(fast.marked[fast.pairs[k].second]);
    }
    worker.meet();
    std::uint32_t count = 0;
    for (std::size_t i = share.begin; i < share.end; ++i) count += fast.marked[i];
    before[worker.part + 1] = count;
    worker.meet();
    if (worker.first()) {
      std::partial_sum(before.begin(), before.end(), before.begin());
      fast.bodies.resize(before.back());
    }
    worker.meet();
    std::uint32_t at = before[worker.part];
    for (auto i = static_cast<BodyIndex>(share.begin); i < share.end; ++i) {
      if (fast.marked[i] == 0) continue;
      fast.bodies[at] = fast_body_of(bodies, i);
      fast.place[i] = at++;
      if (bodies.moves(i) && scratch.in_contact[i] == kFree) scratch.in_contact[i] = kInFastPair;
    }
  });
}

void mark_pressed(Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  for_pressing(scratch, [&](const Pressing& contact) {
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)}) {
      if (body != nullptr) shared::write(body->pressed, true);
    }
  });
}

void find_flying(const Bodies& bodies, Scratch& scratch, double substep_s) {
  FastContacts& fast = scratch.fast;
  for_fast_bodies(scratch, [](FastBody& body) {
    body.flying = true;
    body.waits = false;
    body.parting = 0;
  });
  std::uint8_t any_waits = 0;
  for_pressing(scratch, [&](const Pressing& contact) {
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)}) {
      if (body == nullptr) continue;
      shared::write(body->flying, false);
      if (!contact.bounces) continue;
      shared::write(body->waits, true);
      mark(any_waits);
    }
  });
  if (any_waits != 0) leave_none_waiting_alone(bodies, scratch, substep_s);
}

void take_back_gifts(const Bodies& bodies, Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  ContactBatches& all = fast.batches;
  constexpr double kParts = 1 << 30, kNearest = 0.5;  // of the largest work at a body: whole numbers add up alike
  for_fast_bodies(scratch, [](FastBody& body) { body.work_most = 0, body.given = body.taken = 0; });
  const auto absorbed = [&](const Pressing& contact) -> double& {
    return all.impacts[all.batches[contact.batch].impact].absorbed.of[contact.lane];
  };
  // J that the contact has given the bodies; negative: taken.
  const auto work_of = [&](const Pressing& contact) {
    if (contact.bounces) return -absorbed(contact);
    double work = 0;
    for_points(all, contact, moving_body(bodies, scratch, contact.a), moving_body(bodies, scratch, contact.b),
               [&](const PointBatch& point, double speed) {
                 work += 0.5 * point.impulse.of[contact.lane] * (point.approach.of[contact.lane] + speed);
               });
    return std::max(0.0, work);
  };
  for_pressing(scratch, [&](const Pressing& contact) {
    const double work = std::fabs(work_of(contact));
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)})
      if (body != nullptr) shared::raise(body->work_most, work);
  });
  for_pressing(scratch, [&](const Pressing& contact) {
    const double work = work_of(contact);
    if (work == 0) return;
    for (FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)})
      if (body != nullptr)
        shared::add(work > 0 ? body->given : body->taken,
                    static_cast<std::int64_t>(std::fabs(work) / body->work_most * kParts + kNearest));
  });
  for_pressing(scratch, [&](const Pressing& contact) {
    if (!contact.bounces) return;
    double part = 1;
    for (const FastBody* body : {body_of(fast, contact.a), body_of(fast, contact.b)}) {
      if (body == nullptr || body->given == 0) continue;
      part = std::min(part, body->taken <= body->given
                                ? 0.0
                                : 1 - static_cast<double>(body->given) / static_cast<double>(body->taken));
    }
    if (part < 1) absorbed(contact) *= part;
  });
}

void release_untouched(WorldState& state, Scratch& scratch) {
  Bodies& bodies = state.bodies;
  for_fast_bodies(scratch, [&](const FastBody& body) {
    if (body.pressed || scratch.in_contact[body.row] != kInFastPair) return;
    scratch.in_contact[body.row] = kFree;
    bodies.position.set(body.row, body.position);
    bodies.orientation.set(body.row, body.orientation);
    bodies.velocity.set(body.row, body.velocity);
    bodies.spin.set(body.row, body.spin);
  });
}

}  // namespace tumble::sim
