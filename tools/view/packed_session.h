#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "replay/view/bound_scan.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// A session rounded and thinned, so that a page can carry it.
struct PackedSession {
  Json head;                 ///< head_json(), and "thin": what was left out
  std::string details;       ///< JSON by zlib: {"bodies", "timeline", "inputs", "contacts": {step: rows}}
  std::string frames;        ///< PackedStates::planes() by zlib; head["thin"]["steps"] has the steps
  std::uint64_t unread = 0;  ///< steps that the log should hold and that cannot be read
  std::string why_unread;    ///< of the first of them
};

struct PackOptions {
  std::uint64_t bytes_max = 0;              ///< of details and frames together; more is thinned until it fits
  std::vector<replay::ViewedBound> bounds;  ///< that the timeline judges
  std::vector<std::uint64_t> keep;          ///< steps that must be among the frames
};

/// Reads a log from end to end. Steps that cannot be read become gaps. Errors: kCannotFinish where `progress` stops.
Result<PackedSession> pack_session(replay::LogReader& log, const PackOptions& options,
                                   const replay::Progress& progress = {});

/// Bytes as a zlib stream, which browsers unpack as "deflate".
std::string deflated(const std::string& bytes);

}  // namespace tumble::tools
