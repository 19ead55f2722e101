#include "replay/measure/mirrored_pair.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "replay/codec/state_keys.h"
#include "replay/session/state_source.h"
#include "src/step/step.h"

namespace tumble::replay {
namespace {

bool same(double a, double b) { return bits_of(a) == bits_of(b); }

bool same(const sim::Vec3& a, const sim::Vec3& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

bool same(const sim::Quat& a, const sim::Quat& b) {
  return same(a.w, b.w) && same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// One of two worlds that are stepped side by side.
class Twin {
 public:
  static Result<Twin> create(sim::SceneDef scene) {
    Result<sim::World> world = sim::create_world(scene);
    if (!world.ok()) return world.error();
    return Twin(std::move(scene), *std::move(world));
  }

  Status step() {
    const std::uint64_t k = world_.state().step + 1;
    for (; next_ < scene_.inputs.size() && scene_.inputs[next_].step <= k; ++next_) {
      if (Status ok = sim::apply(world_, scene_.inputs[next_].command); !ok.ok()) return ok;
    }
    if (Result<sim::StepCounters> stepped = sim::step(world_); !stepped.ok()) return stepped.error();
    return {};
  }

  const BodyStates& states() {
    copy_visible(world_.bodies(), states_);
    return states_;
  }

 private:
  Twin(sim::SceneDef scene, sim::World world) : scene_(std::move(scene)), world_(std::move(world)) {}

  sim::SceneDef scene_;
  sim::World world_;
  BodyStates states_;
  std::size_t next_ = 0;  // input
};

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
  Result<Twin> original = Twin::create(scene);
  if (!original.ok()) return original.error();
  Result<Twin> image = Twin::create(image_of(scene, transform, ids));
  if (!image.ok()) return image.error();
  TwinMeter meter(transform, ids);
  meter.add(0, original->states(), image->states());
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    if (Status ok = original->step(); !ok.ok()) return ok.error();
    if (Status ok = image->step(); !ok.ok()) {
      return Error{ok.error().kind, "the image, " + to_string(transform) + ": " + ok.error().message};
    }
    meter.add(k, original->states(), image->states());
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
