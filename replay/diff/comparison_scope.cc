#include "tumble/replay/comparison_scope.h"

#include <algorithm>
#include <optional>

#include "replay/log/hashes_only.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kRunsShown = 4;
constexpr std::size_t kChannelsShown = 12;

std::string run_text(std::uint64_t first, std::uint64_t last) {
  return to_string(MissingSteps{first, last + 1 - first});
}

std::string columns_text(const std::vector<std::string>& names) {
  std::string text = names.size() == 1 ? "column " : "columns ";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return text;
}

std::string channels_text(const std::vector<std::string>& names) {
  std::string text = count_text(names.size(), "channel") + " (";
  for (std::size_t i = 0; i < std::min(kChannelsShown, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return text + (names.size() > kChannelsShown ? ", …)" : ")");
}

class Scope {
 public:
  Scope(const LogReader& a, const LogReader& b, const Tolerances& tolerances, const DiffFacts& facts)
      : a_(a), b_(b), tolerances_(tolerances), facts_(facts) {}

  ComparisonScope take() {
    if (holds_hashes_only(a_.header()) && holds_hashes_only(b_.header())) {
      add_hashes_of_streams();
      add_ends();
      leave_out(never_compared());
      return std::move(scope_);
    }
    if (one_holds_hashes_only(a_.header(), b_.header())) {
      add_hashes_and_values();
      add_ends();
      leave_out(never_compared());
      return std::move(scope_);
    }
    add_steps();
    add_states();
    if (!facts_.channels.empty()) compare(channels_text(facts_.channels));
    const bool contacts = facts_.imported && !facts_.states_only && !facts_.no_contacts && tolerances_.exact();
    if (contacts) compare(facts_.hashes_only ? "contacts of the engine, if it told any" : "contacts of the engine");
    for (const std::string& part : facts_.left_out) leave_out(part);
    add_tolerances();
    add_worlds();
    add_ends();
    leave_out(never_compared());
    return std::move(scope_);
  }

 private:
  void compare(std::string part) { scope_.compared.push_back(std::move(part)); }
  /// Each part once: a log may be compared with itself.
  void leave_out(std::string part) {
    if (std::ranges::find(scope_.not_compared, part) == scope_.not_compared.end()) {
      scope_.not_compared.push_back(std::move(part));
    }
  }

  /// Nothing but hashes was recorded, so nothing but hashes was compared.
  void add_hashes_of_streams() {
    compare("step lengths");
    const bool start = a_.first_state() == b_.first_state() && has_start_hashes(a_.header());
    const bool both_starts = start && has_start_hashes(b_.header());
    compare("hashes of inputs, states, contacts, phase hashes and channels of " +
            std::string(both_starts ? "the start and " : "") + count_text(facts_.last - facts_.from, "step"));
    if (!both_starts) leave_out("the start: its bodies, and inputs before the first step; a log holds no hash of it");
    leave_out("the values themselves: the recorders kept hashes only");
  }

  /// The hashes are of the stream, in the order in which the engine told; a log of values has another order.
  void add_hashes_and_values() {
    compare("step lengths");
    const bool in_a = holds_hashes_only(a_.header());
    leave_out("inputs, states, contacts, phase hashes and channels: " + (in_a ? a_ : b_).name() +
              " holds hashes of them, " + (in_a ? b_ : a_).name() +
              " the values; record both alike, or open the recorder with `verify`, which compares values with hashes");
  }

  void add_steps() {
    compare("step lengths");
    const LogHeader &a = a_.header(), &b = b_.header();
    if (facts_.states_only) {
      leave_out("inputs, counters and phase hashes: the logs are of two engines");
      return;
    }
    compare("inputs");
    if (!tolerances_.exact()) {
      leave_out(
          facts_.hashes_only
              ? "phase hashes, state hashes and counters where they differ: tolerances leave them out"
              : "phase hashes, state hashes and counters: they differ with one bit, so tolerances leave them out");
      return;
    }
    compare("counters");
    if (facts_.phases.equal || !facts_.phases.names.empty()) {
      if (!facts_.imported || !a.phases.empty()) add_phase_hashes(a_, b_, {facts_.from, facts_.last}, scope_);
      if (!facts_.phases.all) leave_out("hashes of the phases that one log alone has");
    } else if (a.phases != b.phases) {
      leave_out("phase hashes and contact counts: the phases have not the same names");
    } else if (a.phase_hash_version == b.phase_hash_version) {
      leave_out("phase hashes and contact counts: the logs keep other numbers of substeps");
    } else {
      leave_out(phase_hash_note(a, b));
    }
  }

  void add_states() {
    compare("the state of step " + std::to_string(facts_.from));
    if (tolerances_.exact() && facts_.zeros == 0) compare("state hashes");
    if (facts_.hashes_only) {
      if (!tolerances_.exact()) compare("state hashes where they are equal");
      if (facts_.states_read > 0)
        compare("states of " + count_text(facts_.states_read, "step") + " whose hashes differ");
      leave_out("the payloads of chunks with equal hashes: not read, so damage in them is not seen");
      return;
    }
    std::uint64_t in_both = 0, steps = 0;
    for (std::uint64_t k = facts_.from + 1; k <= facts_.last; ++k) {
      if (!a_.holds(k) || !b_.holds(k)) continue;
      ++steps;
      if (a_.header().states.holds(k) && b_.header().states.holds(k)) ++in_both;
    }
    if (in_both > 0) compare("states of " + count_text(in_both, "step"));
    if (in_both < steps) {
      leave_out("states of " + count_text(steps - in_both, "step") +
                ", which a log does not hold: by their hashes alone");
    }
    if (facts_.zeros > 0) leave_out("the sign of " + count_text(facts_.zeros, "zero") + " in states of another engine");
  }

  void add_tolerances() {
    for (const auto& [field, tolerance] : tolerances_.fields) {
      leave_out("differences of " + field + " up to " + exact(tolerance) + ": excused");
    }
  }

  void add_worlds() {
    if (facts_.worlds > 0 && tolerances_.exact()) {
      compare("complete states of " + count_text(facts_.worlds, "keyframe"));
      return;
    }
    if (facts_.imported) return;
    const char* why = facts_.hashes_only     ? "not read"
                      : !tolerances_.exact() ? "tolerances leave them out"
                      : facts_.one_scene     ? "the logs have no keyframe at one step"
                                             : "scenes or method versions differ";
    leave_out(std::string("masses, inertias, materials and hidden states of keyframes: ") + why);
  }

  void add_ends() {
    const std::uint64_t first_a = a_.first_state(), first_b = b_.first_state();
    if (first_a != first_b) {
      leave_out(run_text(std::min(first_a, first_b) + 1, std::max(first_a, first_b)) + ", which only " +
                (first_a < first_b ? a_ : b_).name() + " has");
    }
    const std::uint64_t last_a = a_.last_step(), last_b = b_.last_step();
    if (last_a != last_b) {
      leave_out(run_text(std::min(last_a, last_b) + 1, std::max(last_a, last_b)) + ", which only " +
                (last_a > last_b ? a_ : b_).name() + " has");
    }
    for (const LogReader* log : {&a_, &b_}) {
      const std::optional<ImportedTable>& table = log->header().table;
      if (table && !table->passed_over.empty()) {
        leave_out(columns_text(table->passed_over) + " of the table of " + log->name() +
                  ": the import passed over them");
      }
      add_lost_steps(*log);
      if (std::string part = not_intact(*log); !part.empty()) leave_out(std::move(part));
    }
  }

  /// Steps between those compared, which a recovered or damaged log does not hold.
  void add_lost_steps(const LogReader& log) {
    std::vector<MissingSteps> runs;
    std::uint64_t count = 0;
    for (std::uint64_t k = facts_.from + 1; k <= facts_.last; ++k) {
      if (log.holds(k)) continue;
      if (runs.empty() || runs.back().end_step() != k) runs.push_back({k, 0});
      ++runs.back().step_count;
      ++count;
    }
    if (runs.empty()) return;
    std::string part = std::to_string(count) + " of " + count_text(facts_.last - facts_.from, "step") + ", lost from " +
                       log.name() + ": ";
    for (std::size_t i = 0; i < std::min(kRunsShown, runs.size()); ++i)
      part += (i == 0 ? "" : ", ") + to_string(runs[i]);
    if (runs.size() > kRunsShown) part += " and " + std::to_string(runs.size() - kRunsShown) + " more runs";
    leave_out(std::move(part));
  }

  const LogReader& a_;
  const LogReader& b_;
  const Tolerances& tolerances_;
  const DiffFacts& facts_;
  ComparisonScope scope_;
};

}  // namespace

std::vector<std::string> ComparisonScope::passed_over() const {
  std::vector<std::string> parts = not_compared;
  std::erase(parts, never_compared());
  return parts;
}

std::string ComparisonScope::every_bit() const { return passed_over().empty() ? "every bit" : "every compared bit"; }

void CommonScope::count(const std::string& text, const std::string& logs, std::vector<Part>& parts) {
  const auto known = std::ranges::find(parts, text, &Part::text);
  if (known == parts.end()) {
    parts.push_back({text, 1, logs});
  } else {
    ++known->count;
  }
}

void CommonScope::add(const ComparisonScope& scope, const std::string& logs) {
  ++comparisons_;
  for (const std::string& part : scope.compared) count(part, logs, compared_);
  for (const std::string& part : scope.not_compared) count(part, logs, not_compared_);
}

ComparisonScope CommonScope::scope() const {
  ComparisonScope common;
  for (const Part& part : compared_) {
    if (part.count == comparisons_) {
      common.compared.push_back(part.text);
    } else {
      common.not_compared.push_back(part.text + ": only between some of the logs, such as " + part.logs);
    }
  }
  for (const Part& part : not_compared_) {
    const bool everywhere = part.count == comparisons_;
    common.not_compared.push_back(part.text + (everywhere ? "" : " (between " + part.logs + ')'));
  }
  return common;
}

void add_phase_hashes(const LogReader& a, const LogReader& b, const StepRange& range, ComparisonScope& scope) {
  std::uint64_t in_both = 0, steps = 0;
  for (std::uint64_t k = range.from + 1; k <= range.last; ++k) {
    if (!a.holds(k) || !b.holds(k)) continue;
    ++steps;
    if (a.header().hashes.holds(k) && b.header().hashes.holds(k)) ++in_both;
  }
  if (in_both == steps) {
    scope.compared.emplace_back("phase hashes");
    return;
  }
  if (in_both > 0) scope.compared.push_back("phase hashes of " + count_text(in_both, "step"));
  scope.not_compared.push_back("phase hashes of " + count_text(steps - in_both, "step") +
                               ", which a log does not hold");
}

ComparisonScope scope_of(const LogReader& a, const LogReader& b, const Tolerances& tolerances, const DiffFacts& facts) {
  return Scope(a, b, tolerances, facts).take();
}

std::string not_whole(const LogReader& log) {
  const LogCondition& condition = log.condition();
  if (!condition.whole()) return log.name() + " is not whole: " + condition.summary(log.last_step());
  const std::string& cut_short = log.header().declared.cut_short;
  return cut_short.empty() ? "" : log.name() + ": its session may have gone on: " + cut_short;
}

std::vector<std::string> notes_on_wholeness(const LogReader& a, const LogReader& b) {
  std::vector<std::string> notes;
  for (const LogReader* log : {&a, &b}) {
    std::string note = not_whole(*log);
    if (!note.empty() && std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
  }
  return notes;
}

std::string not_intact(const LogReader& log) {
  const LogCondition& condition = log.condition();
  if (condition.sound()) return "";
  std::string bytes = "damaged records";
  if (condition.torn) bytes = "bytes from byte " + std::to_string(condition.torn_offset) + " on";
  return "the " + bytes + " of " + log.name() + ": " + condition.summary(log.last_step());
}

std::string never_compared() {
  return "names, texts, notes, snapshots, cameras, lights and looks: no step depends on them";
}

}  // namespace tumble::replay
