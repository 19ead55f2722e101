#include "replay/measure/measure_log.h"

#include "replay/log/told_values.h"
#include "replay/session/state_source.h"

namespace tumble::replay {

Result<Metrics> measure_log(LogReader& log, const MeasureOptions& options,
                            const std::function<void(const SeriesRow&)>& each_row, const Progress& progress) {
  StateSource source(log);
  Measurer measurer(log.header(), options);
  ToldWatch told(log.header());
  const std::uint64_t first = log.first_state();
  const std::vector<MissingSteps>& missing = log.header().missing();
  const std::uint64_t last = missing.empty() ? log.last_step() : missing.front().first_step - 1;
  if (options.from_step > last && !missing.empty()) {
    return bad_input(log.name() + ": measures cannot begin after step " + std::to_string(last) + ": " +
                     to_string(missing.front()) + " were lost before the log was recovered");
  }
  Result<const StepRecord*> record = source.read(first);
  for (std::uint64_t k = first; k <= last; ++k) {
    const bool needs_states = k == first || k >= options.from_step;
    record = needs_states ? source.read(k) : log.read_hashes(k);
    if (!record.ok()) return record.error();
    measurer.add(**record);
    told.add(**record);
    if (each_row && measurer.started()) each_row(measurer.row());
    if (progress && !progress(k - first, last - first)) return cannot_finish(log.name() + ": interrupted");
  }
  Result<Metrics> metrics = measurer.finish((*record)->states);
  if (!metrics.ok()) return Error{metrics.error().kind, log.name() + ": " + metrics.error().message};
  metrics->told = told.note();
  return metrics;
}

}  // namespace tumble::replay
