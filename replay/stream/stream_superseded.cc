#include "replay/stream/stream_superseded.h"

#include <array>
#include <bit>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::array<const char*, 13> kFields = {
    "position.x", "position.y", "position.z", "orientation.w", "orientation.x", "orientation.y", "orientation.z",
    "velocity.x", "velocity.y", "velocity.z", "spin.x",        "spin.y",        "spin.z"};

bool same_bits(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }

std::string body_text(std::uint64_t id) { return "body " + std::to_string(id); }

/// The first field in which two states of a body differ, in the engine's axes; "" if none does.
std::string difference(const StreamState& x, const StreamState& y) {
  for (std::size_t k = 0; k < kFields.size(); ++k) {
    if (same_bits(x.numbers[k], y.numbers[k])) continue;
    return std::string(kFields[k]) + ": " + exact_bits(x.numbers[k]) + " before the rewind, " +
           exact_bits(y.numbers[k]) + " after it";
  }
  return x.asleep == y.asleep ? "" : std::string("asleep: ") + (x.asleep ? "yes" : "no") + " before the rewind";
}

}  // namespace

Superseded SupersededSteps::compare(const Whole& before, const Whole& after) const {
  Superseded found;
  found.same_inputs = after.same_before && before.step.input_bytes == after.step.input_bytes;
  if (before.step.input_bytes != after.step.input_bytes) {
    found.difference = "inputs";
    return found;
  }
  for (const auto& [id, state] : before.states) {
    const auto other = after.states.find(id);
    const std::string field =
        other == after.states.end() ? "absent after the rewind" : difference(state, other->second);
    if (field.empty()) continue;
    found.difference = body_text(id) + ": " + field;
    return found;
  }
  if (before.step.other_bytes != after.step.other_bytes) found.difference = "channels, contacts or phase hashes";
  return found;
}

void SupersededSteps::see(const StreamStep& step, bool taken_back, bool replaces) {
  for (const StreamInput& input : step.inputs) {
    if (const auto* removed = std::get_if<StreamRemove>(&input)) last_.erase(removed->id);
    if (const auto* body = std::get_if<StreamBody>(&input)) {
      last_[body->id] = {body->id, false, body->asleep, body->numbers};
    }
  }
  for (const StreamState& state : step.states) {
    if (!state.same) last_[state.id] = state;
  }
  const bool first_after_rewind = step.step != last_step_ + 1;
  last_step_ = step.step;
  if (!taken_back && !replaces) return;
  Whole whole{step, last_, true};
  if (replaces) {
    const auto earlier = found_.find(step.step - 1);
    whole.same_before = first_after_rewind || earlier == found_.end() || earlier->second.back().difference.empty();
    const auto before = taken_back_.find(step.step);
    if (before != taken_back_.end()) {
      found_[step.step].push_back(compare(before->second, whole));
      const Superseded& now = found_[step.step].back();
      if (first_difference_.empty() && now.same_inputs && !now.difference.empty()) {
        first_difference_ = "step " + std::to_string(step.step) + ": " + now.difference;
      }
    }
  }
  if (taken_back) taken_back_.insert_or_assign(step.step, std::move(whole));
}

const std::vector<Superseded>& SupersededSteps::of(std::uint64_t k) const {
  static const std::vector<Superseded> kNone;
  const auto found = found_.find(k);
  return found == found_.end() ? kNone : found->second;
}

}  // namespace tumble::replay
