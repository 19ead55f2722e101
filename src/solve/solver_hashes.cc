#include "src/solve/solver_hashes.h"

#include <algorithm>

namespace tumble::sim {
namespace {

// Numbers from all over memory, hashed in blocks that stay in the nearest cache.
class Values {
 public:
  explicit Values(Hasher& hasher) : hasher_(hasher) {}
  ~Values() { flush(); }
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;

  void add(double value) { *room_for(1) = value; }
  void add(const Vec3& v) {
    double* to = room_for(3);
    for (int k = 0; k < 3; ++k) to[k] = v[k];
  }
  template <std::size_t kCount>
  void add(const double (&row)[kCount]) {
    std::copy_n(row, kCount, room_for(kCount));
  }
  template <std::size_t kCount>
  void add(const Lanes (&rows)[kCount], unsigned lane) {
    double* to = room_for(kCount);
    for (std::size_t k = 0; k < kCount; ++k) to[k] = rows[k].of[lane];
  }

  /// Hands on what there is; what is hashed by other means comes after it.
  void flush() {
    hasher_.add(std::span<const double>(block_, used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kBlock = 1024;

  double* room_for(std::size_t count) {
    if (used_ + count > kBlock) flush();
    used_ += count;
    return block_ + (used_ - count);
  }

  Hasher& hasher_;
  std::size_t used_ = 0;
  double block_[kBlock];
};

// Calls visit(manifold, its batch, its lane).
template <class Visit>
void for_each_awake(const Scratch& scratch, Visit visit) {
  const ContactBatches& all = scratch.contact_batches;
  for (std::size_t k = 0; k < scratch.manifolds.size(); ++k) {
    if (scratch.manifolds[k].asleep) continue;
    visit(scratch.manifolds[k], all.batches[all.place[k] / kLanes], all.place[k] % kLanes);
  }
}

void add_motions(const World& world, Values& values) {
  const Scratch& scratch = world.scratch();
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
    values.add(scratch.solver_bodies[i].velocity);
    values.add(scratch.solver_bodies[i].spin);
  }
}

void add_contact(const ContactBatch& batch, unsigned lane, Values& values) {
  values.add(batch.a[lane]);
  values.add(batch.b[lane]);
  for (const auto* vector : {&batch.n, &batch.t1, &batch.t2, &batch.d}) values.add(*vector, lane);
  for (const Lanes* number :
       {&batch.point_count, &batch.offset, &batch.friction, &batch.friction_dynamic, &batch.restitution, &batch.force1,
        &batch.force2, &batch.twist, &batch.split_a, &batch.split_b, &batch.acceleration, &batch.impulse_magic,
        &batch.centre_p, &batch.centre_q, &batch.radius, &batch.relaxation}) {
    values.add(number->of[lane]);
  }
  values.add(batch.friction_inverse, lane);
  values.add(batch.response, lane);
}

}  // namespace

void hash_prepared(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  Values values(hasher);
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
    values.add(scratch.solver_bodies[i].inverse_mass);
    values.add(scratch.solver_bodies[i].weight);
    values.add(scratch.solver_bodies[i].inverse_inertia);
  }
  add_motions(world, values);
  for_each_awake(scratch, [&](const Manifold& m, const ContactBatch& batch, unsigned lane) {
    add_contact(batch, lane, values);
    for (std::uint32_t i = batch.first; i < batch.first + m.count; ++i) {
      const PointBatch& point = scratch.contact_batches.points[i];
      for (const Lanes* number : {&point.p, &point.q, &point.separation, &point.impulse, &point.load, &point.mass,
                                  &point.approach, &point.peak}) {
        values.add(number->of[lane]);
      }
    }
  });
  values.flush();
  hasher.add(std::span<const std::uint8_t>(scratch.in_contact));
}

void hash_solution(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  Values values(hasher);
  add_motions(world, values);
  for_each_awake(scratch, [&](const Manifold& m, const ContactBatch& batch, unsigned lane) {
    for (const Lanes* number : {&batch.force1, &batch.force2, &batch.twist}) values.add(number->of[lane]);
    for (std::uint32_t i = batch.first; i < batch.first + m.count; ++i) {
      const PointBatch& point = scratch.contact_batches.points[i];
      values.add(point.impulse.of[lane]);
      values.add(point.peak.of[lane]);
    }
  });
}

void hash_moved(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  Values values(hasher);
  add_motions(world, values);
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) values.add(scratch.solver_bodies[i].inverse_inertia);
  for_each_awake(scratch, [&](const Manifold& m, const ContactBatch& batch, unsigned lane) {
    for (std::uint32_t i = batch.first; i < batch.first + m.count; ++i) {
      values.add(scratch.contact_batches.points[i].separation.of[lane]);
    }
  });
}

void hash_stored(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  Values values(hasher);
  for (const std::uint32_t k : scratch.layered) {
    const Manifold& m = scratch.manifolds[k];
    for (const double number : {m.force1, m.force2, m.twist}) values.add(number);
    for (const ManifoldPoint& point : points_of(scratch, m)) {
      values.add(point.impulse);
      values.add(point.separation);
    }
  }
}

}  // namespace tumble::sim
