#include "bench/thread_times.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "tumble/threads/worker_threads.h"

namespace tumble::bench {
namespace {

constexpr int kRuns = 5;      // of which the median counts
constexpr double kLeast = 2;  // s, of a run: as many steps as one thread takes in that time
constexpr int kStepsMin = 20;

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

double seconds_of(const sim::WorldState& state, unsigned threads, int steps) {
  sim::World world = world_from(state);
  const std::unique_ptr<WorkerThreads> workers = worker_threads(threads);
  world.use(workers.get());
  make_step(world);  // not timed: memory is asked for here
  const Clock::time_point begin = Clock::now();
  for (int k = 0; k < steps; ++k) make_step(world);
  return seconds_between(begin, Clock::now());
}

// Two processes of one thread, started together. Seconds of each.
std::array<double, 2> seconds_side_by_side(const sim::WorldState& state, int steps) {
  std::array<double, 2> seconds{};
  std::array<std::array<int, 2>, 2> pipes{};
  for (auto& ends : pipes) {
    if (pipe(ends.data()) != 0) fail("found no pipe for a second process");
    const pid_t child = fork();
    if (child < 0) fail("found no room for a second process");
    if (child == 0) {
      const double taken = seconds_of(state, 1, steps);
      _exit(write(ends[1], &taken, sizeof taken) == sizeof taken ? 0 : 1);
    }
    close(ends[1]);
  }
  for (std::size_t k = 0; k < pipes.size(); ++k) {
    if (read(pipes[k][0], &seconds[k], sizeof seconds[k]) != sizeof seconds[k]) fail("a second process ended early");
    close(pipes[k][0]);
  }
  while (wait(nullptr) > 0) continue;
  return seconds;
}

}  // namespace

void print_times_head() {
  std::printf("%-14s %6s %10s %10s %8s %12s %8s\n", "scene", "steps", "1 thread", "2 threads", "gain", "2 copies gain",
              "part");
}

void print_times(const Trial& trial) {
  const sim::WorldState state = warm_state(trial);
  const int steps = std::max(kStepsMin, static_cast<int>(kLeast / (seconds_of(state, 1, kStepsMin) / kStepsMin)));
  std::vector<double> one, two, copies;
  for (int run = 0; run < kRuns; ++run) {
    one.push_back(seconds_of(state, 1, steps));
    two.push_back(seconds_of(state, 2, steps));
    const std::array<double, 2> both = seconds_side_by_side(state, steps);
    copies.push_back(one.back() / both[0] + one.back() / both[1]);
  }
  const double gain = median(one) / median(two), reached = median(copies);
  std::printf("%-14s %6d %8.3f s %8.3f s %8.2f %12.2f %8.2f\n", trial.name, steps, median(one), median(two), gain,
              reached, gain / reached);
  std::fflush(stdout);
}

}  // namespace tumble::bench
