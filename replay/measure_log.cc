#include "replay/measure_log.h"

#include "replay/state_source.h"

namespace tumble::replay {

Result<Metrics> measure_log(LogReader& log, const std::function<void(const SeriesRow&)>& each_row,
                            const Progress& progress) {
  StateSource source(log);
  Result<const StepRecord*> record = source.read(0);
  if (!record.ok()) return record.error();
  Measurer measurer(log.header(), **record);
  if (each_row) each_row(measurer.row());
  for (std::uint64_t k = 1; k <= log.step_count(); ++k) {
    record = source.read(k);
    if (!record.ok()) return record.error();
    measurer.add(**record);
    if (each_row) each_row(measurer.row());
    if (progress && !progress(k, log.step_count())) return cannot_finish(log.name() + ": interrupted");
  }
  return measurer.finish((*record)->states);
}

}  // namespace tumble::replay
