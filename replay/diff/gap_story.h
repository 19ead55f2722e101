#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "replay/format/progress.h"
#include "replay/format/step_record.h"
#include "replay/log/log_reader.h"
#include "replay/measure/measure.h"
#include "src/base/ids.h"
#include "src/base/result.h"

/// What a first difference led to: how far two sessions moved apart, when, and in which way.
namespace tumble::replay {

/// One of two sessions, step by step: the record of step k, with states. Asked for in ascending order; good until the
/// next call.
struct StepFeed {
  std::string name;  ///< the path of a log; "this build"
  std::function<Result<const StepRecord*>(std::uint64_t k)> read;
};

/// Two sessions after one step.
struct GapRow {
  std::uint64_t step = 0;
  std::uint64_t bodies = 0;         ///< whose visible states differ in any bit, or that exist on one side only
  double gap = 0;                   ///< m: the largest distance of a body's centre from itself, over bodies of both
  std::optional<sim::BodyId> body;  ///< the one that is as far away; none at 0
};

/// Gaps that a story looks for, m.
inline constexpr std::array<double, 5> kGapMarks = {1e-12, 1e-9, 1e-6, 1e-3, 1e-2};

/// The first step after which the gap was larger than a mark.
struct GapMark {
  double above = 0;  ///< m
  std::uint64_t step = 0;
  sim::BodyId body = 0;
};

struct GapStory {
  std::vector<GapRow> rows;    ///< of every step looked at, the first difference's own first
  std::vector<GapMark> marks;  ///< those that were passed
  GapRow largest;              ///< the row with the largest gap
  // The first step in which more than numbers differ; none: they never do.
  std::optional<std::uint64_t> contacts_from;  ///< other numbers of pairs, contacts or sub-steps
  std::optional<std::uint64_t> freezing_from;  ///< a body frozen in one only
  std::optional<std::uint64_t> bodies_from;    ///< a body in one only
};

/// Compares the states of steps from … last. Errors: the feeds'; kDamaged where a log is broken, its states not being
/// those that its state hash tells of; a stop asked for by `progress` (kCannotFinish).
Result<GapStory> tell_story(const StepFeed& a, const StepFeed& b, std::uint64_t from, std::uint64_t last,
                            const Progress& progress = {});

/// Whether the states of steps from … last are the same where the hashes are, and only there; steps whose states a log
/// does not hold are passed over. Hashes alone call two logs identical; this looks. Errors: as tell_story().
Status confirm_states(LogReader& a, LogReader& b, std::uint64_t from, std::uint64_t last,
                      const Progress& progress = {});

/// A metric in both of two sessions.
struct MovedMetric {
  std::string name;
  std::string unit;
  std::optional<double> a;
  std::optional<double> b;
};

/// The metrics that differ, over all bodies. Metrics go through the C library's trigonometry, so values within a
/// billionth of each other count as the same.
std::vector<MovedMetric> moved_metrics(const Metrics& a, const Metrics& b);

}  // namespace tumble::replay
