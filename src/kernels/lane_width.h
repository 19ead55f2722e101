#pragma once

#include <cstdint>

namespace tumble::sim {

/// How many lanes an instruction takes. All give the same bits: lanes never mix. kWidest: as many as this machine can.
enum class LaneWidth : std::uint8_t { kWidest, kOne, kTwo, kFour, kEight };

/// "widest", "one", "two", "four", "eight".
const char* name_of(LaneWidth width);

/// Whether this machine has the instructions of a width.
bool machine_has_lanes(LaneWidth width);

}  // namespace tumble::sim
