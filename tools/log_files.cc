#include "tools/log_files.h"

#include <iostream>

namespace tumble::tools {

Exit judge(const char* command, const replay::LogReader& log, Exit verdict) {
  const replay::LogCondition& condition = log.condition();
  if (condition.whole()) return verdict;
  std::cerr << "tumble " << command << ": " << log.name() << ": " << condition.summary(log.step_count()) << '\n';
  return Exit::kDamaged;
}

}  // namespace tumble::tools
