// Child processes: programs that fail, hang or die, jobs that do, and the words for each end.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "src/process/child_pipe.h"
#include "src/process/run_child.h"
#include "src/process/split_words.h"
#include "tumble/process/job_pool.h"

namespace tumble::process {
namespace {

Program shell(const std::string& script) {
  Program program;
  program.words = {"sh", "-c", script};
  return program;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(SignalName, HasOneFormForEverySignal) {
  EXPECT_EQ(signal_name(SIGSEGV), "SIGSEGV");
  EXPECT_EQ(signal_name(SIGKILL), "SIGKILL");
  EXPECT_EQ(signal_name(1000), "signal 1000");
}

TEST(RunChild, NamesTheEnd) {
  EXPECT_TRUE(run_child(shell("exit 0"))->well());
  EXPECT_EQ(run_child(shell("exit 3"))->text(), "ended with status 3");
  EXPECT_EQ(run_child(shell("kill -SEGV $$"))->text(), "was ended by SIGSEGV");
  const Result<ChildEnd> reported = run_child(shell("sh -c 'kill -ABRT $$'; exit $?"));
  EXPECT_EQ(reported->text(), "ended with status 134");
  EXPECT_EQ(behind_shell(*reported).text(), "was ended by SIGABRT");
  EXPECT_EQ(behind_shell(*run_child(shell("exit 3"))).text(), "ended with status 3");
  EXPECT_EQ(behind_shell(*run_child(shell("exit 255"))).text(), "ended with status 255") << "no signal has that number";
}

TEST(RunChild, SaysThatAProgramIsMissing) {
  Program missing;
  missing.words = {"tumble_no_such_program"};
  EXPECT_NE(run_child(missing).error().message.find("cannot be started"), std::string::npos);
}

// A child that another thread has just forked may hold a program open that was written a moment ago.
TEST(RunChild, WaitsForAProgramThatIsBusy) {
  const std::string path = testing::TempDir() + "tumble_busy_program";
  std::ofstream file(path, std::ios::binary);
  file << "#!/bin/sh\nexit 7\n" << std::flush;
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  std::jthread later([&file] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    file.close();
  });
  Program busy;
  busy.words = {path};
  const Result<ChildEnd> end = run_child(busy);
  ASSERT_TRUE(end.ok()) << end.error().message;
  EXPECT_EQ(end->exit, 7);
  later.join();
  std::filesystem::remove(path);
}

TEST(RunChild, EndsAChildThatTakesTooLongAndAllThatItStarted) {
  const std::string file = testing::TempDir() + "tumble_late_child.txt";
  std::filesystem::remove(file);
  const Result<ChildEnd> late = run_child(shell("(sleep 2; echo late >" + file + ") & sleep 60"), 0.2);
  EXPECT_TRUE(late->late);
  EXPECT_FALSE(late->well());
  EXPECT_EQ(late->text(), "took too long");
  std::this_thread::sleep_for(std::chrono::seconds(3));
  EXPECT_FALSE(std::filesystem::exists(file)) << "the child's own child went on";
}

TEST(RunChild, StopsWhenItIsCancelled) {
  int asked = 0;
  const Result<ChildEnd> end = run_child(shell("sleep 60"), 0, [&] { return ++asked == 3; });
  EXPECT_TRUE(end->stopped);
  EXPECT_EQ(asked, 3);
}

TEST(RunChild, WritesBothOutputsToFilesThatAreEmptiedFirst) {
  Program program = shell("echo out; echo err >&2");
  program.out = program.err = testing::TempDir() + "tumble_child_output.txt";
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(run_child(program)->well());
    EXPECT_EQ(content_of(program.out), "out\nerr\n");
  }
}

// What a child started writes a file two seconds later, unless it ended with the process that was killed.
void expect_all_end_with(const std::string& file, const std::function<void(const Program&)>& run) {
  const std::string late = testing::TempDir() + file, begun = late + ".begun";
  std::filesystem::remove(late);
  std::filesystem::remove(begun);
  const Program engine = shell("(sleep 2; echo late >" + late + ") & echo >" + begun + "; sleep 60; true");
  const pid_t parent = ::fork();
  if (parent == 0) {
    run(engine);
    ::_exit(0);
  }
  for (int i = 0; i < 500 && !std::filesystem::exists(begun); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(std::filesystem::exists(begun));
  ::kill(parent, SIGKILL);
  EXPECT_EQ(wait_for(parent).signal, SIGKILL);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  EXPECT_FALSE(std::filesystem::exists(late)) << "the program went on";
}

#ifdef __linux__
TEST(RunChild, EndsWithAProcessThatIsKilled) {
  expect_all_end_with("tumble_orphan.txt", [](const Program& engine) { static_cast<void>(run_child(engine)); });
}

TEST(JobPool, EndsWithAProcessThatIsKilled) {
  expect_all_end_with("tumble_orphan_of_a_job.txt", [](const Program& engine) {
    const auto job = [&engine](std::size_t) {
      Program of_group = engine;
      of_group.own_group = false;
      return run_child(of_group)->text();
    };
    run_jobs(1, job, [](std::size_t, const JobResult&) {}, {});
  });
}
#endif

TEST(ChildPipe, FeedsAProgramAndSaysWhetherItEndedWell) {
  const std::string text = "fed\n";
  const std::string file = testing::TempDir() + "tumble_fed.txt";
  ChildPipe pipe;
  ASSERT_TRUE(pipe.start({"sh", "-c", "cat >" + file}, "Tests", "dash").ok());
  EXPECT_TRUE(pipe.write(std::as_bytes(std::span(text))));
  EXPECT_TRUE(pipe.finish());
  EXPECT_EQ(content_of(file), text);
  ASSERT_TRUE(pipe.start({"sh", "-c", "exit 1"}, "Tests", "dash").ok());
  EXPECT_FALSE(pipe.finish());
}

std::vector<JobResult> run(const std::vector<std::function<std::string()>>& jobs, const PoolOptions& options) {
  std::vector<JobResult> results(jobs.size());
  EXPECT_TRUE(run_jobs(
      jobs.size(), [&](std::size_t i) { return jobs[i](); },
      [&](std::size_t i, const JobResult& child) { results[i] = child; }, options));
  return results;
}

TEST(JobPool, GivesBackWhatEachJobReturns) {
  const std::string large(1 << 20, 'x');
  PoolOptions options;
  options.jobs = 3;
  const auto results = run({[] { return std::string("one"); }, [&] { return std::string(large); },
                            [] { return std::string(); }, [] { return std::string("\0\6two", 5); }},
                           options);
  EXPECT_EQ(results[0].output, "one");
  EXPECT_EQ(results[1].output, large);
  EXPECT_EQ(results[2].output, "");
  EXPECT_EQ(results[3].output, std::string("\0\6two", 5));
  for (const JobResult& result : results) EXPECT_EQ(result.failure, "");
}

TEST(JobPool, NamesWhatEndedAChildAndRunsTheOthers) {
  PoolOptions options;
  options.jobs = 2;
  options.timeout_s = 0.5;
  const auto results =
      run({[]() -> std::string {
             std::raise(SIGSEGV);
             return "";
           },
           []() -> std::string { throw std::runtime_error("no"); }, []() -> std::string { ::_exit(0); },
           []() -> std::string {
             std::this_thread::sleep_for(std::chrono::seconds(60));
             return "late";
           },
           [] { return std::string("fine"); }},
          options);
  EXPECT_NE(results[0].failure, "");
  EXPECT_NE(results[1].failure.find("status"), std::string::npos) << results[1].failure;
  EXPECT_NE(results[2].failure.find("before it was done"), std::string::npos) << "an exit without a result is no pass";
  EXPECT_NE(results[3].failure.find("longer than"), std::string::npos) << results[3].failure;
  EXPECT_EQ(results[4].failure, "");
  EXPECT_EQ(results[4].output, "fine");
}

TEST(SplitWords, KnowsQuotesAndBackslashes) {
  const auto words = [](const char* text) { return *split_words(text); };
  EXPECT_EQ(words("cmake  --build 'a folder'"), (std::vector<std::string>{"cmake", "--build", "a folder"}));
  EXPECT_EQ(words(R"(a\ b "c \" d" '' e'f'g)"), (std::vector<std::string>{"a b", "c \" d", "", "efg"}));
  EXPECT_EQ(words("$HOME;rm *"), (std::vector<std::string>{"$HOME;rm", "*"})) << "no shell sees it";
  EXPECT_FALSE(split_words("  ").ok());
  EXPECT_FALSE(split_words("a 'b").ok());
}

}  // namespace
}  // namespace tumble::process
