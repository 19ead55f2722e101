#include "replay/log/verify.h"

#include <algorithm>
#include <utility>

#include "replay/format/chain.h"
#include "replay/log/record_reader.h"
#include "replay/log/scan.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {
namespace {

class Verifier {
 public:
  Verifier(LogReader& log, const Progress& progress)
      : log_(log),
        progress_(progress),
        scan_(scan_records(log.source(), log.header_prelude(), log.header().missing())) {}

  VerifyReport run() {
    report_.condition = scan_.condition;
    for (const Damage& damage : log_.condition().damages) add(damage);
    previous_ = log_.header_prelude().chain_after;
    for (const ChunkPlace& place : scan_.chunks) {
      check_chunk(place);
      if (!progress_ || progress_(place.end_step() - 1 - log_.first_state(), log_.step_count())) continue;
      report_.complete = false;
      return std::move(report_);
    }
    check_index();
    check_footer();
    std::vector<Damage>& damages = report_.condition.damages;
    std::stable_sort(damages.begin(), damages.end(),
                     [](const Damage& a, const Damage& b) { return a.offset < b.offset; });
    return std::move(report_);
  }

 private:
  void add(const Damage& damage) {
    for (const Damage& known : report_.condition.damages) {
      if (known.kind == damage.kind && known.offset == damage.offset) return;
    }
    report_.condition.damages.push_back(damage);
  }
  void add(RecordKind kind, std::uint64_t offset, const std::string& message) { add(Damage{kind, offset, message}); }

  void check_chunk(const ChunkPlace& place) {
    const ChunkRules rules = rules_of(log_.header_prelude(), log_.header());
    Result<ChunkDecoder> chunk = RecordReader(log_.source()).read_chunk(place, rules);
    const auto wrong = [&](const std::string& message) {
      add(RecordKind::kChunk, place.offset,
          log_.name() + ": chunk at byte " + std::to_string(place.offset) + ": " + message);
      state_known_ = false;
    };
    if (!chunk.ok()) {
      add(RecordKind::kChunk, place.offset, chunk.error().message);
      state_known_ = false;
      return;
    }
    if (Status ok = check_keyframe(chunk->keyframe(), place); !ok.ok()) return wrong(ok.error().message);
    for (std::size_t i = 0; i < chunk->step_count(); ++i) {
      Result<const StepRecord*> step = chunk->step(i);
      if (!step.ok()) return wrong(step.error().message);
      if (Status ok = check_step(**step); !ok.ok()) return wrong(ok.error().message);
    }
    known_step_ = place.end_step() - 1;
    state_known_ = true;
  }

  /// A keyframe repeats the state after the step before.
  Status check_keyframe(const Keyframe& keyframe, const ChunkPlace& place) {
    const Hash128 found = sim::state_hash(keyframe.state.bodies);
    report_.keyframes.push_back({keyframe.state.step, keyframe.continuation_hash});
    if (place.first_step == log_.first_state() + 1) look_at_start(keyframe);
    if (place.first_step == log_.first_state() + 1 && !is_start(keyframe, found)) {
      return damaged("the first keyframe is not the state that the header tells of");
    }
    if (place.first_step > log_.first_state() + 1 && state_known_ && known_step_ + 1 == place.first_step &&
        found != previous_) {
      return damaged("the keyframe has state hash " + to_string(found) + ", the step before it " +
                     to_string(previous_));
    }
    if (log_.header().method_version != sim::method_version(keyframe.state.def.method)) return {};
    const Hash128 continuation = sim::continuation_hash(keyframe.state);
    if (continuation == keyframe.continuation_hash) return {};
    return damaged("the keyframe has continuation hash " + to_string(continuation) + ", the log says " +
                   to_string(keyframe.continuation_hash));
  }

  void note_contacts(std::uint64_t step, const Extras& extras) {
    if (!extras.contacts.empty() && !report_.contacts_from) report_.contacts_from = step;
  }

  void look_at_start(const Keyframe& keyframe) {
    BodyStates start;
    copy_visible(keyframe.state.bodies, start);
    report_.lost = first_not_finite(start, log_.first_state());
    note_contacts(log_.first_state(), log_.header().declared.start);
  }

  /// Whether the keyframe is the state that the log begins with. The chain starts from the hash of state 0; the header
  /// of a continued log names the complete state instead.
  [[nodiscard]] bool is_start(const Keyframe& keyframe, const Hash128& state) const {
    const std::optional<GoesOn>& before = log_.header().goes_on;
    if (before) return before->continuation_hash == keyframe.continuation_hash;
    return chain_start(state, log_.header().declared.start) == log_.header_prelude().chain_after;
  }

  Status check_step(const StepRecord& step) {
    ++report_.steps_checked;
    previous_ = step.state_hash;
    note_contacts(step.step, step.extras);
    if (!step.has_states) return {};
    ++report_.states_checked;
    if (!report_.lost) report_.lost = first_not_finite(step.states, step.step);
    const Hash128 found = state_hash(step.states);
    if (found == step.state_hash) return {};
    return damaged("step " + std::to_string(step.step) + " has states with hash " + to_string(found) +
                   ", the log says " + to_string(step.state_hash));
  }

  void check_index() {
    if (!scan_.index) return;
    const std::uint64_t offset = scan_.index->offset;
    const auto wrong = [&](const std::string& message) { add(RecordKind::kIndex, offset, message); };
    const Result<std::vector<ChunkPlace>> places =
        RecordReader(log_.source()).read_index(offset, log_.header_prelude().log_tag);
    if (!places.ok()) return wrong(places.error().message);
    if (!tells_of_file(*places))
      wrong("index at byte " + std::to_string(offset) + ": its rows are not the file's chunks");
  }

  /// Whether rows and chunks match one to one. A row without a chunk is accepted where damage was reported.
  [[nodiscard]] bool tells_of_file(const std::vector<ChunkPlace>& rows) const {
    auto chunk = scan_.chunks.begin();
    for (const ChunkPlace& row : rows) {
      if (chunk != scan_.chunks.end() && row == *chunk) {
        ++chunk;
        continue;
      }
      const std::vector<Damage>& damages = report_.condition.damages;
      const bool known = std::any_of(damages.begin(), damages.end(),
                                     [&](const Damage& damage) { return damage.offset == row.offset; });
      if (!known) return false;
    }
    return chunk == scan_.chunks.end();
  }

  void check_footer() {
    if (!scan_.footer) return;
    const Footer& footer = *scan_.footer;
    const std::uint64_t steps = scan_.chunks.empty() ? 0 : scan_.chunks.back().end_step() - 1 - log_.first_state();
    const auto wrong = [&](const std::string& what) {
      add(RecordKind::kFooter, scan_.footer_offset,
          "footer at byte " + std::to_string(scan_.footer_offset) + ": " + what);
    };
    if (footer.prelude.step_count != steps && scan_.condition.damages.empty()) {
      wrong("found " + std::to_string(footer.prelude.step_count) + " steps, wanted " + std::to_string(steps));
    } else if (footer.file_bytes != scan_.footer_offset + kFooterBytes) {
      wrong("found a file of " + std::to_string(footer.file_bytes) + " bytes, wanted " +
            std::to_string(scan_.footer_offset + kFooterBytes));
    } else if (scan_.index && footer.index_offset != scan_.index->offset) {
      wrong("found the index at byte " + std::to_string(footer.index_offset) + ", wanted byte " +
            std::to_string(scan_.index->offset));
    } else if (state_known_ && steps > 0 && known_step_ == log_.first_state() + footer.prelude.step_count &&
               footer.final_state_hash != previous_) {
      wrong("found the final state hash " + to_string(footer.final_state_hash) + ", wanted " + to_string(previous_));
    }
  }

  LogReader& log_;
  const Progress& progress_;
  Scan scan_;
  VerifyReport report_;
  Hash128 previous_;              // state hash of the step checked last
  std::uint64_t known_step_ = 0;  // its number
  bool state_known_ = false;
};

}  // namespace

VerifyReport verify(LogReader& log, const Progress& progress) { return Verifier(log, progress).run(); }

}  // namespace tumble::replay
