// Estimates a step with 1 to 32 threads on a machine that has fewer processors. The step is cut into the parts that so
// many threads would get; they run one after the other, and each is timed. A round of parts then costs its longest part
// and the time to wake the others or to meet them; all else is serial. The model leaves out that a processor fetches
// data that another has written, that processors share caches and memory, and that they slow down when all are busy.
// The estimate is therefore an upper bound for this way of splitting. With --measure the program measures instead
// (thread_times.h).
// Usage: thread_model [--measure [--threads N,N,...] [--runs N] [--seconds S]] [SCENE...]   all scenes without.
// docs/performance.md, Threads, explains the figures.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/thread_times.h"
#include "bench/thread_trials.h"
#include "bench/timed_parts.h"
#include "tumble/sim/step.h"
#include "tumble/threads/worker_threads.h"

namespace {

using namespace tumble;         // NOLINT(google-build-using-namespace): a program
using namespace tumble::bench;  // NOLINT(google-build-using-namespace)

constexpr int kSteps = 10;   // that are timed
constexpr int kRepeats = 3;  // of which the quickest counts
constexpr unsigned kThreads[] = {1, 2, 4, 8, 16, 32};
constexpr double kThreadsMost = 256;          // measured
constexpr unsigned kShown = 8;                // threads of the table of phases
constexpr std::size_t kDivisors[] = {1, 16};  // of the least sizes that are split, which suit two processors

/// One phase of one substep: the time that is not split, and the parts of its rounds, s.
struct Visit {
  std::size_t phase = 0;
  double serial = 0;
  std::vector<TimedParts::Round> rounds;

  /// Merges another run: the longer time was disturbed.
  void take_least(const Visit& other) {
    serial = std::min(serial, other.serial);
    for (std::size_t k = 0; k < rounds.size(); ++k) {
      rounds[k].path = std::min(rounds[k].path, other.rounds[k].path);
      for (std::size_t part = 0; part < rounds[k].parts.size(); ++part) {
        rounds[k].parts[part] = std::min(rounds[k].parts[part], other.rounds[k].parts[part]);
      }
    }
  }
};

class Visits : public sim::Observer {
 public:
  explicit Visits(TimedParts& parts) : parts_(parts), before_(Clock::now()) {}
  void phase_done(std::uint32_t /*substep*/, std::size_t phase, const sim::World& /*world*/) override {
    const double all = seconds_between(before_, Clock::now());
    TimedParts::Rounds rounds = parts_.take();
    all_.push_back({phase, all - rounds.inside_s, std::move(rounds.all)});
    before_ = Clock::now();
  }
  std::vector<Visit>& all() { return all_; }

 private:
  TimedParts& parts_;
  Clock::time_point before_;
  std::vector<Visit> all_;
};

/// Times of a phase, or of the whole step, over all timed steps, s.
struct Share {
  double serial = 0;
  double sum = 0, longest = 0, mean = 0;  ///< of all parts; until each round is done; of the mean part of each
  double rounds = 0;

  void add(const Visit& visit) {
    serial += visit.serial;
    for (const TimedParts::Round& round : visit.rounds) {
      const double all = std::accumulate(round.parts.begin(), round.parts.end(), 0.0);
      sum += all;
      mean += all / static_cast<double>(round.parts.size());
      longest += round.path;
      ++rounds;
    }
  }
  [[nodiscard]] double alone() const { return serial + sum; }
  /// If the parts of a round ran at the same time.
  [[nodiscard]] double together(double round_cost) const { return serial + longest + rounds * round_cost; }
};

Share share_of(const std::vector<Visit>& visits, std::optional<std::size_t> phase = std::nullopt) {
  Share share;
  for (const Visit& visit : visits) {
    if (!phase || visit.phase == *phase) share.add(visit);
  }
  return share;
}

std::vector<Visit> time_parts(const sim::WorldState& state, unsigned threads, std::size_t divisor, double post_s) {
  std::vector<Visit> least;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    sim::World world = world_from(state);
    TimedParts parts(threads, divisor, post_s);
    world.use(&parts);
    make_step(world);  // not timed: memory is asked for here
    parts.take();
    Visits visits(parts);
    for (int k = 0; k < kSteps; ++k) make_step(world, &visits);
    if (repeat == 0) least = visits.all();
    for (std::size_t k = 0; k < least.size(); ++k) least[k].take_least(visits.all()[k]);
  }
  return least;
}

/// The cost of an empty round of two threads here, s: the least of many batches, as other programs use the machine.
double cost_of_round() {
  WorkerThreads two(2);
  double least = INFINITY;
  for (int batch = 0; batch < 200; ++batch) {
    const Clock::time_point begin = Clock::now();
    for (int k = 0; k < 100; ++k) for_parts(&two, 2, [](unsigned /*part*/) {});
    least = std::min(least, seconds_between(begin, Clock::now()) / 100);
  }
  return least;
}

void print_phases(const std::vector<Visit>& visits, double round_cost) {
  std::printf("  %-22s %8s %9s %8s %8s   (%u threads)\n", "phase", "1, ms", "so, ms", "split", "rounds", kShown);
  const auto phases = sim::phase_table(sim::Method::kLayered).phases;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    const Share share = share_of(visits, k);
    std::printf("  %-22s %8.3f %9.3f %7.0f%% %8.1f\n", phases[k].name, share.alone() * 1e3 / kSteps,
                share.together(round_cost) * 1e3 / kSteps, 100 * share.sum / share.alone(), share.rounds / kSteps);
  }
}

void model(const Trial& trial, double pair_cost) {
  const sim::WorldState state = warm_state(trial);
  std::printf("\n%s: %zu bodies, %zu pairs\n", trial.name, state.bodies.size(), state.pairs.size());
  for (const std::size_t divisor : kDivisors) {
    std::printf(" parts of at least 1/%zu of the sizes that pay on two processors\n", divisor);
    std::printf("  %7s %9s %9s %9s %12s %8s %9s %8s\n", "threads", "alone, ms", "so, ms", "speed-up", "rounds free",
                "serial", "max/mean", "rounds");
    std::vector<Visit> shown;
    for (const unsigned threads : kThreads) {
      // Counters pass from processor to processor, so each thread more waits for its turn.
      const double round_cost = pair_cost * (threads - 1);
      const std::vector<Visit> visits = time_parts(state, threads, divisor, pair_cost / 2);
      const Share whole = share_of(visits);
      const double alone = whole.alone(), together = whole.together(round_cost);
      std::printf("  %7u %9.3f %9.3f %9.2f %12.2f %7.0f%% %9.2f %8.1f\n", threads, alone * 1e3 / kSteps,
                  together * 1e3 / kSteps, alone / together, alone / whole.together(0), 100 * whole.serial / alone,
                  whole.rounds > 0 ? whole.longest / whole.mean : 1.0, whole.rounds / kSteps);
      if (threads == kShown) shown = visits;
    }
    print_phases(shown, pair_cost * (kShown - 1));
  }
}

// Takes `name` and the word behind it from the words; null: `name` is not there.
std::optional<std::string> take_option(std::vector<std::string>& words, const std::string& name) {
  const auto at = std::ranges::find(words, name);
  if (at == words.end()) return std::nullopt;
  if (at + 1 == words.end()) fail(name + ": found nothing behind it, wanted a value");
  std::string value = *(at + 1);
  words.erase(at, at + 2);
  return value;
}

double number_of(const std::string& text, const std::string& name, double most) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != 0 || !(x > 0) || x > most) {
    fail(name + ": found \"" + text + "\", wanted a number above 0, at most " + std::to_string(most));
  }
  return x;
}

Timing take_timing(std::vector<std::string>& words) {
  Timing timing;
  if (const auto runs = take_option(words, "--runs")) timing.runs = static_cast<int>(number_of(*runs, "--runs", 1000));
  if (const auto seconds = take_option(words, "--seconds")) timing.seconds = number_of(*seconds, "--seconds", 1000);
  if (const auto threads = take_option(words, "--threads")) {
    timing.threads.clear();
    for (std::size_t at = 0; at <= threads->size();) {
      const std::size_t comma = std::min(threads->find(',', at), threads->size());
      timing.threads.push_back(
          static_cast<unsigned>(number_of(threads->substr(at, comma - at), "--threads", kThreadsMost)));
      at = comma + 1;
    }
  }
  return timing;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const bool measures = std::erase(wanted, "--measure") > 0;
  const Timing timing = take_timing(wanted);
  for (const std::string& name : wanted) {
    if (std::ranges::none_of(trials(), [&](const Trial& trial) { return trial.name == name; })) {
      fail("found \"" + name + "\", wanted " + trial_names());
    }
  }
  const double pair_cost = cost_of_round();
  std::printf("a round of two threads with nothing in it: %.2f us; of N: N - 1 times that\n", pair_cost * 1e6);
  if (measures) print_times_head();
  for (const Trial& trial : trials()) {
    if (!wanted.empty() && std::ranges::find(wanted, trial.name) == wanted.end()) continue;
    if (measures) {
      print_times(trial, timing);
    } else {
      model(trial, pair_cost);
    }
  }
  return 0;
}
