#include "replay/export/plan/export_plan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "replay/log/session_clock.h"
#include "replay/session/state_source.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// Follows the bodies of a session from input to input.
class BodyTracker {
 public:
  BodyTracker(const LogReader& log, const BodyTable& infos, const ExportChoice& choice)
      : infos_(infos), choice_(choice) {
    for (const sim::BoxDef& box : log.header().scene.boxes) appear(box);
  }

  void apply(const std::vector<sim::Command>& inputs) {
    for (const sim::Command& input : inputs) {
      if (const auto* thrown = std::get_if<sim::Throw>(&input)) appear(thrown->box);
      if (const auto* gone = std::get_if<sim::Remove>(&input)) vanish(gone->id);
    }
  }

  /// After lost steps: the bodies that are there by a state. Those that came in a lost step are known by nothing.
  void settle(const std::vector<sim::BodyId>& ids) {
    for (auto& [id, tracked] : bodies_) {
      const bool there = std::ranges::binary_search(ids, id);
      if (!there) {
        close(tracked);
      } else if (!tracked.there && tracked.body.box.id != 0) {
        tracked.there = true;
        tracked.since = marked_;
      }
    }
    for (const sim::BodyId id : ids) {
      if (!bodies_.contains(id)) undefined_.insert(id);
    }
  }

  /// Bodies with states that neither the scene nor an input that is left defines.
  [[nodiscard]] const std::set<sim::BodyId>& undefined() const { return undefined_; }

  /// The bodies that are there now belong to exported step `index`.
  void mark(std::size_t index) { marked_ = index + 1; }

  std::vector<ExportBody> take() {
    std::vector<ExportBody> bodies;
    for (auto& [id, body] : bodies_) {
      close(body);
      if (!body.body.runs.empty()) bodies.push_back(std::move(body.body));
    }
    return bodies;
  }

 private:
  struct Tracked {
    ExportBody body;
    bool there = false;
    std::size_t since = 0;
  };

  void appear(const sim::BoxDef& box) {
    const auto [place, is_new] = bodies_.try_emplace(box.id);
    Tracked& tracked = place->second;
    if (is_new) {
      tracked.body = {box, infos_.name(box.id), infos_.shape(box.id), {}};
      if (choice_.holds && !choice_.holds(box, tracked.body.name)) tracked.body.box.id = 0;
    }
    if (tracked.body.box.id == 0) return;  // not chosen
    tracked.there = true;
    tracked.since = marked_;
  }

  void vanish(sim::BodyId id) {
    const auto place = bodies_.find(id);
    if (place != bodies_.end()) close(place->second);
  }

  void close(Tracked& tracked) const {
    if (std::exchange(tracked.there, false) && tracked.since < marked_) {
      std::vector<ExportRun>& runs = tracked.body.runs;
      if (!runs.empty() && runs.back().end == tracked.since) {  // removed and thrown again between two exported steps
        runs.back().end = marked_;
      } else {
        runs.push_back({tracked.since, marked_});
      }
    }
  }

  const BodyTable& infos_;
  const ExportChoice& choice_;
  std::map<sim::BodyId, Tracked> bodies_;
  std::set<sim::BodyId> undefined_;
  std::size_t marked_ = 0;  // exported steps so far
};

Status check_missing(const LogReader& log, const ExportChoice& choice) {
  for (const MissingSteps& run : log.header().missing()) {
    if (run.end_step() <= choice.first || run.first_step > choice.last) continue;
    return bad_input(log.name() + ": " + to_string(run) +
                     " are missing, because the log was recovered from a damaged one; wanted --steps without them");
  }
  return {};
}

/// Time and exported steps.
class StepTracker {
 public:
  explicit StepTracker(const ExportChoice& choice) : choice_(choice) {}

  void add_step(double dt) {
    clock_.add_step(dt);
    if (inside_) {
      constant_ = constant_ && (dt_ == 0 || dt_ == dt);
      dt_ = dt;
      since_ = since_ == 0 ? dt : since_ + dt;
    }
  }

  /// Whether step k is exported.
  bool take(std::uint64_t k, ExportPlan& plan) {
    if (k < choice_.first || (k - choice_.first) % choice_.every != 0) return false;
    plan.steps.push_back(k);
    plan.times.push_back(clock_.now());
    plan.dts.push_back(inside_ ? since_ : 0);
    inside_ = true;
    since_ = 0;
    return true;
  }

  void finish(const LogHeader& header, ExportPlan& plan) const {
    if (!constant_) return;
    plan.dt = dt_ > 0 ? dt_ : header.scene.world.dt;
    for (std::size_t i = 1; i < plan.dts.size(); ++i) plan.dts[i] = *plan.dt * static_cast<double>(plan.every);
  }

 private:
  const ExportChoice& choice_;
  SessionClock clock_;
  bool inside_ = false, constant_ = true;
  double dt_ = 0;     // s, of the step before; 0: none inside the range
  double since_ = 0;  // s, since the exported state before
};

void leave_out_undefined(const std::set<sim::BodyId>& ids, const ExportChoice& choice, ExportPlan& plan) {
  plan.undefined.assign(ids.begin(), ids.end());
  if (ids.empty() || choice.holds) return;
  constexpr std::size_t kShown = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(plan.undefined.size(), kShown); ++i) {
    list += (i == 0 ? "" : ", ") + std::to_string(plan.undefined[i]);
  }
  if (plan.undefined.size() > kShown) list += ", …";
  plan.left_out.push_back(count_text(ids.size(), "body") +
                          " thrown in during lost steps, whose sizes nothing tells: " + list);
}

/// Whether step k, which is there, is the first behind lost ones.
bool is_behind_lost(const LogReader& log, std::uint64_t k) { return log.lost_at(k - 1) != nullptr; }

}  // namespace

Error with_advice(const Error& error, const LogReader& log, std::uint64_t step) {
  if (error.kind != ErrorKind::kDamaged) return error;
  const std::string first = std::to_string(log.first_state());
  return damaged(error.message + "; 'tumble recover' saves what is whole" +
                 (step > log.first_state() + 1  // the first state lies in the first chunk
                      ? ", and --steps " + first + ':' + std::to_string(step - 1) + " exports what comes before"
                      : ""));
}

bool ExportBody::at(std::size_t index) const {
  const auto after = std::ranges::upper_bound(runs, index, {}, &ExportRun::begin);
  return after != runs.begin() && index < std::prev(after)->end;
}

std::uint64_t ExportPlan::body_steps() const {
  std::uint64_t sum = 0;
  for (const ExportBody& body : bodies) {
    for (const ExportRun& run : body.runs) sum += run.end - run.begin;
  }
  return sum;
}

bool ExportPlan::all_present() const { return body_steps() == steps.size() * bodies.size(); }

bool ExportPlan::named() const {
  return std::ranges::any_of(bodies, [](const ExportBody& body) { return !body.name.empty(); });
}

std::string ExportPlan::place(std::size_t body, std::uint64_t step) const {
  const std::string name = bodies[body].name.empty() ? "" : " (" + printable(bodies[body].name) + ")";
  return "body " + std::to_string(bodies[body].box.id) + name + " at step " + std::to_string(step);
}

Result<ExportPlan> plan_export(LogReader& log, const ExportChoice& choice, const Progress& progress) {
  if (Status ok = check_missing(log, choice); !ok.ok()) return ok.error();
  ExportPlan plan;
  plan.header = log.header();
  plan.log_name = log.name();
  plan.every = choice.every;
  BodyTracker bodies(log, log.bodies(), choice);
  StepTracker steps(choice);
  double dt = log.header().scene.world.dt;  // of a step that is lost: as before it
  for (std::uint64_t k = log.first_state(); k <= choice.last; ++k) {
    if (k > log.first_state() && log.lost_at(k) == nullptr) {
      const Result<const StepRecord*> step = log.read_hashes(k);
      if (!step.ok()) return with_advice(step.error(), log, k);
      bodies.apply((*step)->inputs);
      dt = (*step)->dt;
      if (is_behind_lost(log, k)) {
        const Result<const StepRecord*> state = StateSource(log).read(k);
        if (!state.ok()) return with_advice(state.error(), log, k);
        bodies.settle((*state)->states.id);
      }
    }
    if (k > log.first_state()) steps.add_step(dt);
    if (steps.take(k, plan)) bodies.mark(plan.steps.size() - 1);
    if (progress && !progress(k - log.first_state(), 2 * (choice.last - log.first_state()) + 1)) {
      return cannot_finish(log.name() + ": interrupted");
    }
  }
  steps.finish(log.header(), plan);
  plan.bodies = bodies.take();
  plan.chosen = choice.holds != nullptr;
  leave_out_undefined(bodies.undefined(), choice, plan);
  if (plan.bodies.empty() && choice.holds) {
    return bad_input(log.name() + ": --bodies: found none of these bodies in steps " + std::to_string(choice.first) +
                     " to " + std::to_string(choice.last) + "; 'tumble dump' lists those there are");
  }
  return plan;
}

}  // namespace tumble::replay
