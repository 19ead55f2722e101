#include "tools/files/log_files.h"

#include <iostream>

namespace tumble::tools {

Result<replay::LogReader> open_log(const std::string& path) {
  Result<replay::LogReader> log = replay::LogReader::open(path);
  if (log.ok() && log->chunks().empty()) {
    return damaged(path + ": not one complete chunk to read; " + log->condition().summary(0));
  }
  return log;
}

Exit judge(const char* command, const replay::LogReader& log, Exit verdict) {
  const replay::LogCondition& condition = log.condition();
  if (condition.whole()) return verdict;
  std::cerr << "tumble " << command << ": " << log.name() << ": " << condition.summary(log.last_step()) << '\n';
  return Exit::kDamaged;
}

}  // namespace tumble::tools
