#include "replay/view/step_gaps.h"

namespace tumble::replay {

std::vector<StepGap> step_gaps(const LogReader& log) {
  std::vector<StepGap> gaps;
  std::uint64_t next = log.first_state() + 1;
  for (const ChunkPlace& chunk : log.chunks()) {
    if (chunk.first_step > next) {
      const char* why = log.lost_at(next) != nullptr ? "lost before the log was recovered" : "in a damaged record";
      gaps.push_back({next, chunk.first_step - 1, why});
    }
    next = chunk.end_step();
  }
  return gaps;
}

}  // namespace tumble::replay
