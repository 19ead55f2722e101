#include "src/layered/find/find_manifolds.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/layered/find/build_manifolds.h"
#include "src/layered/find/contact_memory.h"
#include "src/layered/find/join_lists.h"
#include "src/world/hash_on_the_way.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kWorthPairs = 1024;  // and bodies, that pay for one more worker

constexpr std::size_t kPiecesAPart = 16;  // of the bodies, in the mean

// Cuts the bodies into pieces, ascending, and lists those of each worker. Returns where these begin.
std::vector<std::uint32_t>& cut_bodies(const WorldState& state, Scratch& scratch, unsigned parts) {
  const std::size_t n = state.bodies.size(), most = 1 + (n - 1) / (kPiecesAPart * parts);
  std::vector<ManifoldPiece>& pieces = scratch.manifold_pieces;
  pieces.clear();
  for (unsigned part = 0; part < parts; ++part) {
    scratch.homes.for_own(Worker{scratch.workers, part, parts}, n, [&](std::size_t begin, std::size_t end) {
      const std::size_t count = (end - begin + most - 1) / most;
      for (std::size_t k = 0; k < count; ++k) {
        ManifoldPiece& piece = pieces.emplace_back();
        piece.worker = part;
        piece.bodies.begin = begin + (end - begin) * k / count;
        piece.bodies.end = begin + (end - begin) * (k + 1) / count;
      }
    });
  }
  std::ranges::sort(pieces, {}, [](const ManifoldPiece& piece) { return piece.bodies.begin; });
  std::vector<std::uint32_t>& start = scratch.pieces_start;
  start.assign(parts + 1, 0);
  for (const ManifoldPiece& piece : pieces) ++start[piece.worker + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  scratch.pieces_by.resize(pieces.size());
  for (std::uint32_t k = 0; k < pieces.size(); ++k) scratch.pieces_by[start[pieces[k].worker]++] = k;
  std::shift_right(start.begin(), start.end(), 1);
  start[0] = 0;
  return start;
}

// Finds where the impulses of each block begin. What one of the workers does.
void find_places(const WorldState& state, std::span<ManifoldPiece> pieces, const Worker& worker) {
  const ContactMemory& memory = state.contact_memory;
  const Worker::Share own = worker.share(pieces.size());
  std::size_t begin = own.begin < own.end ? contacts_before(memory, {pieces[own.begin].bodies.begin, 0}) : 0;
  for (std::size_t k = own.begin; k < own.end; ++k) {
    const std::size_t end =
        k + 1 == pieces.size() ? memory.size() : contacts_before(memory, {pieces[k + 1].bodies.begin, 0});
    const auto counts = memory.count.begin();
    pieces[k].memory = {begin, std::accumulate(counts + static_cast<std::ptrdiff_t>(begin),
                                               counts + static_cast<std::ptrdiff_t>(end), std::size_t{0})};
    begin = end;
  }
  worker.meet();
  if (worker.first()) {
    std::size_t points = 0;
    for (ManifoldPiece& piece : pieces) points += std::exchange(piece.memory.point, points);
  }
  worker.meet();
}

ManifoldPiece::Sizes sizes_of(const ManifoldList& list) {
  return {list.manifolds.size(), list.points.size(), list.fast_pairs.size()};
}

// Several workers find the manifolds, each into a list of its own.
void find_together(const WorldState& state, Scratch& scratch, double dt_s, unsigned parts) {
  const std::vector<std::uint32_t>& start = cut_bodies(state, scratch, parts);
  std::vector<ManifoldPiece>& pieces = scratch.manifold_pieces;
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    ManifoldList& list = scratch.manifolds_by[worker.part];
    list.clear();
    find_places(state, pieces, worker);
    const Worker::Share own = {start[worker.part], start[worker.part + 1]};
    SharedBlocks(scratch.blocks_left, own, worker).take_all([&](std::size_t k) {
      ManifoldPiece& piece = pieces[scratch.pieces_by[k]];
      piece.worker = worker.part;
      piece.begin = sizes_of(list);
      build_manifolds(
          state, scratch, dt_s,
          {static_cast<BodyIndex>(piece.bodies.begin), static_cast<BodyIndex>(piece.bodies.end), piece.memory}, list,
          nullptr);
      piece.end = sizes_of(list);
    });
  });
}

// Exchanges the lists of the scratch with those of the first worker: one who works alone finds into the former.
void swap_first(Scratch& scratch) {
  std::swap(scratch.manifolds, scratch.manifolds_by[0].manifolds);
  std::swap(scratch.manifold_points, scratch.manifolds_by[0].points);
  std::swap(scratch.fast.pairs, scratch.manifolds_by[0].fast_pairs);
}

void find_alone(const WorldState& state, Scratch& scratch, double dt_s, Hasher* hasher) {
  swap_first(scratch);
  scratch.manifolds_by[0].clear();
  build_manifolds(state, scratch, dt_s, {0, static_cast<BodyIndex>(state.bodies.size()), {}}, scratch.manifolds_by[0],
                  hasher);
  swap_first(scratch);
}

// Marks the bodies that a contact pressed at the end of the last step.
void mark_held(const ContactMemory& memory, Workers* workers, std::vector<std::uint8_t>& held) {
  for_ranges(workers, memory.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    std::size_t point = points_before(memory, begin);
    for (std::size_t k = begin; k < end; ++k) {
      bool pressed = false;
      for (const std::size_t past = point + memory.count[k]; point < past; ++point)
        pressed |= memory.impulse[point] > 0;
      if (!pressed) continue;
      if (memory.a[k] != kGround) mark(held[memory.a[k]]);
      mark(held[memory.b[k]]);
    }
  });
}

// Joins what several workers have found, in order of bodies.
void join(Scratch& scratch, unsigned parts) {
  scratch.fast.pairs.clear();
  for (const ManifoldPiece& piece : scratch.manifold_pieces) {
    const auto found = std::span(scratch.manifolds_by[piece.worker].fast_pairs)
                           .subspan(piece.begin.fast_pairs, piece.end.fast_pairs - piece.begin.fast_pairs);
    scratch.fast.pairs.insert(scratch.fast.pairs.end(), found.begin(), found.end());
  }
  const std::span<ManifoldList> lists = std::span(scratch.manifolds_by).first(parts);
  join_lists(scratch.manifold_pieces, lists, scratch.workers, scratch.manifolds, scratch.manifold_points);
  std::vector<Homes::Range>& ranges = scratch.manifold_ranges;
  ranges.clear();
  ranges.reserve(scratch.manifold_pieces.size());  // how many there are depends on who was quick
  std::uint32_t begin = 0;
  for (const ManifoldPiece& piece : scratch.manifold_pieces) {
    const auto end = static_cast<std::uint32_t>(begin + (piece.end.manifolds - piece.begin.manifolds));
    if (!ranges.empty() && ranges.back().worker == piece.worker) {
      ranges.back().end = end;
    } else if (begin < end) {
      ranges.push_back({begin, end, piece.worker});
    }
    begin = end;
  }
  scratch.manifold_homes.settle(ranges, begin, parts, *scratch.workers);
  make_room(lists, scratch.manifolds.size(), scratch.manifold_points.size());
  for (ManifoldList& list : lists) list.fast_pairs.reserve(scratch.fast.pairs.size());
}

void add_fast_pairs(const Scratch& scratch, Hasher& hasher) {
  for (const auto& [a, b] : scratch.fast.pairs) hasher.add(std::uint64_t{a} << 32U | b);
}

}  // namespace

Status find_manifolds(WorldState& state, Scratch& scratch, double dt_s) {
  Hasher* const hasher = take_hasher(scratch);
  const std::size_t work = state.pairs.size() + state.bodies.size();
  const unsigned parts = part_count(scratch.workers, work, kWorthPairs);
  if (scratch.manifolds_by.size() < parts) scratch.manifolds_by.resize(parts);
  // What sleeps, or wakes in this step, rests on something. Where it began the session asleep, no impulse tells so.
  scratch.held = state.bodies.frozen;
  for (const BodyIndex i : scratch.waking.woken) scratch.held[i] = 1;
  mark_held(state.contact_memory, scratch.workers, scratch.held);
  std::size_t found = 0;
  scratch.manifold_homes.clear();
  if (parts == 1) {
    find_alone(state, scratch, dt_s, hasher);
    found = scratch.manifolds.size();
  } else {
    find_together(state, scratch, dt_s, parts);
    for (unsigned part = 0; part < parts; ++part) found += scratch.manifolds_by[part].manifolds.size();
  }
  const std::size_t n = state.bodies.size(), most = manifolds_max(n);
  if (found > most) {
    return cannot_finish("found more than " + std::to_string(most) + " contacts of " + std::to_string(n) +
                         " bodies; so many stand inside one another: set them farther apart");
  }
  if (parts > 1) join(scratch, parts);
  if (hasher != nullptr) add_fast_pairs(scratch, *hasher);
  return {};
}

void hash_find_manifolds(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_manifolds(scratch, hasher);
  add_fast_pairs(scratch, hasher);
}

}  // namespace tumble::sim
