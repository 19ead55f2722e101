#include "replay/measure_log.h"

#include "replay/state_source.h"

namespace tumble::replay {

Result<Metrics> measure_log(LogReader& log, const MeasureOptions& options,
                            const std::function<void(const SeriesRow&)>& each_row, const Progress& progress) {
  StateSource source(log);
  Measurer measurer(log.header(), options);
  Result<const StepRecord*> record = source.read(0);
  for (std::uint64_t k = 0; k <= log.step_count(); ++k) {
    const bool needs_states = k == 0 || k >= options.from_step;
    record = needs_states ? source.read(k) : log.read_hashes(k);
    if (!record.ok()) return record.error();
    measurer.add(**record);
    if (each_row && measurer.started()) each_row(measurer.row());
    if (progress && !progress(k, log.step_count())) return cannot_finish(log.name() + ": interrupted");
  }
  Result<Metrics> metrics = measurer.finish((*record)->states);
  if (!metrics.ok()) return Error{metrics.error().kind, log.name() + ": " + metrics.error().message};
  return metrics;
}

}  // namespace tumble::replay
