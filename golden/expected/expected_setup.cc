#include "tumble/golden/expected_setup.h"

#include <algorithm>
#include <span>
#include <utility>

#include "replay/diff/input_difference.h"
#include "src/base/text.h"
#include "tumble/replay/field_value.h"
#include "tumble/replay/header_difference.h"

namespace tumble::golden {
namespace {

constexpr std::size_t kSetupInputsMax = 4000;  // of one golden
constexpr std::size_t kSetupStepsMax = 4000;   // with another dt, or an input
constexpr std::size_t kSetupNamed = 12;

std::string setup_words(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

std::string name_of_body(const std::vector<replay::BodyInfo>& bodies, sim::BodyId id) {
  const auto found = std::ranges::lower_bound(bodies, id, {}, &replay::BodyInfo::id);
  return found != bodies.end() && found->id == id ? found->name : "";
}

void add_names(const replay::Declared& expected, const replay::Declared& actual, std::vector<std::string>& found) {
  std::vector<sim::BodyId> ids;
  for (const auto* bodies : {&expected.bodies, &actual.bodies}) {
    for (const replay::BodyInfo& body : *bodies) ids.push_back(body.id);
  }
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const sim::BodyId id : ids) {
    const std::string before = name_of_body(expected.bodies, id), now = name_of_body(actual.bodies, id);
    if (before != now) {
      found.push_back("name of body " + std::to_string(id) + ": " + in_quotes(before) + " → " + in_quotes(now));
    }
  }
}

}  // namespace

replay::LogHeader header_of_setup(const replay::LogHeader& header) {
  replay::LogHeader kept = header;
  kept.scene_text.clear();
  kept.declared.start = {};
  kept.declared.channels.clear();  // ExpectedExtras has them
  kept.declared.shapes.clear();    // BodyShape has them
  for (replay::BodyInfo& body : kept.declared.bodies) body.shape = {};
  for (sim::BoxDef& box : kept.scene.boxes) {
    box.position = box.velocity = box.spin = {0, 0, 0};
    box.orientation = sim::Quat();
    box.frozen = false;
  }
  return kept;
}

SetupKeeper::SetupKeeper(const replay::LogHeader& header) {
  if (header.engine) setup_ = ExpectedSetup{header_of_setup(header), {}, 0};
}

void SetupKeeper::add(const replay::StepRecord& record) {
  if (!setup_ || record.step == 0 || setup_->steps_until + 1 != record.step) return;
  const bool says_more = record.dt != dt_ || !record.inputs.empty();
  if (says_more) {
    inputs_ += record.inputs.size();
    if (inputs_ > kSetupInputsMax || setup_->steps.size() >= kSetupStepsMax) return;
    setup_->steps.push_back({record.step, record.dt, record.inputs});
    dt_ = record.dt;
  }
  setup_->steps_until = record.step;
}

std::optional<ExpectedSetup> SetupKeeper::finish() { return std::move(setup_); }

std::vector<std::string> phase_differences(const std::vector<std::string>& expected,
                                           const std::vector<std::string>& actual) {
  if (expected == actual) return {};
  return {"phase hashes: " + setup_words(expected) + " → " + setup_words(actual)};
}

std::vector<std::string> setup_differences(const replay::LogHeader& expected, const replay::LogHeader& actual) {
  std::vector<std::string> found = phase_differences(expected.phases, actual.phases);
  const replay::LogHeader now = header_of_setup(actual);
  for (const replay::HeaderDifference& difference : replay::header_differences(expected, now)) {
    const bool is_precision = difference.key == "precision";
    if (is_precision || difference.acts) found.push_back(replay::describe(difference));
  }
  add_names(expected.declared, now.declared, found);
  if (found.size() <= kSetupNamed) return found;
  const std::size_t more = found.size() - kSetupNamed;
  found.resize(kSetupNamed);
  found.push_back("and " + std::to_string(more) + " more");
  return found;
}

std::string step_difference(const ExpectedSetup& expected, const replay::StepRecord& record,
                            const replay::BodyTable& names) {
  if (record.step == 0 || record.step > expected.steps_until) return "";
  const auto behind = std::ranges::upper_bound(expected.steps, record.step, {}, &StepSetup::step);
  if (behind == expected.steps.begin()) return "";
  const StepSetup& kept = *(behind - 1);
  const std::string before = "before step " + std::to_string(record.step) + ", ";
  if (kept.dt != record.dt) return before + "dt: " + number_text(kept.dt) + " → " + number_text(record.dt);
  const std::span<const sim::Command> wanted = kept.step == record.step ? kept.inputs : std::span<const sim::Command>();
  const auto difference = replay::first_difference(wanted, std::span<const sim::Command>(record.inputs));
  if (!difference) return "";
  const std::string of = difference->body ? " of " + names.text(*difference->body) : "";
  return before + difference->field + of + ": " + replay::to_string(difference->expected) + " → " +
         replay::to_string(difference->actual);
}

}  // namespace tumble::golden
