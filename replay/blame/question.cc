#include "replay/blame/question.h"

#include <variant>

#include "replay/blame/body_motion.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

// The input that explains why a body does not exist after step k; empty without one.
std::string why_missing(StepsAgain& steps, sim::BodyId body, std::uint64_t k) {
  LogReader& log = steps.log();
  for (std::uint64_t j = k; j > log.first_state() && log.holds(j); --j) {
    const Result<std::vector<sim::Command>> inputs = steps.inputs(j);
    if (!inputs.ok()) break;
    for (const sim::Command& input : *inputs) {
      const auto* remove = std::get_if<sim::Remove>(&input);
      if (remove == nullptr || remove->id != body) continue;
      return ": an input removed it before step " + std::to_string(j) + "; ask for --step " + std::to_string(j - 1) +
             " or less";
    }
  }
  for (std::uint64_t j = k + 1; j <= log.last_step() && log.holds(j); ++j) {
    const Result<std::vector<sim::Command>> inputs = steps.inputs(j);
    if (!inputs.ok()) break;
    for (const sim::Command& input : *inputs) {
      const auto* made = std::get_if<sim::Throw>(&input);
      if (made == nullptr || made->box.id != body) continue;
      return ": an input throws it in before step " + std::to_string(j) + "; ask for --step " + std::to_string(j) +
             " or more";
    }
  }
  return "; 'tumble dump " + log.name() + " --step " + std::to_string(k) + "' lists the bodies";
}

Status check_step(LogReader& log, std::uint64_t k) {
  if (log.header().engine) {
    return bad_input(log.name() + ": this log was written by " + printable(to_string(*log.header().engine)) +
                     ", whose steps this build cannot take again; 'tumble diff' compares such a log with another, with "
                     "--zoom down to a line of the engine, and 'tumble dump' prints it");
  }
  if (k < log.first_state() || k > log.last_step()) {
    return bad_input(log.name() + ": found no step " + std::to_string(k) + ", wanted " +
                     std::to_string(log.first_state()) + " to " + std::to_string(log.last_step()));
  }
  if (const MissingSteps* lost = log.lost_at(k); lost != nullptr) {
    return bad_input(log.name() + ": found no step " + std::to_string(k) + ": " + to_string(*lost) +
                     " were lost before the log was recovered");
  }
  return {};
}

}  // namespace

Result<BodyMotion> body_asked(StepsAgain& steps, sim::BodyId body, std::uint64_t k) {
  if (Status ok = check_step(steps.log(), k); !ok.ok()) return ok.error();
  const Result<std::optional<BodyMotion>> motion = steps.after(k, body);
  if (!motion.ok()) return motion.error();
  if (motion->has_value()) return **motion;
  return bad_input(steps.log().name() + ": found no body " + std::to_string(body) + " after step " + std::to_string(k) +
                   why_missing(steps, body, k));
}

Result<std::string> field_changed_most(StepsAgain& steps, sim::BodyId body, std::uint64_t k) {
  if (k == steps.log().first_state() || !steps.log().holds(k - 1)) return field_name(kPosition);
  const Result<std::optional<BodyMotion>> before = steps.after(k - 1, body);
  if (!before.ok()) return before.error();
  const Result<std::optional<BodyMotion>> after = steps.after(k, body);
  if (!after.ok()) return after.error();
  if (!before->has_value() || !after->has_value()) return field_name(kPosition);
  BodyMotion change;
  for (const std::size_t first : {kPosition, kVelocity}) {
    change.set(first, (*after)->vector(first) - (*before)->vector(first));
    const std::size_t most = largest_of(change, first);
    if (change.of(most) != 0) return field_name(most);
  }
  return field_name(kPosition);
}

Result<double> value_asked(StepsAgain& steps, const BlameQuestion& question) {
  const std::size_t field = field_of(question.field);
  if (field == kNoField) {
    const std::vector<std::string> fields = blame_fields();
    const std::vector<std::string_view> names(fields.begin(), fields.end());
    const std::string_view nearest = nearest_word(question.field, names);
    return bad_input("--field: " + found_wanted(in_quotes(question.field), list_text(names)) +
                     (nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?"));
  }
  const Result<BodyMotion> motion = body_asked(steps, question.body, question.step);
  if (!motion.ok()) return motion.error();
  return motion->of(field);
}

}  // namespace tumble::replay
