#include "replay/stream/import_stream.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "replay/import/declared_bodies.h"
#include "replay/stream/lent_sink.h"
#include "replay/stream/start_hashes.h"
#include "replay/stream/stream_bodies.h"
#include "replay/stream/stream_cursor.h"
#include "replay/stream/stream_end.h"
#include "replay/stream/stream_extras.h"
#include "replay/stream/stream_names.h"
#include "replay/stream/stream_step.h"
#include "src/base/text.h"
#include "tumble/replay/engine_log.h"

namespace tumble::replay {
namespace {

/// A step that no log can hold.
struct Refusal {
  std::size_t frame = 0;  // of StreamReader::steps()
  std::string message;
};

class StreamImporter {
 public:
  /// refusal: of an earlier attempt; the log ends before it.
  StreamImporter(const StreamReader& stream, const Progress& progress, std::optional<Refusal> refusal = {})
      : stream_(stream),
        progress_(progress),
        refusal_(std::move(refusal)),
        frames_(refusal_ ? refusal_->frame : stream.steps().size()),
        bodies_(stream.header().axes) {}

  /// The step at which write() ended the log.
  [[nodiscard]] const std::optional<Refusal>& refusal() const { return refusal_; }

  /// Finds what steps declare. Those that a rewind took back come first: what they declared holds on.
  Status survey() {
    StreamBodies scout(stream_.header().axes, stream_.header().gravity);  // for the values that will be cut
    for (const StreamFrame& frame : stream_.rewound()) {
      const Result<StreamStep> step = decode(frame);
      if (!step.ok()) return step.error();
      extras_.survey_channels(*step);
      for (const StreamMesh& mesh : step->meshes) bodies_.add(mesh);
    }
    for (const StreamFrame& frame : stream_.steps()) {
      Result<StreamStep> step = decode(frame);
      if (!step.ok()) return step.error();
      if (first_dt_ == 0) first_dt_ = step->dt;
      extras_.survey(*step);
      for (const StreamMesh& mesh : step->meshes) bodies_.add(mesh);
      extras_.survey_told(scout.cut(*step));
      (void)scout.end_start();
    }
    Result<RollbackCheck> rollbacks = check_rollbacks(stream_);
    if (!rollbacks.ok()) return rollbacks.error();
    rollbacks_ = *std::move(rollbacks);
    return {};
  }

  Result<StreamImport> write(const EngineLog::MakeSink& make_sink) {
    Result<StreamStep> start = decode(stream_.steps().front());
    if (!start.ok()) return start.error();
    bodies_.keep_sizes(*start);
    const sim::SceneDef begun = scene(*start);
    Result<EngineDef> def = engine(*start);
    if (!def.ok()) return def.error();
    bool is_sound = false;  // the start; what is wrong later is the place of the log
    Result<std::unique_ptr<EngineLog>> log = EngineLog::create(
        [&] {
          is_sound = true;
          return make_sink();
        },
        *def, begun);
    if (!log.ok()) {
      if (is_sound || log.error().kind != ErrorKind::kBadInput) return log.error();
      return bad_input(place(stream_, stream_.steps().front()) + ": the start: " + log.error().message);
    }
    for (std::size_t k = 1; k < frames_; ++k) {
      if (Status ok = write_step(**log, stream_.steps()[k]); !ok.ok()) {
        if (ok.error().kind != ErrorKind::kBadInput) return ok.error();
        (*log)->drop_step();
        refusal_ = Refusal{k, ok.error().message};
        break;
      }
      if (progress_ && !progress_(k, frames_ - 1)) return cannot_finish(stream_.name() + ": interrupted");
    }
    const Result<LogSummary> summary = (*log)->finish();
    if (!summary.ok()) return summary.error();
    return StreamImport{*summary, rollbacks_, warnings(), refusal_ ? refusal_->message : ""};
  }

 private:
  [[nodiscard]] static std::string place(const StreamReader& stream, const StreamFrame& frame) {
    return stream.name() + ": frame at byte " + std::to_string(frame.offset);
  }

  Result<StreamStep> decode(const StreamFrame& frame) const {
    const Result<std::vector<std::byte>> payload = stream_.read(frame);
    if (!payload.ok()) return payload.error();
    Result<StreamStep> step = decode_stream_step(frame.kind, *payload, place(stream_, frame));
    // A ring of hashes begins with bodies, of which its steps tell nothing more.
    if (!step.ok() || !stream_.header().hashes_only || !step->hashes.empty()) return step;
    StreamStep bare;
    bare.step = step->step;
    return bare;
  }

  Result<EngineDef> engine(const StreamStep& start) {
    const StreamHeader& header = stream_.header();
    EngineDef def;
    def.engine = header.engine;
    def.phases = phase_names(header.phases, phase_notes_);
    def.first_state = start.step;
    if (header.hashes_only) def.phases.assign(kStreamClasses.begin(), kStreamClasses.end());
    if (!header.axes.ours()) def.table = ImportedTable{header.axes, {}};
    def.start_states = bodies_.end_start();
    Result<Declared> declared = extras_.declare(start, bodies_.axes(), bodies_.take_told());
    if (!declared.ok()) return declared.error();
    def.declared = *std::move(declared);
    if (Status ok = declare_start_hashes(start, def.declared); !ok.ok()) return ok.error();
    Result<std::vector<EngineSnapshot>> begun = snapshots(start.step);
    if (!begun.ok()) return begun.error();
    def.declared.start.snapshots = *std::move(begun);
    describe_start(start, def.declared);
    def.declared.cut_short = cut_short();
    return def;
  }

  void describe_start(const StreamStep& start, Declared& declared) const {
    DeclaredBodies bodies;
    for (const StreamInput& input : start.inputs) {
      const auto* body = std::get_if<StreamBody>(&input);
      const auto description = body != nullptr ? bodies_.describe(*body) : std::nullopt;
      if (description) bodies.add(description->info, description->shape ? &*description->shape : nullptr, declared);
    }
    std::ranges::sort(declared.bodies, {}, &BodyInfo::id);
  }

  sim::SceneDef scene(const StreamStep& start) {
    const StreamHeader& header = stream_.header();
    sim::SceneDef scene;
    scene.name = header.scene.empty() ? "session" : header.scene;
    scene.world.gravity = bodies_.gravity(header.gravity);
    scene.world.ground = header.ground;
    scene.steps = stream_.steps().back().step;
    if (first_dt_ > 0) scene.world.dt = first_dt_;
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
    Result<StreamStep> step = decode(frame);
    if (!step.ok()) return step.error();
    bodies_.keep_sizes(*step);
    Status done = tell(log, *step);
    if (done.ok() || done.error().kind != ErrorKind::kBadInput) return done;
    return bad_input(place(stream_, frame) + ": " + done.error().message);
  }

  Status tell(EngineLog& log, StreamStep& step) {
    for (const StreamInput& input : step.inputs) {
      const std::optional<sim::Command> command = bodies_.command(input);
      if (!command) continue;
      if (Status ok = log.input(*command); !ok.ok()) return ok;
      if (Status ok = describe(log, input); !ok.ok()) return ok;
    }
    bodies_.add_untold(step);
    for (const StreamState& told : step.states) {
      const Result<EngineState> state = bodies_.state(told, step.step);
      if (!state.ok()) return state.error();
      if (Status ok = log.set_state(told.id, *state); !ok.ok()) return ok;
      bodies_.note_not_finite(told, step.step);
      bodies_.look_at(told.id, step.step, step.dt, *state);
    }
    bodies_.tell_turns();
    if (Status ok = tell_phases(log, step); !ok.ok()) return ok;
    if (Status ok = extras_.tell(log, step, bodies_.axes(), bodies_.take_told()); !ok.ok()) return ok;
    if (Status ok = tell_snapshots(log, step.step); !ok.ok()) return ok;
    for (const auto& [k, record] : rollbacks_.steps) {
      if (k != step.step) continue;
      if (Status ok = log.add_superseded(record); !ok.ok()) return ok;
    }
    return log.end_step(step.dt);
  }

  Status describe(EngineLog& log, const StreamInput& input) const {
    const auto* body = std::get_if<StreamBody>(&input);
    const auto description = body != nullptr ? bodies_.describe(*body) : std::nullopt;
    if (!description) return {};
    return log.describe_body(description->info, description->shape ? &*description->shape : nullptr);
  }

  /// The snapshots after step k: the number of the step, the name, the bytes.
  Result<std::vector<EngineSnapshot>> snapshots(std::uint64_t k) {
    std::vector<EngineSnapshot> found;
    for (const StreamFrame& frame : stream_.snapshots()) {
      if (frame.step != k) continue;
      const Result<std::vector<std::byte>> payload = stream_.read(frame);
      if (!payload.ok()) return payload.error();
      StreamCursor in(*payload);
      (void)in.number<std::uint64_t>();
      EngineSnapshot snapshot;
      snapshot.name = bodies_.kept_name("step " + std::to_string(k) + ": a snapshot's name", in.text());
      const std::span<const std::byte> bytes = in.take(in.left());
      if (!in.ok()) return bad_input("found a snapshot of " + std::to_string(payload->size()) + " bytes, wanted more");
      snapshot.bytes.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
      found.push_back(std::move(snapshot));
    }
    return found;
  }

  Status tell_snapshots(EngineLog& log, std::uint64_t k) {
    const Result<std::vector<EngineSnapshot>> found = snapshots(k);
    Status done = found.ok() ? Status() : Status(found.error());
    for (std::size_t i = 0; done.ok() && i < found->size(); ++i) {
      done = log.add_snapshot(std::as_bytes(std::span((*found)[i].bytes)), (*found)[i].name);
    }
    return done;
  }

  /// A phase that did not run in a substep has the word 0.
  Status tell_phases(EngineLog& log, const StreamStep& step) const {
    const std::size_t phases = stream_.header().phases.size();
    if (stream_.header().hashes_only) return log.set_phase_hashes(step.hashes);
    if (phases == 0) return {};
    std::vector<std::uint64_t> words(phases);
    for (const StreamPhase& phase : step.phases) {
      if (phase.row >= sim::PhaseHashes::kRowsMax)
        return bad_input("found a phase hash of substep " + std::to_string(phase.row));
      if (phase.phase >= phases) return bad_input("found a hash of phase " + std::to_string(phase.phase));
      words.resize(std::max(words.size(), (phase.row + 1) * phases));
      words[phase.row * phases + phase.phase] = phase.word;
    }
    return log.set_phase_hashes(words);
  }

  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    for (const auto& notes : {phase_notes_, bodies_.notes(), extras_.notes()}) {
      all.insert(all.end(), notes.begin(), notes.end());
    }
    if (refusal_) return all;  // which is said instead
    for (std::string& warning : end_warnings(stream_)) all.push_back(std::move(warning));
    return all;
  }

  /// For later readers of the log, which see a whole file.
  [[nodiscard]] std::string cut_short() const {
    if (!refusal_) return replay::cut_short(stream_);
    return "step " + std::to_string(stream_.steps()[refusal_->frame].step) +
           " of the recorder's stream is none that a log can hold";
  }

  const StreamReader& stream_;
  const Progress& progress_;
  std::optional<Refusal> refusal_;
  std::size_t frames_;  // to write
  StreamBodies bodies_;
  StreamExtras extras_;
  RollbackCheck rollbacks_;
  std::vector<std::string> phase_notes_;
  double first_dt_ = 0;
};

}  // namespace

Result<StreamImport> import_stream(const StreamReader& stream,
                                   const std::function<Result<std::unique_ptr<ByteSink>>()>& make_sink,
                                   const Progress& progress) {
  if (stream.steps().empty()) {
    const std::string& why = stream.condition().refusal;
    return damaged(stream.condition().damage.value_or(
        stream.name() + ": has no start: " + (why.empty() ? "tumble_rec_message() says why" : why)));
  }
  StreamImporter importer(stream, progress);
  if (Status ok = importer.survey(); !ok.ok()) return ok.error();
  std::shared_ptr<ByteSink> kept;
  const auto lend = [&] { return lend_sink(kept, make_sink); };
  Result<StreamImport> done = importer.write(lend);
  if (!done.ok() || !importer.refusal() || !can_write_again(*kept)) return done;
  // Only now is it known where the log ends. Its header says so, and stands before the steps: all is written again.
  kept->truncate(0);
  StreamImporter shorter(stream, progress, importer.refusal());
  if (Status ok = shorter.survey(); !ok.ok()) return ok.error();
  return shorter.write(lend);
}

}  // namespace tumble::replay
