#include "replay/stream/stream_end.h"

namespace tumble::replay {

bool was_stopped(const StreamCondition& condition) {
  return condition.torn || (!condition.finished && !condition.damage);
}

std::string cut_short(const StreamReader& stream) {
  const std::string last = std::to_string(stream.steps().back().step);
  if (was_stopped(stream.condition())) return "the recorder was stopped after step " + last;
  return stream.condition().damage ? "the recorder's stream is damaged behind step " + last : "";
}

}  // namespace tumble::replay
