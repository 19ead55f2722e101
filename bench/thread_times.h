#pragma once

#include <vector>

#include "bench/thread_trials.h"

/// Measures threads beside copies of the program: the clock seconds of one thread, of N threads, and of N processes
/// with one thread each that run side by side, in turn. Copies share caches, memory and the machine's clock like
/// threads, but no work, so their gain is what N threads can reach on this machine.
namespace tumble::bench {

struct Timing {
  std::vector<unsigned> threads = {2};
  int runs = 5;        ///< of which the median counts
  double seconds = 2;  ///< of a run: as many steps as one thread takes in that time
};

void print_times_head();

/// Prints a line of medians for each number of threads. Needs as many processors without other work.
void print_times(const Trial& trial, const Timing& timing);

}  // namespace tumble::bench
