#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/hunt/judge/relation.h"
#include "src/kernels/lane_width.h"
#include "tumble/sim/transform.h"

/// Sessions that must agree to the bit.
namespace tumble::hunt {

/// The first value in which two sets of bodies part.
struct ValueDifference {
  sim::BodyId body = 0;  ///< of the original
  std::string field;     ///< "position x"; "body" where one side lacks it
  double a = 0, b = 0;   ///< wanted, the original's under the transform; found
};

/// Whether 0.0 and −0.0 are one value, and a quaternion and its opposite one orientation: of engines that choose
/// neither sign.
enum class Signs : std::uint8_t { kApart, kAlike };

/// Whether the second set may have bodies that the first one lacks.
enum class Others : std::uint8_t { kNone, kAllowed };

/// The shift and the order of ids of the relations `shift` and `ids`.
inline const sim::Vec3 kShift = {1024, -512.5, 0};
inline constexpr std::uint64_t kPermutation = 0xfeed;

/// Compares every bit of place, motion, freezing and time at low energy of each body with the original's under the
/// transform. None: all agree.
std::optional<ValueDifference> first_difference(const sim::Bodies& original, const sim::Bodies& image,
                                                const sim::Transform& transform, const sim::IdMap& ids,
                                                Signs signs = Signs::kApart, Others others = Others::kNone);

/// The phase of the first hash in which two steps of one method part; empty where all agree.
std::string first_phase(sim::Method method, const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b);

/// The difference as a judgement of the step that leads to state `step`.
Judgement parted(std::uint64_t step, const ValueDifference& difference);

/// A step as it was taken: the state after it, its phases and its counts.
struct StepTaken {
  const sim::WorldState& state;
  const std::vector<std::uint64_t>& words;  ///< sim::PhaseHashes
  const sim::StepCounters& counters;
};

/// Whether two takings of the step that leads to state `step` agree to the bit, hidden state included. Broken: the
/// first body, and the first phase, that differ.
Judgement compare_steps(sim::Method method, std::uint64_t step, const StepTaken& wanted, const StepTaken& found);

/// A session of the image of the trace's scene under a transform.
Judgement judge_image(const Trace& trace, const sim::Transform& transform);

/// The session run again with lanes of a width; phases, counters and states must agree.
Judgement judge_again(const Trace& trace, sim::LaneWidth lanes);

/// A few steps, evenly spread, taken by several threads that split everything. Not all of them: threads of a loaded
/// machine wait for one another at every meeting, of which a step has hundreds.
Judgement judge_threads(const Trace& trace);

/// Each step taken from a snapshot of the state before.
Judgement judge_resumed(const Trace& trace);

/// Bodies added one by one in another order before the first step.
Judgement judge_inserted(const Trace& trace);

/// The scene with others far away (with_neighbours), of which no bit may show.
Judgement judge_elsewhere(const Trace& trace);

/// Recorded into a log, whose states and hashes are compared; then replayed from its first and its middle state.
Judgement judge_replayed(const Trace& trace);

}  // namespace tumble::hunt
