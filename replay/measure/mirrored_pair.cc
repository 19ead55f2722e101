#include "replay/measure/mirrored_pair.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "replay/codec/state_keys.h"
#include "replay/format/not_finite.h"
#include "replay/session/state_source.h"
#include "tumble/replay/session.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

/// Equality of bits: −0.0 is not 0.0.
bool same(double a, double b) { return bits_of(a) == bits_of(b); }

bool same(const sim::Vec3& a, const sim::Vec3& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

bool same(const sim::Quat& a, const sim::Quat& b) {
  return same(a.w, b.w) && same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// The first reason why `transformed` is not the transform of `original`; empty: it is.
std::string not_the_transform(const sim::SceneDef& original, const sim::SceneDef& transformed,
                              const sim::Transform& transform, const sim::IdMap& ids) {
  const sim::SceneDef wanted = image_of(original, transform, ids);
  const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + " " + what; };
  if (transformed.world != wanted.world) return "other world parameters";
  if (transformed.boxes.size() != wanted.boxes.size()) {
    return count(transformed.boxes.size(), "boxes") + ", wanted " + std::to_string(wanted.boxes.size());
  }
  for (std::size_t i = 0; i < wanted.boxes.size(); ++i) {
    if (transformed.boxes[i] != wanted.boxes[i]) return "another box " + std::to_string(transformed.boxes[i].id);
  }
  if (transformed.inputs != wanted.inputs) return "other inputs";
  return "";
}

}  // namespace

void PairMeter::differs(std::uint64_t step, sim::BodyId id, double distance) {
  if (!report_.first_step) report_.first_step = step;
  report_.error = largest(report_.error, distance);
  if (differing_.insert(id).second) ++report_.differing;
}

// Exactness is a claim about bits, so `differing` compares all columns bit by bit. The error in metres is for judging a
// session that is not exact: a wrong bit in a velocity shows in a position one step later. Positions lie on a grid;
// a mirror, a swap of axes or a shift by grid steps rounds nothing, so the expected values are exact too.
void PairMeter::add(std::uint64_t step, const BodyStates& original, const BodyStates& transformed) {
  std::size_t matched = 0;
  for (std::size_t i = 0; i < original.size(); ++i) {
    const sim::BodyId id = sim::image_of(original.id[i], ids_);
    const auto at = std::ranges::lower_bound(transformed.id, id);
    if (at == transformed.id.end() || *at != id) {
      differs(step, original.id[i], kNoPartner);
      continue;
    }
    ++matched;
    const auto j = static_cast<std::size_t>(at - transformed.id.begin());
    const sim::Vec3 wanted = transform_.point(original.position[i]);
    const bool exact = same(wanted, transformed.position[j]) && original.frozen[i] == transformed.frozen[j] &&
                       same(transform_.orientation(original.orientation[i]), transformed.orientation[j]) &&
                       same(transform_.vector(original.velocity[i]), transformed.velocity[j]) &&
                       same(transform_.axial_vector(original.spin[i]), transformed.spin[j]);
    if (exact && is_finite(original, i)) continue;
    const sim::Vec3 apart = transformed.position[j] - wanted;
    const bool finite = is_finite(original, i) && is_finite(transformed, j);
    differs(step, original.id[i], finite ? std::sqrt(sim::dot(apart, apart)) : kNotANumber);
  }
  if (matched < transformed.size()) differs(step, sim::kBodyIdMax, kNoPartner);
}

Result<PairReport> run_mirrored_pair(const sim::SceneDef& scene, const sim::Transform& transform,
                                     const Progress& progress) {
  const sim::IdMap ids = ids_under(scene, transform);
  Result<Session> original = Session::start(scene);
  if (!original.ok()) return original.error();
  Result<Session> transformed = Session::start(image_of(scene, transform, ids));
  if (!transformed.ok()) return transformed.error();
  PairMeter meter(transform, ids);
  BodyStates states, transformed_states;
  const auto measure = [&](std::uint64_t k) {
    copy_visible(original->world().bodies(), states);
    copy_visible(transformed->world().bodies(), transformed_states);
    meter.add(k, states, transformed_states);
  };
  measure(0);
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    if (Result<TakenStep> taken = original->step(); !taken.ok()) return taken.error();
    if (Result<TakenStep> taken = transformed->step(); !taken.ok()) {
      return Error{taken.error().kind, "the transformed scene, " + to_string(transform) + ": " + taken.error().message};
    }
    measure(k);
    if (progress && !progress(k, scene.steps)) return cannot_finish("interrupted");
  }
  PairReport report = meter.report();
  report.steps = scene.steps;
  return report;
}

Result<PairReport> compare_mirrored_pair(LogReader& original, LogReader& transformed, const Progress& progress) {
  const sim::Transform& transform = transformed.header().transform;
  const sim::SceneDef& scene = original.header().scene;
  if (!original.header().transform.identity()) {
    return bad_input(original.name() + ": found a transformed session (" + to_string(original.header().transform) +
                     "), wanted the original");
  }
  const sim::IdMap ids = ids_under(scene, transform);
  if (const std::string why = not_the_transform(scene, transformed.header().scene, transform, ids); !why.empty()) {
    return bad_input(transformed.name() + ": is not the transformed session (" + to_string(transform) + ") of " +
                     original.name() + ": found " + why);
  }
  // Either log may lack states; StateSource simulates those.
  StateSource from(original), to(transformed);
  PairMeter meter(transform, ids);
  const std::uint64_t first = original.first_state();
  if (transformed.first_state() != first) {
    return bad_input(transformed.name() + ": found state " + std::to_string(transformed.first_state()) +
                     " at its start, wanted " + std::to_string(first) + " as in " + original.name());
  }
  const std::uint64_t last = std::min(original.last_step(), transformed.last_step());
  for (std::uint64_t k = first; k <= last; ++k) {
    Result<const StepRecord*> a = from.read(k);
    if (!a.ok()) return a.error();
    Result<const StepRecord*> b = to.read(k);
    if (!b.ok()) return b.error();
    meter.add(k, (*a)->states, (*b)->states);
    if (progress && !progress(k - first, last - first)) return cannot_finish("interrupted");
  }
  if (original.step_count() != transformed.step_count()) {
    return bad_input(transformed.name() + ": found " + std::to_string(transformed.step_count()) +
                     " steps, wanted as many as " + original.name() + " has: " + std::to_string(original.step_count()));
  }
  PairReport report = meter.report();
  report.steps = last - first;
  return report;
}

void set_pair_error(const sim::Transform& transform, const PairReport& report, SymmetryMetrics& metrics) {
  if (transform.mirror_x || transform.mirror_y || transform.swap_xy) metrics.mirror_error = report.error;
  if (transform.permute) metrics.order_error = report.error;
  if (transform.shift != sim::Vec3(0, 0, 0)) metrics.shift_error = report.error;
}

}  // namespace tumble::replay
