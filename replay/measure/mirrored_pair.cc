#include "replay/measure/mirrored_pair.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "replay/codec/state_keys.h"
#include "replay/session/session.h"
#include "replay/session/state_source.h"

namespace tumble::replay {
namespace {

bool same(double a, double b) { return bits_of(a) == bits_of(b); }

bool same(const sim::Vec3& a, const sim::Vec3& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

bool same(const sim::Quat& a, const sim::Quat& b) {
  return same(a.w, b.w) && same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// What keeps `image` from being the image of `original`; empty if nothing does.
std::string not_an_image(const sim::SceneDef& original, const sim::SceneDef& image, const sim::Transform& transform,
                         const sim::IdMap& ids) {
  const sim::SceneDef wanted = image_of(original, transform, ids);
  const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + " " + what; };
  if (image.world != wanted.world) return "other world parameters";
  if (image.boxes.size() != wanted.boxes.size()) {
    return count(image.boxes.size(), "boxes") + ", wanted " + std::to_string(wanted.boxes.size());
  }
  for (std::size_t i = 0; i < wanted.boxes.size(); ++i) {
    if (image.boxes[i] != wanted.boxes[i]) return "another box " + std::to_string(image.boxes[i].id);
  }
  if (image.inputs != wanted.inputs) return "other inputs";
  return "";
}

}  // namespace

void TwinMeter::differs(std::uint64_t step, sim::BodyId id, double distance) {
  if (!report_.first_step) report_.first_step = step;
  report_.error = std::max(report_.error, distance);
  if (differing_.insert(id).second) ++report_.differing;
}

void TwinMeter::add(std::uint64_t step, const BodyStates& original, const BodyStates& image) {
  std::size_t matched = 0;
  for (std::size_t i = 0; i < original.size(); ++i) {
    const sim::BodyId id = sim::image_of(original.id[i], ids_);
    const auto at = std::ranges::lower_bound(image.id, id);
    if (at == image.id.end() || *at != id) {
      differs(step, original.id[i], kNoTwin);
      continue;
    }
    ++matched;
    const auto j = static_cast<std::size_t>(at - image.id.begin());
    const sim::Vec3 wanted = transform_.point(original.position[i]);
    const bool exact = same(wanted, image.position[j]) && original.frozen[i] == image.frozen[j] &&
                       same(transform_.orientation(original.orientation[i]), image.orientation[j]) &&
                       same(transform_.vector(original.velocity[i]), image.velocity[j]) &&
                       same(transform_.axial_vector(original.spin[i]), image.spin[j]);
    if (exact) continue;
    const sim::Vec3 apart = image.position[j] - wanted;
    differs(step, original.id[i], std::sqrt(sim::dot(apart, apart)));
  }
  if (matched < image.size()) differs(step, sim::kBodyIdMax, kNoTwin);
}

Result<TwinReport> run_twins(const sim::SceneDef& scene, const sim::Transform& transform, const Progress& progress) {
  const sim::IdMap ids = ids_under(scene, transform);
  Result<Session> original = Session::start(scene);
  if (!original.ok()) return original.error();
  Result<Session> image = Session::start(image_of(scene, transform, ids));
  if (!image.ok()) return image.error();
  TwinMeter meter(transform, ids);
  BodyStates states, image_states;
  const auto measure = [&](std::uint64_t k) {
    copy_visible(original->world().bodies(), states);
    copy_visible(image->world().bodies(), image_states);
    meter.add(k, states, image_states);
  };
  measure(0);
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    if (Result<TakenStep> taken = original->step(); !taken.ok()) return taken.error();
    if (Result<TakenStep> taken = image->step(); !taken.ok()) {
      return Error{taken.error().kind, "the image, " + to_string(transform) + ": " + taken.error().message};
    }
    measure(k);
    if (progress && !progress(k, scene.steps)) return cannot_finish("interrupted");
  }
  TwinReport report = meter.report();
  report.steps = scene.steps;
  return report;
}

Result<TwinReport> compare_twins(LogReader& original, LogReader& image, const Progress& progress) {
  const sim::Transform& transform = image.header().transform;
  const sim::SceneDef& scene = original.header().scene;
  if (!original.header().transform.identity()) {
    return bad_input(original.name() + ": found an image (" + to_string(original.header().transform) +
                     "), wanted the original");
  }
  const sim::IdMap ids = ids_under(scene, transform);
  if (const std::string why = not_an_image(scene, image.header().scene, transform, ids); !why.empty()) {
    return bad_input(image.name() + ": is not the image (" + to_string(transform) + ") of " + original.name() +
                     ": found " + why);
  }
  StateSource from(original), to(image);
  TwinMeter meter(transform, ids);
  const std::uint64_t first = original.first_state();
  if (image.first_state() != first) {
    return bad_input(image.name() + ": found state " + std::to_string(image.first_state()) + " at its begin, wanted " +
                     std::to_string(first) + " as in " + original.name());
  }
  const std::uint64_t last = std::min(original.last_step(), image.last_step());
  for (std::uint64_t k = first; k <= last; ++k) {
    Result<const StepRecord*> a = from.read(k);
    if (!a.ok()) return a.error();
    Result<const StepRecord*> b = to.read(k);
    if (!b.ok()) return b.error();
    meter.add(k, (*a)->states, (*b)->states);
    if (progress && !progress(k - first, last - first)) return cannot_finish("interrupted");
  }
  if (original.step_count() != image.step_count()) {
    return bad_input(image.name() + ": found " + std::to_string(image.step_count()) + " steps, wanted as many as " +
                     original.name() + " has: " + std::to_string(original.step_count()));
  }
  TwinReport report = meter.report();
  report.steps = last - first;
  return report;
}

void set_twin_error(const sim::Transform& transform, const TwinReport& report, SymmetryMetrics& metrics) {
  if (transform.mirror_x || transform.mirror_y || transform.swap_xy) metrics.mirror_error = report.error;
  if (transform.permute) metrics.order_error = report.error;
  if (transform.shift != sim::Vec3(0, 0, 0)) metrics.shift_error = report.error;
}

}  // namespace tumble::replay
