#include "replay/export/plan/export_log.h"

#include <algorithm>
#include <string>
#include <vector>

#include "replay/session/state_source.h"

namespace tumble::replay {
namespace {

/// The rows of the plan's bodies in a step; both lists ascend by id. Errors (kDamaged): a body that the inputs do not
/// explain, or that the states lack.
Status find_rows(const ExportPlan& plan, const StepRecord& record, std::size_t index,
                 std::vector<std::uint32_t>& rows) {
  const std::vector<sim::BodyId>& ids = record.states.id;
  rows.assign(plan.bodies.size(), ExportStep::kAbsent);
  std::size_t row = 0, found = 0;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    const ExportBody& body = plan.bodies[i];
    while (row < ids.size() && ids[row] < body.box.id) ++row;
    const bool there = row < ids.size() && ids[row] == body.box.id;
    if (there && !body.at(index) && std::ranges::binary_search(plan.undefined, body.box.id)) continue;
    if (there != body.at(index)) {
      return damaged(plan.log_name + ": " + plan.place(i, record.step) +
                     (there ? ": has a state, but no input adds it" : ": has no state, and no input removes it"));
    }
    if (!there) continue;
    rows[i] = static_cast<std::uint32_t>(row);
    ++found;
  }
  if (plan.chosen || found == ids.size()) return {};
  for (const sim::BodyId id : ids) {
    if (std::ranges::binary_search(plan.bodies, id, {}, [](const ExportBody& body) { return body.box.id; })) continue;
    if (std::ranges::binary_search(plan.undefined, id)) continue;
    return damaged(plan.log_name + ": body " + std::to_string(id) + " at step " + std::to_string(record.step) +
                   ": has a state, but neither the scene nor an input defines it");
  }
  return {};
}

template <class Use>
Status for_each_step(LogReader& log, const ExportPlan& plan, Use&& use, const Progress& progress) {
  log.read_ahead(plan.every == 1);
  StateSource source(log);
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const Result<const StepRecord*> record = source.read(plan.steps[i]);
    if (!record.ok()) return with_advice(record.error(), log, plan.steps[i]);
    if (Status ok = find_rows(plan, **record, i, rows); !ok.ok()) return ok;
    if (Status ok = use(ExportStep{i, plan.times[i], **record, rows}); !ok.ok()) return ok;
    if (progress && !progress(plan.steps.size() + i, 2 * plan.steps.size())) {
      return cannot_finish(plan.log_name + ": interrupted");
    }
  }
  log.read_ahead(false);
  return {};
}

}  // namespace

Status export_log(LogReader& log, const ExportPlan& plan, ExportWriter& writer, const Progress& progress) {
  if (Status ok = writer.begin(plan); !ok.ok()) return ok;
  const auto look = [&writer](const ExportStep& step) {
    writer.look(step);
    return Status();
  };
  if (writer.looks_first()) {
    if (Status ok = for_each_step(log, plan, look, progress); !ok.ok()) return ok;
  }
  const auto add = [&writer](const ExportStep& step) { return writer.add(step); };
  if (Status ok = for_each_step(log, plan, add, progress); !ok.ok()) return ok;
  return writer.finish();
}

}  // namespace tumble::replay
