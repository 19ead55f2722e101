#include "replay/diff/aftermath.h"

#include <algorithm>
#include <memory>

#include "replay/session/player.h"
#include "replay/session/state_source.h"

namespace tumble::replay {
namespace {

StepFeed feed_of(LogReader& log) {
  return {log.name(), [source = std::make_shared<StateSource>(log)](std::uint64_t k) { return source->read(k); }};
}

/// What this build makes of a log from the state before step `from` on, and the log's own states before that.
StepFeed feed_of_replay(LogReader& log, std::uint64_t from) {
  auto source = std::make_shared<StateSource>(log);
  auto player = std::make_shared<std::optional<Player>>();
  return {"this build", [&log, source, player, from](std::uint64_t k) -> Result<const StepRecord*> {
            if (k < from) return source->read(k);
            if (!*player) {
              Result<Player> at = Player::at(log, from - 1);
              if (!at.ok()) return at.error();
              player->emplace(*std::move(at));
            }
            return (*player)->step();
          }};
}

Result<Metrics> measure(const LogHeader& header, const StepFeed& feed, std::uint64_t first, std::uint64_t last) {
  Measurer measurer(header);
  const StepRecord* record = nullptr;
  for (std::uint64_t k = first; k <= last; ++k) {
    const Result<const StepRecord*> read = feed.read(k);
    if (!read.ok()) return read.error();
    record = *read;
    measurer.add(*record);
  }
  return measurer.finish(record->states);
}

/// Adds the metrics, or why there are none.
void compare_metrics(const LogHeader& a, const StepFeed& feed_a, const LogHeader& b, const StepFeed& feed_b,
                     std::uint64_t first, std::uint64_t last, Aftermath& aftermath) {
  const Result<Metrics> in_a = measure(a, feed_a, first, last);
  const Result<Metrics> in_b = in_a.ok() ? measure(b, feed_b, first, last) : in_a;
  if (in_b.ok()) {
    aftermath.metrics = moved_metrics(*in_a, *in_b);
  } else {
    aftermath.not_measured = in_b.error().message;
  }
}

}  // namespace

Result<Aftermath> aftermath_of(LogReader& a, LogReader& b, std::uint64_t first_difference, const Progress& progress) {
  const std::uint64_t last = std::min(a.last_step(), b.last_step());
  Result<GapStory> gap = tell_story(feed_of(a), feed_of(b), first_difference, last, progress);
  if (!gap.ok()) return gap.error();
  Aftermath aftermath{*std::move(gap), {}, {}};
  if (a.first_state() != b.first_state()) {
    aftermath.not_measured = "the two begin with different steps";
    return aftermath;
  }
  compare_metrics(a.header(), feed_of(a), b.header(), feed_of(b), a.first_state(), last, aftermath);
  return aftermath;
}

Result<Aftermath> aftermath_of_replay(LogReader& log, LogReader& again, std::uint64_t first_difference,
                                      const Progress& progress) {
  const std::uint64_t last = log.last_step();
  Result<GapStory> gap =
      tell_story(feed_of(log), feed_of_replay(again, first_difference), first_difference, last, progress);
  if (!gap.ok()) return gap.error();
  Aftermath aftermath{*std::move(gap), {}, {}};
  compare_metrics(log.header(), feed_of(log), log.header(), feed_of_replay(again, first_difference), log.first_state(),
                  last, aftermath);
  return aftermath;
}

}  // namespace tumble::replay
