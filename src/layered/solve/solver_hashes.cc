#include "src/layered/solve/solver_hashes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace tumble::sim {
namespace {

// No padding, on any machine.
static_assert(sizeof(SolverBody) == 16 * sizeof(double));
static_assert(sizeof(PointBatch) == 8 * sizeof(Lanes));
static_assert(sizeof(ContactBatch) - offsetof(ContactBatch, friction) == 29 * sizeof(Lanes));

bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// Adds bytes [kBegin, kEnd) of every row. The rows lie far apart, and waiting for memory would take longer than
// hashing. So each part is prefetched before its turn and copied into a block that stays in the nearest cache.
template <std::size_t kBegin, std::size_t kEnd, class Row>
void add_parts(const std::vector<Row>& rows, Hasher& hasher) {
  static_assert(kBegin % sizeof(Lanes) == 0 && kEnd % sizeof(Lanes) == 0 && kEnd <= sizeof(Row));
  constexpr std::size_t kBytes = kEnd - kBegin, kAhead = 1 + 4096 / kBytes, kBlockRows = 1 + 4096 / kBytes;
  alignas(64) double block[kBlockRows * kBytes / sizeof(double)];
  const auto part_of = [&](std::size_t k) { return reinterpret_cast<const std::byte*>(&rows[k]) + kBegin; };
  for (std::size_t begin = 0; begin < rows.size(); begin += kBlockRows) {
    const std::size_t count = std::min(kBlockRows, rows.size() - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const std::byte* ahead = part_of(std::min(begin + k + kAhead, rows.size() - 1));
      for (std::size_t at = 0; at < kBytes; at += sizeof(Lanes)) __builtin_prefetch(ahead + at);
      std::memcpy(block + k * kBytes / sizeof(double), part_of(begin + k), kBytes);
    }
    hasher.add(std::span<const double>(block, count * kBytes / sizeof(double)));
  }
}

}  // namespace

void hash_solver_bodies(const Scratch& scratch, Hasher& hasher) { hasher.add(doubles_of(scratch.solver_bodies)); }

void hash_parting_bodies(const Scratch& scratch, Hasher& hasher) {
  const std::vector<SolverBody>& bodies = scratch.solver_bodies;
  std::array<SolverBody, 64> block;
  for (std::size_t begin = 0; begin < bodies.size(); begin += block.size()) {
    const std::size_t count = std::min(block.size(), bodies.size() - begin);
    for (std::size_t k = 0; k < count; ++k) {
      block[k] = bodies[begin + k];
      block[k].velocity = scratch.overlaps.velocity[begin + k];
      block[k].spin = scratch.overlaps.spin[begin + k];
    }
    hasher.add({reinterpret_cast<const double*>(block.data()), count * sizeof(SolverBody) / sizeof(double)});
  }
}

void hash_prepared(const Scratch& scratch, Hasher& hasher) {
  hash_solver_bodies(scratch, hasher);
  hasher.add(std::span<const std::uint8_t>(scratch.in_contact));
  hash_batches(scratch.contact_batches, hasher);
}

void hash_batches(const ContactBatches& all, Hasher& hasher) {
  hasher.add(std::span<const std::uint32_t>(all.order));
  hasher.add(doubles_of(all.points));
  add_parts<offsetof(ContactBatch, friction), sizeof(ContactBatch)>(all.batches, hasher);
}

void hash_solution(const Scratch& scratch, Hasher& hasher) {
  hash_solver_bodies(scratch, hasher);
  const ContactBatches& all = scratch.contact_batches;
  add_parts<offsetof(ContactBatch, force1), offsetof(ContactBatch, split_a)>(all.batches, hasher);
  add_parts<offsetof(PointBatch, impulse), offsetof(PointBatch, mass)>(all.points, hasher);
  if (!scratch.fast.none()) hash_batches(scratch.fast.batches, hasher);
}

void hash_moved(const Bodies& bodies, const Scratch& scratch, Hasher& hasher) {
  const Vec3Column& inertia = bodies.inertia;
  const bool all_even = same_bytes(inertia.x, inertia.y) && same_bytes(inertia.y, inertia.z);
  if (!all_even) hash_solver_bodies(scratch, hasher);
  add_parts<offsetof(PointBatch, separation), offsetof(PointBatch, impulse)>(scratch.contact_batches.points, hasher);
  if (scratch.fast.none()) return;
  hash_solver_bodies(scratch, hasher);
  hash_batches(scratch.fast.batches, hasher);
}

}  // namespace tumble::sim
