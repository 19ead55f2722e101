#pragma once

#include <cstdint>

namespace tumble::sim {

/// The number of lanes of an instruction. Every width gives the same bits, since lanes never mix. kWidest: the widest
/// that build and machine run.
enum class LaneWidth : std::uint8_t { kWidest, kOne, kTwo, kFour, kEight };

/// "widest", "one", "two", "four", "eight".
const char* name_of(LaneWidth width);

/// Whether this machine has the instructions of a width.
bool machine_has_lanes(LaneWidth width);

}  // namespace tumble::sim
