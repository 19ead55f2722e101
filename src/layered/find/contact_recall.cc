#include "src/layered/find/contact_recall.h"

#include <algorithm>

#include "src/layered/find/contact_memory.h"

namespace tumble::sim {
namespace {

void take_friction(Manifold& m, const ContactMemory& memory, std::size_t k, double sign) {
  const Vec3 force = memory.friction[k] * sign;
  m.force1 = dot(force, m.t1);
  m.force2 = dot(force, m.t2);
  m.twist = memory.twist[k];
}

// Where several entries tie and name a point, the largest impulse counts; the order of entries is that of axes.
void take_impulses(std::span<ManifoldPoint> points, const ContactMemory& memory, std::size_t first, std::size_t count) {
  for (ManifoldPoint& point : points) {
    for (std::size_t j = first; j < first + count; ++j) {
      if (memory.feature[j] == point.feature) point.impulse = std::max(point.impulse, memory.impulse[j]);
    }
  }
}

}  // namespace

// The entries of a pair: several where reference bodies or faces tie.
std::pair<std::size_t, std::size_t> ContactRecall::entries(BodyIndex lo, BodyIndex hi) {
  const ContactPair wanted(lo, hi);
  while (cursor_ < memory_.size() && pair_of(memory_, cursor_) < wanted) {
    point_ += memory_.count[cursor_];
    ++cursor_;
  }
  std::size_t end = cursor_;
  while (end < memory_.size() && pair_of(memory_, end) == wanted) ++end;
  return {cursor_, end};
}

bool ContactRecall::pressed(BodyIndex lo, BodyIndex hi) {
  const auto [begin, end] = entries(lo, hi);
  std::size_t points = 0;
  for (std::size_t k = begin; k < end; ++k) points += memory_.count[k];
  return std::ranges::any_of(std::span(memory_.impulse).subspan(point_, points), [](double x) { return x > 0; });
}

void ContactRecall::warm_start(Manifold& m, std::span<ManifoldPoint> points) {
  const auto [lo, hi] = pair_of(m.a, m.b);
  const auto [begin, end] = entries(lo, hi);
  std::size_t own = 0;
  for (std::size_t k = begin; k < end; ++k) own += memory_.a[k] == m.a ? 1U : 0U;
  std::size_t point = point_;
  for (std::size_t k = begin; k < end; point += memory_.count[k], ++k) {
    // An entry with the other reference body serves only where no entry has this one; its friction is then reversed.
    const bool turned = memory_.a[k] != m.a;
    if (turned && own > 0) continue;
    take_impulses(points, memory_, point, memory_.count[k]);
    if ((own > 0 ? own : end - begin) == 1) take_friction(m, memory_, k, turned ? -1.0 : 1.0);
  }
}

void ContactRecall::keep(BodyIndex lo, BodyIndex hi, ManifoldList& to) {
  const auto [begin, end] = entries(lo, hi);
  std::size_t point = point_;
  for (std::size_t k = begin; k < end; ++k) {
    Manifold& m = to.manifolds.emplace_back(Manifold{});
    m.a = memory_.a[k];
    m.b = memory_.b[k];
    m.asleep = true;
    m.first = static_cast<std::uint32_t>(to.points.size());
    m.count = memory_.count[k];
    m.d = memory_.friction[k];  // until the memory is written again
    m.twist = memory_.twist[k];
    for (std::uint32_t i = 0; i < m.count; ++i, ++point) {
      ManifoldPoint& p = to.points.emplace_back(ManifoldPoint{});
      p.feature = memory_.feature[point];
      p.impulse = memory_.impulse[point];
    }
  }
}

}  // namespace tumble::sim
