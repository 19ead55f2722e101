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

constexpr int kStepsMin = 20;

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
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

// So many processes of one thread, started together. The gain over `alone`, s, that they reach together.
double gain_side_by_side(const sim::WorldState& state, unsigned copies, int steps, double alone) {
  std::vector<std::array<int, 2>> pipes(copies);
  for (auto& ends : pipes) {
    if (pipe(ends.data()) != 0) fail("found no pipe for one more process");
    const pid_t child = fork();
    if (child < 0) fail("found no room for one more process");
    if (child == 0) {
      const double taken = seconds_of(state, 1, steps);
      _exit(write(ends[1], &taken, sizeof taken) == sizeof taken ? 0 : 1);
    }
    close(ends[1]);
  }
  double gain = 0;
  for (const auto& ends : pipes) {
    double taken = 0;
    if (read(ends[0], &taken, sizeof taken) != sizeof taken) fail("a copy of the program ended early");
    gain += alone / taken;
    close(ends[0]);
  }
  while (wait(nullptr) > 0) continue;
  return gain;
}

}  // namespace

void print_times_head() {
  std::printf("%-14s %7s %6s %10s %10s %8s %12s %8s\n", "scene", "threads", "steps", "1 thread", "so many", "gain",
              "copies gain", "part");
}

void print_times(const Trial& trial, const Timing& timing) {
  const sim::WorldState state = warm_state(trial);
  const double guess = seconds_of(state, 1, kStepsMin) / kStepsMin;
  const int steps = std::max(kStepsMin, static_cast<int>(timing.seconds / guess));
  for (const unsigned threads : timing.threads) {
    std::vector<double> one, more, copies;
    for (int run = 0; run < timing.runs; ++run) {
      one.push_back(seconds_of(state, 1, steps));
      more.push_back(seconds_of(state, threads, steps));
      copies.push_back(gain_side_by_side(state, threads, steps, one.back()));
    }
    const double gain = median(one) / median(more), reached = median(copies);
    std::printf("%-14s %7u %6d %8.3f s %8.3f s %8.2f %12.2f %8.2f\n", trial.name, threads, steps, median(one),
                median(more), gain, reached, gain / reached);
    std::fflush(stdout);
  }
}

}  // namespace tumble::bench
