#include "replay/diff/divergence_growth.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "replay/log/log_facts.h"
#include "replay/measure/metric_list.h"
#include "replay/session/state_source.h"
#include "src/base/check.h"
#include "tumble/replay/player.h"

namespace tumble::replay {
namespace {

SessionSteps steps_of(LogReader& log) {
  return {log.name(), [source = std::make_shared<StateSource>(log)](std::uint64_t k) { return source->read(k); }};
}

/// This build's replay of a log: the log's own states before step `from`, simulated ones from there on.
SessionSteps steps_of_replay(LogReader& log, std::uint64_t from) {
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

struct MeasuredSession {
  const LogHeader& header;
  SessionSteps steps;
};

/// Metrics over both sessions from their first state on, each up to the last common step: over less, the metrics of the
/// longer one would differ by its length alone.
Result<Metrics> measure(const MeasuredSession& of, std::uint64_t first, std::uint64_t last, const Progress& progress) {
  Measurer measurer(of.header);
  const StepRecord* record = nullptr;
  for (std::uint64_t k = first; k <= last; ++k) {
    const Result<const StepRecord*> read = of.steps.read(k);
    if (!read.ok()) return read.error();
    record = *read;
    measurer.add(*record);
    if (progress && !progress(k - first, last - first)) return cannot_finish("interrupted");
  }
  return measurer.finish(record->states);
}

/// Adds the metrics that differ, or the reason why there are none.
void compare_metrics(const MeasuredSession& a, const MeasuredSession& b, std::uint64_t first, std::uint64_t last,
                     const Progress& progress, DivergenceGrowth& growth) {
  const Result<Metrics> of_a = measure(a, first, last, progress);
  const Result<Metrics> of_b = of_a.ok() ? measure(b, first, last, progress) : of_a;
  if (of_b.ok()) {
    growth.metrics = moved_metrics(*of_a, *of_b);
  } else {
    growth.not_measured = of_b.error().message;
  }
}

}  // namespace

Result<DivergenceGrowth> growth_between(LogReader& a, LogReader& b, std::uint64_t first_difference,
                                        const Progress& progress, std::uint64_t until) {
  const std::uint64_t last = std::min({a.last_step(), b.last_step(), until});
  const ChannelMatch channels = match_channels(a.header(), b.header(), {}, are_two_engines(a.header(), b.header()));
  Result<Separation> separation =
      measure_separation(steps_of(a), steps_of(b), first_difference, last, progress, &channels);
  if (!separation.ok()) return separation.error();
  if (separation->contacts_from && separation->contacts_by_value &&
      tells_contacts(a, last) != tells_contacts(b, last)) {
    separation->compares_contacts = false;  // one recorder told none
    separation->contacts_from.reset();
    separation->first_contact.reset();
  }
  DivergenceGrowth growth{*std::move(separation), {}, {}};
  if (a.first_state() != b.first_state()) {
    growth.not_measured = "the two begin with different steps";
    return growth;
  }
  compare_metrics({a.header(), steps_of(a)}, {b.header(), steps_of(b)}, a.first_state(), last, progress, growth);
  return growth;
}

Result<DivergenceGrowth> growth_in_replay(LogReader& log, LogReader& again, std::uint64_t first_difference,
                                          const Progress& progress) {
  SIM_CHECK(first_difference > log.first_state(), first_difference, log.first_state());
  const std::uint64_t last = log.last_step();
  Result<Separation> separation =
      measure_separation(steps_of(log), steps_of_replay(again, first_difference), first_difference, last, progress);
  if (!separation.ok()) return separation.error();
  DivergenceGrowth growth{*std::move(separation), {}, {}};
  compare_metrics({log.header(), steps_of(log)}, {log.header(), steps_of_replay(again, first_difference)},
                  log.first_state(), last, progress, growth);
  return growth;
}

std::vector<MovedMetric> moved_metrics(const Metrics& a, const Metrics& b) {
  std::vector<MovedMetric> moved;
  for (const MetricRow& row : metric_list()) {
    const std::optional<double> in_a = row.value(a), in_b = row.value(b);
    if (!same_value(in_a, in_b)) moved.push_back({row.name, row.unit, in_a, in_b});
  }
  for (const ChannelMetrics& of_a : a.channels) {
    const auto of_b = std::ranges::find(b.channels, of_a.channel.name, [](const auto& m) { return m.channel.name; });
    if (of_b == b.channels.end()) continue;
    for (std::uint8_t k = 0; k <= static_cast<std::uint8_t>(ChannelStatistic::kChanges); ++k) {
      const auto statistic = static_cast<ChannelStatistic>(k);
      const std::optional<double> in_a = of_a.value(statistic), in_b = of_b->value(statistic);
      if (same_value(in_a, in_b)) continue;
      const std::string name = "channel." + of_a.channel.name + '.' + name_of(statistic);
      moved.push_back({name, statistic == ChannelStatistic::kChanges ? "" : of_a.channel.unit, in_a, in_b});
    }
  }
  return moved;
}

}  // namespace tumble::replay
