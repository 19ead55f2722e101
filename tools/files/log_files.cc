#include "tools/files/log_files.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <system_error>

#include "replay/log/hashes_only.h"
#include "src/base/text.h"
#include "src/files/output_file.h"
#include "tumble/replay/prelude.h"

namespace tumble::tools {

Result<replay::LogReader> open_log(const std::string& path) {
  Result<replay::LogReader> log = replay::LogReader::open(path);
  if (log.ok() && log->chunks().empty()) {
    return damaged(path + ": not one complete chunk to read; " + log->condition().summary(0));
  }
  return log;
}

Status wants_values(const replay::LogReader& log) {
  if (!replay::holds_hashes_only(log.header())) return {};
  return bad_input(log.name() +
                   ": holds hashes only, wanted values: it has no body to measure, draw or write; record without "
                   "hashes_only, or compare it by tumble diff");
}

Result<replay::LogReader> open_values(const std::string& path) {
  Result<replay::LogReader> log = open_log(path);
  if (!log.ok()) return log;
  if (Status ok = wants_values(*log); !ok.ok()) return ok.error();
  return log;
}

Status claim_output(files::OutputGuard& guard, const std::string& option, const std::string& path,
                    files::FileKind kind) {
  if (Status ok = guard.claim(option, path); !ok.ok()) return ok;
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(path, ignored);
  if (!is_file && std::filesystem::exists(path, ignored)) return {};  // a device, which is written to as it is
  if (Status ok = files::may_write(path, option + ": " + printable(path)); !ok.ok()) return ok;  // before the work
  if (!is_file) return {};
  std::array<char, replay::kMagicEnd> start = {};
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  const auto found = std::as_bytes(std::span(start)).first(static_cast<std::size_t>(file.gcount()));
  if (found.empty() || !replay::starts_like_log(found)) return files::replaces_its_kind(option, path, kind);
  return bad_input(option + ": " + printable(path) + " is a log or a golden; name another file, or remove it first");
}

Exit judge(const char* command, const replay::LogReader& log, Exit verdict) {
  const replay::LogCondition& condition = log.condition();
  if (condition.whole()) return verdict;
  std::cerr << "tumble " << command << ": " << log.name() << ": " << condition.summary(log.last_step())
            << (condition.sound() ? "" : "; 'tumble recover' saves the intact part") << '\n';
  return Exit::kDamaged;
}

}  // namespace tumble::tools
