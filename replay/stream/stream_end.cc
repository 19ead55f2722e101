#include "replay/stream/stream_end.h"

namespace tumble::replay {
namespace {

std::string last_step(const StreamReader& stream) { return std::to_string(stream.steps().back().step); }

bool was_stopped(const StreamCondition& condition) {
  return condition.torn || (!condition.finished && !condition.damage);
}

}  // namespace

std::string cut_short(const StreamReader& stream) {
  const StreamCondition& condition = stream.condition();
  const bool was_closed = condition.finished && !condition.dumped;
  if (!condition.refusal.empty() && !was_closed)
    return "the recorder gave up after step " + last_step(stream) + ": " + condition.refusal;
  if (was_stopped(condition)) return "the recorder was stopped after step " + last_step(stream);
  return condition.damage ? "the recorder's stream is damaged behind step " + last_step(stream) : "";
}

std::vector<std::string> end_warnings(const StreamReader& stream) {
  const StreamCondition& condition = stream.condition();
  std::vector<std::string> all;
  if (condition.damage) all.push_back(*condition.damage + "; the log ends with step " + last_step(stream));
  const std::string cut = cut_short(stream);
  if (condition.refusal.empty()) {
    if (was_stopped(condition)) all.push_back(stream.name() + ": ends without its last frame: " + cut);
  } else {
    all.push_back(stream.name() + ": " +
                  (cut.empty() ? "the recorder refused its last call: " + condition.refusal : cut));
  }
  return all;
}

}  // namespace tumble::replay
