#pragma once

#include "bench/thread_trials.h"

/// Measures threads beside copies of the program: the clock seconds of one thread, of two threads, and of two processes
/// with one thread each that run side by side, in turn. Two copies share caches, memory and the machine's clock like
/// two threads, but no work, so their gain is what two threads can reach on this machine.
namespace tumble::bench {

void print_times_head();

/// Prints a line of medians of five. Needs two processors without other work.
void print_times(const Trial& trial);

}  // namespace tumble::bench
