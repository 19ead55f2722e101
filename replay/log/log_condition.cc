#include "tumble/replay/log_condition.h"

namespace tumble::replay {

std::string LogCondition::summary(std::uint64_t last_step) const {
  if (whole()) return "whole";
  std::string text;
  if (torn) {
    text = "complete up to byte " + std::to_string(torn_offset) + ", which is step " + std::to_string(last_step);
    text = writer.empty() ? "torn: " + text + "; the rest was not written or was cut off"
                          : "is being written by " + writer + ": " + text + ", so far";
  }
  if (!damages.empty()) {
    if (!text.empty()) text += "; ";
    text += std::to_string(damages.size()) + (damages.size() == 1 ? " damage: " : " damages, the first: ") +
            damages.front().message;
  }
  if (!missing.empty()) {
    if (!text.empty()) text += "; ";
    text += "recovered from a damaged log: " + to_string(missing.front()) +
            (missing.size() == 1 ? "" : " and " + std::to_string(missing.size() - 1) + " more runs of steps") +
            " were lost";
  }
  return text;
}

}  // namespace tumble::replay
