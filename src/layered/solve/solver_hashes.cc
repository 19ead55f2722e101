#include "src/layered/solve/solver_hashes.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

namespace tumble::sim {
namespace {

// No padding, on any machine.
static_assert(sizeof(SolverBody) == 16 * sizeof(double));
static_assert(offsetof(SolverBody, spin) == 3 * sizeof(double));
static_assert(sizeof(PointBatch) == 8 * sizeof(Lanes));
static_assert(sizeof(ContactBatch) - offsetof(ContactBatch, friction) == 29 * sizeof(Lanes));
static_assert(offsetof(PointBatch, q) == sizeof(Lanes));

// Bytes [kBegin, kEnd) of a row.
template <std::size_t kBegin, std::size_t kEnd, class Row>
std::span<const double> part_of_row(const Row& row) {
  static_assert(kBegin % sizeof(Lanes) == 0 && kEnd % sizeof(Lanes) == 0 && kEnd <= sizeof(Row));
  return {reinterpret_cast<const double*>(reinterpret_cast<const std::byte*>(&row) + kBegin),
          (kEnd - kBegin) / sizeof(double)};
}

// Adds bytes [kBegin, kEnd) of every row. The rows lie far apart, and waiting for memory would take longer than
// hashing. So each part is prefetched before its turn and copied into a block that stays in the nearest cache.
template <std::size_t kBegin, std::size_t kEnd, class Row>
void add_parts(const LargeVector<Row>& rows, Hasher& hasher) {
  constexpr std::size_t kBytes = kEnd - kBegin, kAhead = 1 + 4096 / kBytes, kBlockRows = 1 + 4096 / kBytes;
  alignas(64) double block[kBlockRows * kBytes / sizeof(double)];
  for (std::size_t begin = 0; begin < rows.size(); begin += kBlockRows) {
    const std::size_t count = std::min(kBlockRows, rows.size() - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const auto ahead = part_of_row<kBegin, kEnd>(rows[std::min(begin + k + kAhead, rows.size() - 1)]);
      for (std::size_t at = 0; at < ahead.size(); at += kLanes) __builtin_prefetch(&ahead[at]);
      std::memcpy(block + k * kBytes / sizeof(double), part_of_row<kBegin, kEnd>(rows[begin + k]).data(), kBytes);
    }
    hasher.add(std::span<const double>(block, count * kBytes / sizeof(double)));
  }
}

std::span<const double> points_of_batch(const ContactBatches& all, const ContactBatch& batch) {
  return doubles_of(all.points, batch.first, batch.first + batch.count);
}

// Adds the columns that turn_levers writes.
void add_levers(const ContactBatches& all, const ContactBatch& batch, GatheredNumbers& numbers) {
  numbers.add(part_of_row<offsetof(ContactBatch, d), offsetof(ContactBatch, friction)>(batch));
  numbers.add(part_of_row<offsetof(ContactBatch, centre_p), offsetof(ContactBatch, radius)>(batch));
  for (std::uint32_t at = batch.first; at < batch.first + batch.count; ++at) {
    numbers.add(part_of_row<offsetof(PointBatch, p), offsetof(PointBatch, load)>(all.points[at]));
  }
}

// sink: a Hasher, or GatheredNumbers.
template <class Sink>
void add_batch(const ContactBatches& all, const ContactBatch& batch, Sink& sink) {
  sink.add(part_of_row<offsetof(ContactBatch, friction), sizeof(ContactBatch)>(batch));
  sink.add(points_of_batch(all, batch));
  if (batch.levers_turned) sink.add(part_of_row<offsetof(ContactBatch, d), offsetof(ContactBatch, friction)>(batch));
}

void add_absorbed(const ContactBatches& all, Hasher& hasher) {
  for (const ImpactBatch& impact : all.impacts) hasher.add(std::span<const double>(impact.absorbed.of));
}

}  // namespace

void add_solver_bodies(const Scratch& scratch, std::size_t begin, std::size_t end, GatheredNumbers& numbers) {
  constexpr std::size_t kOfBody = sizeof(SolverBody) / sizeof(double);
  for (std::size_t i = begin; i < end; ++i) {
    if (scratch.in_contact[i] == 0) continue;
    std::memcpy(numbers.next(kOfBody), doubles_of(scratch.solver_bodies, i, i + 1).data(), sizeof(SolverBody));
  }
}

void add_solver_velocities(const Scratch& scratch, Hasher& hasher) {
  constexpr std::size_t kAhead = 32;
  GatheredNumbers numbers(&hasher);
  const std::size_t n = scratch.in_contact.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t ahead = std::min(i + kAhead, n - 1);
    __builtin_prefetch(&scratch.solver_bodies[scratch.in_contact[ahead] != 0 ? ahead : n]);
    if (scratch.in_contact[i] == 0) continue;
    std::memcpy(numbers.next(6), doubles_of(scratch.solver_bodies, i, i + 1).data(), 6 * sizeof(double));
  }
}

void add_batches(const ContactBatches& all, std::size_t begin, std::size_t end, Hasher& hasher) {
  for (std::size_t k = begin; k < end; ++k) add_batch(all, all.batches[k], hasher);
}

void add_fast_batches(const Scratch& scratch, Hasher& hasher) {
  const ContactBatches& all = scratch.fast.batches;
  hasher.add(std::span<const std::uint32_t>(all.order));
  add_batches(all, 0, all.batches.size(), hasher);
  add_absorbed(all, hasher);
}

void hash_solution(const Scratch& scratch, Hasher& hasher) {
  add_solver_velocities(scratch, hasher);
  const ContactBatches& all = scratch.contact_batches;
  add_parts<offsetof(ContactBatch, force1), offsetof(ContactBatch, split_a)>(all.batches, hasher);
  add_parts<offsetof(PointBatch, impulse), offsetof(PointBatch, mass)>(all.points, hasher);
  add_absorbed(all, hasher);
  if (!scratch.fast.none()) add_fast_batches(scratch, hasher);
}

void add_separations(const ContactBatches& all, std::size_t begin, std::size_t end, GatheredNumbers& numbers) {
  for (std::size_t k = begin; k < end; ++k) {
    const ContactBatch& batch = all.batches[k];
    for (std::uint32_t at = batch.first; at < batch.first + batch.count; ++at) {
      std::memcpy(numbers.next(kLanes), &all.points[at].separation, sizeof(Lanes));
    }
  }
}

void add_moved_contacts(const ContactBatches& all, std::size_t begin, std::size_t end, GatheredNumbers& numbers) {
  add_separations(all, begin, end, numbers);
  for (std::size_t k = begin; k < end; ++k) {
    const ContactBatch& batch = all.batches[k];
    if (batch.turns != 0) {
      add_batch(all, batch, numbers);
    } else if (batch.levers_turned) {
      add_levers(all, batch, numbers);
    }
  }
}

}  // namespace tumble::sim
