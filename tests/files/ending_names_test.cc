// What a signal leaves that comes while outputs are made, in one thread or in several.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "src/files/output_file.h"
#include "src/files/part_file.h"
#include "tests/files/gate.h"
#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

constexpr int kTries = 200;

class EndingNamesOf : public TemporaryPlace, public testing::WithParamInterface<int> {
 protected:
  void make_and_drop(int thread) const {
    for (;;) static_cast<void>(OutputFile::create(path("output_" + std::to_string(thread))));
  }
  /// A process that makes outputs until a signal comes, and then ends as a command does.
  [[noreturn]] void work(Gate& is_working) const {
    struct sigaction action = {};
    action.sa_handler = [](int) {
      remove_parts();
      ::_exit(0);
    };
    ::sigaction(SIGTERM, &action, nullptr);
    is_working.open();
    std::vector<std::jthread> others;
    for (int k = 1; k < GetParam(); ++k) others.emplace_back([this, k] { make_and_drop(k); });
    make_and_drop(0);
    ::_exit(1);
  }
};

TEST_P(EndingNamesOf, LeaveNothingWhenASignalComes) {
  for (int k = 0; k < kTries; ++k) {
    Gate is_working;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) work(is_working);
    is_working.wait();
    std::this_thread::sleep_for(std::chrono::microseconds(1000 + 7 * k));
    ::kill(child, SIGTERM);
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    ASSERT_EQ(count(), 0U) << "try " << k << ": " << *std::filesystem::directory_iterator(folder_);
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, EndingNamesOf, testing::Values(1, 4));

}  // namespace
}  // namespace tumble::files
