#include "src/solve/solver_hashes.h"

#include <cstring>

namespace tumble::sim {
namespace {

// Rows in memory without a gap, whatever the machine.
static_assert(sizeof(SolverBody) == 16 * sizeof(double));
static_assert(sizeof(PointBatch) == 8 * sizeof(Lanes));

// Numbers from all over memory, hashed in blocks that stay in the nearest cache.
class Values {
 public:
  explicit Values(Hasher& hasher) : hasher_(hasher) {}
  ~Values() { flush(); }
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;

  /// Fields that are doubles or made of them.
  template <class... Fields>
  void add(const Fields&... fields) {
    constexpr std::size_t kCount = (sizeof(Fields) + ...) / sizeof(double);
    if (used_ + kCount > kBlock) flush();
    (put(fields), ...);
  }

  /// Hands on what there is; what is hashed by other means comes after it.
  void flush() {
    hasher_.add(std::span<const double>(block_, used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kBlock = 1024;

  template <class Field>
  void put(const Field& field) {
    constexpr std::size_t kCount = (sizeof(Field) + 0) / sizeof(double);
    static_assert(kCount * sizeof(double) == sizeof(Field));
    std::memcpy(block_ + used_, &field, sizeof field);
    used_ += kCount;
  }

  Hasher& hasher_;
  std::size_t used_ = 0;
  double block_[kBlock];
};

// What solving needs beside the contact's place in space, which is the manifold's own.
void add_prepared(const ContactBatch& c, Values& values) {
  values.add(c.friction, c.friction_dynamic, c.restitution, c.force1, c.force2, c.twist, c.split_a, c.split_b);
  values.add(c.acceleration, c.impulse_magic, c.centre_p, c.centre_q, c.radius, c.friction_inverse, c.response,
             c.relaxation);
}

}  // namespace

void hash_solver_bodies(const World& world, Hasher& hasher) { hasher.add(doubles_of(world.scratch().solver_bodies)); }

void hash_prepared(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  hash_solver_bodies(world, hasher);
  hasher.add(std::span<const std::uint8_t>(scratch.in_contact));
  hasher.add(std::span<const std::uint32_t>(scratch.contact_batches.order));
  hasher.add(doubles_of(scratch.contact_batches.points));
  Values values(hasher);
  for (const ContactBatch& batch : scratch.contact_batches.batches) add_prepared(batch, values);
}

void hash_solution(const World& world, Hasher& hasher) {
  const ContactBatches& all = world.scratch().contact_batches;
  hash_solver_bodies(world, hasher);
  Values values(hasher);
  for (const ContactBatch& batch : all.batches) values.add(batch.force1, batch.force2, batch.twist);
  for (const PointBatch& point : all.points) values.add(point.impulse, point.peak);
}

void hash_moved(const World& world, Hasher& hasher) {
  const Vec3Column& inertia = world.bodies().inertia;
  const bool all_even = inertia.x == inertia.y && inertia.y == inertia.z;
  if (!all_even) hash_solver_bodies(world, hasher);
  Values values(hasher);
  for (const PointBatch& point : world.scratch().contact_batches.points) values.add(point.separation);
}

}  // namespace tumble::sim
