#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/step_record.h"
#include "tumble/sim/world_state.h"

/// Small random sessions as plain data, changed in one place, and the logs that tell of them.
namespace tumble::trial {

/// Random numbers that every machine repeats.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15 + 1) {}
  std::uint64_t word();
  std::uint64_t below(std::uint64_t end) { return word() % end; }
  double between(double low, double high);

 private:
  std::uint64_t state_;
};

struct RandomStep {
  double dt = 0;
  std::vector<sim::Command> inputs;
  std::vector<std::uint64_t> words;
  sim::StepCounters counters;
  sim::WorldState after;
};

struct RandomSession {
  sim::SceneDef scene;
  sim::WorldState start;
  std::vector<RandomStep> steps;
};

/// One to four boxes, up to three inputs, 3 to 20 steps of either method.
RandomSession make_session(Dice& dice);

/// Changes one value: a field of a state by one unit in the last place, by a sign or to no number; a counter, a phase
/// word, an input, dt, a hidden or built property of every state from a step on. Returns a name for messages.
std::string change(RandomSession& session, Dice& dice);

/// The bytes of a log of the session, chunks closed after every `chunk` steps.
std::vector<std::byte> log_of(const RandomSession& session, std::uint64_t chunk, const replay::StatesMode& states);

/// Whether all that steps show of two sessions is equal to the bit: dt, inputs, phase words, counters, states.
bool equal_bits(const RandomSession& a, const RandomSession& b);
/// Whether complete states are equal to the bit where both logs begin a chunk.
bool equal_hidden(const RandomSession& a, std::uint64_t chunk_a, const RandomSession& b, std::uint64_t chunk_b);

}  // namespace tumble::trial
