#include "replay/stream/import_stream.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "replay/stream/stream_bodies.h"
#include "replay/stream/stream_step.h"
#include "src/base/text.h"
#include "tumble/replay/engine_log.h"

namespace tumble::replay {
namespace {

/// What the first reading finds.
struct Survey {
  double first_dt = 0;
  std::set<std::string> named_inputs;
  std::map<std::uint32_t, StreamChannel> channels;
  std::uint64_t contacts = 0;
  std::uint64_t notes = 0;
};

class StreamImporter {
 public:
  StreamImporter(const StreamReader& stream, const Progress& progress)
      : stream_(stream), progress_(progress), bodies_(stream.header().axes) {}

  Status survey() {
    for (const StreamFrame& frame : stream_.steps()) {
      const Result<StreamStep> step = decode(frame);
      if (!step.ok()) return step.error();
      look_at(*step);
    }
    return {};
  }

  Result<StreamImport> write(std::unique_ptr<ByteSink> sink) {
    const Result<StreamStep> start = decode(stream_.steps().front());
    if (!start.ok()) return start.error();
    Result<std::unique_ptr<EngineLog>> log = EngineLog::create(std::move(sink), engine(), scene(*start));
    if (!log.ok()) return log.error();
    for (std::size_t k = 1; k < stream_.steps().size(); ++k) {
      if (Status ok = write_step(**log, stream_.steps()[k]); !ok.ok()) return ok.error();
      if (progress_ && !progress_(k, stream_.steps().size() - 1)) {
        return cannot_finish(stream_.name() + ": stopped before its last step");
      }
    }
    const Result<LogSummary> summary = (*log)->finish();
    if (!summary.ok()) return summary.error();
    return StreamImport{*summary, warnings(), passed_over()};
  }

 private:
  [[nodiscard]] static std::string place(const StreamReader& stream, const StreamFrame& frame) {
    return stream.name() + ": frame at byte " + std::to_string(frame.offset);
  }

  Result<StreamStep> decode(const StreamFrame& frame) const {
    const Result<std::vector<std::byte>> payload = stream_.read(frame);
    if (!payload.ok()) return payload.error();
    return decode_stream_step(frame.kind, *payload, place(stream_, frame));
  }

  void look_at(const StreamStep& step) {
    if (survey_.first_dt == 0) survey_.first_dt = step.dt;
    for (const StreamInput& input : step.inputs) {
      if (const auto* named = std::get_if<StreamNamedInput>(&input)) survey_.named_inputs.insert(named->name);
    }
    for (const StreamChannel& channel : step.channels) survey_.channels.emplace(channel.number, channel);
    survey_.contacts += step.contacts.size();
    survey_.notes += step.notes.size();
  }

  [[nodiscard]] EngineDef engine() const {
    const StreamHeader& header = stream_.header();
    EngineDef def;
    def.engine = header.engine;
    def.phases = header.phases;
    if (header.hashes_only) def.phases.assign(kStreamClasses.begin(), kStreamClasses.end());
    if (!header.axes.ours()) def.table = ImportedTable{header.axes, {}};
    return def;
  }

  sim::SceneDef scene(const StreamStep& start) {
    const StreamHeader& header = stream_.header();
    sim::SceneDef scene;
    scene.name = header.scene.empty() ? "session" : header.scene;
    scene.world.gravity = header.axes.length(header.gravity);
    scene.world.ground = header.ground;
    scene.steps = stream_.steps().size() - 1;
    if (survey_.first_dt > 0) scene.world.dt = survey_.first_dt;
    for (const StreamInput& input : start.inputs) {
      const std::optional<sim::Command> command = bodies_.command(input);
      if (!command) continue;
      if (const auto* thrown = std::get_if<sim::Throw>(&*command)) scene.boxes.push_back(thrown->box);
      if (const auto* set = std::get_if<sim::SetGravity>(&*command)) scene.world.gravity = set->gravity;
    }
    std::ranges::sort(scene.boxes, {}, &sim::BoxDef::id);
    return scene;
  }

  Status write_step(EngineLog& log, const StreamFrame& frame) {
    const Result<StreamStep> step = decode(frame);
    if (!step.ok()) return step.error();
    Status done = tell(log, *step);
    if (done.ok() || done.error().kind != ErrorKind::kBadInput) return done;
    return bad_input(place(stream_, frame) + ": " + done.error().message);
  }

  Status tell(EngineLog& log, const StreamStep& step) {
    for (const StreamInput& input : step.inputs) {
      const std::optional<sim::Command> command = bodies_.command(input);
      if (!command) continue;
      if (Status ok = log.input(*command); !ok.ok()) return ok;
    }
    for (const StreamState& told : step.states) {
      const Result<EngineState> state = bodies_.state(told);
      if (!state.ok()) return state.error();
      if (Status ok = log.set_state(told.id, *state); !ok.ok()) return ok;
    }
    if (Status ok = tell_phases(log, step); !ok.ok()) return ok;
    return log.end_step(step.dt);
  }

  /// A phase that did not run in a substep has the word 0.
  Status tell_phases(EngineLog& log, const StreamStep& step) const {
    const std::size_t phases = stream_.header().phases.size();
    if (stream_.header().hashes_only) return log.set_phase_hashes(step.hashes);
    if (phases == 0) return {};
    std::uint32_t rows = 1;
    for (const StreamPhase& phase : step.phases) rows = std::max(rows, phase.row + 1);
    if (rows > sim::PhaseHashes::kRowsMax) return bad_input("found a phase hash of substep " + std::to_string(rows));
    std::vector<std::uint64_t> words(rows * phases);
    for (const StreamPhase& phase : step.phases) {
      if (phase.phase >= phases) return bad_input("found a hash of phase " + std::to_string(phase.phase));
      words[phase.row * phases + phase.phase] = phase.word;
    }
    return log.set_phase_hashes(words);
  }

  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all = bodies_.notes();
    const StreamCondition& condition = stream_.condition();
    const std::string last = std::to_string(stream_.steps().back().step);
    if (condition.damage) all.push_back(*condition.damage + "; the log ends with step " + last);
    if (condition.torn || (!condition.finished && !condition.damage)) {
      all.push_back(stream_.name() + ": ends without its last frame: the recorder was stopped after step " + last);
    }
    return all;
  }

  [[nodiscard]] std::vector<std::string> passed_over() const {
    std::vector<std::string> all;
    for (const std::string& name : survey_.named_inputs) all.push_back("input " + name);
    for (const auto& [number, channel] : survey_.channels) all.push_back("channel " + channel.name);
    if (survey_.contacts > 0) all.push_back(count_text(survey_.contacts, "contact"));
    if (survey_.notes > 0) all.push_back(count_text(survey_.notes, "note"));
    if (!stream_.snapshots().empty()) all.push_back(count_text(stream_.snapshots().size(), "snapshot"));
    return all;
  }

  const StreamReader& stream_;
  const Progress& progress_;
  StreamBodies bodies_;
  Survey survey_;
};

}  // namespace

Result<StreamImport> import_stream(const StreamReader& stream,
                                   const std::function<Result<std::unique_ptr<ByteSink>>()>& make_sink,
                                   const Progress& progress) {
  if (stream.steps().empty()) {
    return damaged(stream.condition().damage.value_or(stream.name() + ": ends before the start was written"));
  }
  StreamImporter importer(stream, progress);
  if (Status ok = importer.survey(); !ok.ok()) return ok.error();
  Result<std::unique_ptr<ByteSink>> sink = make_sink();
  if (!sink.ok()) return sink.error();
  return importer.write(*std::move(sink));
}

}  // namespace tumble::replay
