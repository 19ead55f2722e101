#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <random>
#include <thread>

#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"
#include "replay/recover/recover.h"
#include "tests/trial/trial.h"
#include "tumble/replay/log_reader.h"

namespace tumble::trial {
namespace {

using Clock = std::chrono::steady_clock;
using replay::LogReader;

constexpr std::size_t kFailuresKept = 10;

class Killer {
 public:
  Killer(std::string program, std::string scene, const std::string& folder, std::uint64_t seed)
      : program_(std::move(program)), scene_(std::move(scene)), log_(folder + "/killed.tumble"), random_(seed) {}

  /// A whole recording, for the time that it takes and to compare with.
  Status prepare(const std::string& reference) {
    const Clock::time_point begun = Clock::now();
    int status = 0;
    ::waitpid(start(reference), &status, 0);
    duration_ = Clock::now() - begun;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return cannot_finish(program_ + " record does not end with 0");
    Result<LogReader> log = LogReader::open(reference);
    if (!log.ok()) return log.error();
    reference_.emplace(*std::move(log));
    return {};
  }

  Counts run(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      std::filesystem::remove(log_);
      kill_one();
      check();
      ++counts_.trials;
    }
    std::filesystem::remove(log_);
    return std::move(counts_);
  }

 private:
  [[nodiscard]] pid_t start(const std::string& log) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    ::execl(program_.c_str(), program_.c_str(), "record", scene_.c_str(), "-o", log.c_str(), "--quiet", nullptr);
    ::_exit(127);
  }

  void kill_one() {
    const pid_t child = start(log_);
    std::this_thread::sleep_for(duration_ * std::uniform_real_distribution<double>(0, 1.1)(random_));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }

  void fail(std::uint64_t& count, const std::string& what) {
    ++count;
    if (counts_.failures.size() < kFailuresKept) counts_.failures.push_back(what);
  }

  /// What is there is sound up to its torn end, is the session up to there, and can be recovered with every step.
  void check() {
    Result<std::unique_ptr<replay::ByteSource>> source = replay::open_file_source(log_);
    if (!source.ok()) return;  // killed before it began
    Result<LogReader> log = LogReader::open(log_);
    if (!log.ok()) {
      if (log.error().kind != ErrorKind::kDamaged) fail(counts_.undetected, log.error().message);
      return;
    }
    const replay::VerifyReport report = verify(*log);
    if (!report.condition.damages.empty()) fail(counts_.undetected, report.condition.damages.front().message);
    if (!report.condition.finished && !report.condition.torn) fail(counts_.undetected, "neither finished nor torn");
    if (log->chunks().empty()) return;
    const Result<Hash128> found = log->chain_at(log->last_step()), wanted = reference_->chain_at(log->last_step());
    if (!found.ok() || !wanted.ok() || *found != *wanted) fail(counts_.lost, "the steps are not the session's");
    recover(**source, log->step_count());
  }

  void recover(const replay::ByteSource& source, std::uint64_t steps) {
    ++counts_.recoveries;
    const auto written = std::make_shared<std::vector<std::byte>>();
    const Result<replay::RecoverReport> report =
        recover_log(source, std::make_unique<replay::MemoryByteSink>(written, "recovered.tumble"));
    if (!report.ok() || report->steps != steps) {
      fail(counts_.lost, report.ok() ? "recovery lost steps" : report.error().message);
    }
  }

  std::string program_;
  std::string scene_;
  std::string log_;
  std::mt19937_64 random_;
  std::chrono::duration<double> duration_{};
  std::optional<LogReader> reference_;
  Counts counts_;
};

}  // namespace

Result<Counts> kill_recorders(const std::string& program, const std::string& scene, std::uint64_t count,
                              std::uint64_t seed, const std::string& folder) {
  Killer killer(program, scene, folder, seed);
  if (Status ok = killer.prepare(folder + "/reference.tumble"); !ok.ok()) return ok.error();
  return killer.run(count);
}

}  // namespace tumble::trial
