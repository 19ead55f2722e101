#include "replay/import/csv/import_csv.h"

#include <algorithm>
#include <utility>

#include "replay/import/csv/csv_steps.h"
#include "replay/import/declared_bodies.h"
#include "replay/import/table_notes.h"
#include "replay/log/log_facts.h"
#include "src/base/text.h"
#include "tumble/replay/engine_log.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

/// The result of the first reading.
struct Survey {
  std::uint64_t states = 0;
  double first_dt = 0;  ///< of step 1; 0 without one
  std::vector<ChannelKind> kinds = {};
};

/// Notes bodies that a step lacks though the step before has them. In the last step a cut table looks so.
TableNotes note_missing(const CsvSteps& reader, const TableStep& before, const TableStep& step) {
  TableNotes notes;
  std::size_t missing = 0;
  sim::BodyId first = 0;
  for (const auto& [id, state] : before.rows) {
    if (std::ranges::binary_search(step.rows, id, {}, &TableStep::Row::first)) continue;
    if (missing++ == 0) first = id;
  }
  if (missing == 0) return notes;
  notes.short_end(reader.at_line(step.line, "").message, before.rows.size() - missing, before.rows.size(), first);
  return notes;
}

Result<Survey> survey(std::string_view text, const std::string& name, const ImportOptions& options) {
  Result<CsvSteps> reader =
      CsvSteps::open(text, name, {options.settings, options.like, options.map, {}, options.scalar_last});
  if (!reader.ok()) return reader.error();
  Survey found;
  TableStep step, before;
  for (;;) {
    std::swap(step, before);
    const Result<bool> more = reader->next(step);
    if (!more.ok()) return more.error();
    if (!*more) break;
    if (found.states > 0 && !(step.dt >= sim::kDtMin && step.dt <= sim::kDtMax)) {
      return reader->at_line(step.line, "found a step of " + significant(step.dt, 17) + " s, wanted 1e-7 … 1 s");
    }
    if (found.states == 1) found.first_dt = step.dt;
    ++found.states;
  }
  found.kinds = reader->channels().kinds();
  if (found.states == 0) return reader->at_line(1, "found no row, wanted at least those of one step");
  if (options.warn) {
    const TableNotes end = note_missing(*reader, step, before);  // swapped once after the last step
    for (const TableNotes& notes : {reader->notes(), end}) std::ranges::for_each(notes.texts(), options.warn);
    std::vector<std::string> misfits;
    reader->plausible().add_to(misfits, [&](sim::BodyId id) { return reader->info(id).name; });
    std::ranges::for_each(misfits, options.warn);
  }
  return found;
}

bool says_something(const BodyInfo& info) { return !info.name.empty() || info.shape != Hash128(); }

Declared declared_by(const CsvSteps& reader, const TableStep& first) {
  Declared declared;
  declared.channels = reader.channels().channels();
  declared.velocity_derived = reader.velocity_derived();
  declared.spin_derived = reader.spin_derived();
  DeclaredBodies bodies;
  for (const auto& [id, state] : first.rows) {
    if (says_something(reader.info(id))) bodies.add(reader.info(id), reader.shape(id), declared);
  }
  return declared;
}

Result<std::unique_ptr<EngineLog>> begin(const CsvSteps& reader, TableStep& first, const Survey& found,
                                         const MakeSink& make_sink) {
  sim::SceneDef start = reader.settings().scene;
  start.boxes.clear();
  start.inputs.clear();
  start.steps = found.states - 1;
  if (found.first_dt > 0) start.world.dt = found.first_dt;
  for (const auto& [id, state] : first.rows) start.boxes.push_back(reader.box(id));
  Result<std::unique_ptr<ByteSink>> sink = make_sink();
  if (!sink.ok()) return sink.error();
  EngineDef def = {reader.settings().engine, {}, reader.facts(), declared_by(reader, first)};
  first.values.move_to(def.declared.start);
  return EngineLog::create(*std::move(sink), def, start);
}

/// Adds inputs for the bodies that disappeared and appeared since the last step.
Status tell_of_bodies(EngineLog& log, const CsvSteps& reader, const TableStep& step) {
  const std::vector<sim::BodyId> there = log.bodies().id;
  const auto in_step = [&](sim::BodyId id) {
    return std::ranges::binary_search(step.rows, id, {}, &TableStep::Row::first);
  };
  for (const sim::BodyId id : there) {
    if (in_step(id)) continue;
    if (Status ok = log.input(sim::Remove{id}); !ok.ok()) return ok;
  }
  for (const auto& [id, state] : step.rows) {
    if (std::ranges::binary_search(there, id)) continue;
    sim::BoxDef box = reader.box(id);  // with the state in which the body first appeared, long ago for one that returns
    box.position = state.position;
    box.orientation = state.orientation;
    box.velocity = state.velocity;
    box.spin = state.spin;
    box.frozen = state.frozen && !box.is_static;
    if (Status ok = log.input(sim::Throw{box}); !ok.ok()) return ok;
    const BodyInfo& info = reader.info(id);
    if (!says_something(info)) continue;
    if (Status ok = log.describe_body(info, reader.shape(id)); !ok.ok()) return ok;
  }
  return {};
}

Status write_step(EngineLog& log, const CsvSteps& reader, TableStep& step) {
  if (Status ok = tell_of_bodies(log, reader, step); !ok.ok()) return ok;
  for (const auto& [id, state] : step.rows) {
    if (Status ok = log.set_state(id, state); !ok.ok()) return ok;
  }
  if (Status ok = log.set_values(step.values); !ok.ok()) return ok;
  return log.end_step(step.dt);
}

}  // namespace

Result<SessionLike> session_like(LogReader& log) {
  SessionLike like{log.header().scene, log.header().scene.boxes};
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    const Result<const StepRecord*> step = log.read_hashes(k);
    if (!step.ok()) return step.error();
    for (const sim::Command& input : (*step)->inputs) {
      if (const auto* thrown = std::get_if<sim::Throw>(&input)) like.boxes.push_back(thrown->box);
    }
  }
  std::ranges::sort(like.boxes, {}, &sim::BoxDef::id);
  like.dt_varies = dt_varies(log);
  return like;
}

Result<LogSummary> import_csv(std::string_view text, const std::string& name, const MakeSink& make_sink,
                              const ImportOptions& options, const Progress& progress) {
  const Result<Survey> found = survey(text, name, options);
  if (!found.ok()) return found.error();
  Result<CsvSteps> reader = CsvSteps::open(text, name, {options.settings, options.like, options.map, found->kinds});
  if (!reader.ok()) return reader.error();
  TableStep step;
  if (const Result<bool> first = reader->next(step); !first.ok()) return first.error();
  Result<std::unique_ptr<EngineLog>> log = begin(*reader, step, *found, make_sink);
  if (!log.ok()) return log.error();
  for (std::uint64_t k = 1; k < found->states; ++k) {
    if (const Result<bool> more = reader->next(step); !more.ok()) return more.error();
    if (Status ok = write_step(**log, *reader, step); !ok.ok()) return ok.error();
    if (progress && !progress(k, found->states - 1)) return cannot_finish(name + ": interrupted");
  }
  return (*log)->finish();
}

}  // namespace tumble::replay
