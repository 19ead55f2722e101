#include "tumble/replay/compare.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "replay/format/chain.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {
namespace {

double tolerance_of(const Tolerances& tolerances, std::size_t column) {
  if (column >= kOrientation) return tolerances.orientation;
  if (column >= kPosition) return tolerances.position;
  return column >= kSpin ? tolerances.spin : tolerances.velocity;
}

/// Copies into `actual` every value of `expected` within tolerance, so that an exact comparison finds it equal.
void forgive(const BodyStates& expected, BodyStates& actual, const Tolerances& tolerances) {
  if (expected.id != actual.id) return;
  const ConstColumns wanted = columns_of(expected);
  const Columns found = columns_of(actual);
  for (std::size_t c = 0; c < kColumnCount; ++c) {
    const double tolerance = tolerance_of(tolerances, c);
    if (tolerance == 0) continue;
    for (std::size_t i = 0; i < actual.size(); ++i) {
      if (std::fabs((*found[c])[i] - (*wanted[c])[i]) <= tolerance) (*found[c])[i] = (*wanted[c])[i];
    }
  }
}

/// Differences of the headers, for people. Steps decide whether two sessions are equal; two logs of one session may
/// well have other headers (another tool, another --states).
std::vector<std::string> different_headers(const LogHeader& a, const LogHeader& b) {
  std::vector<std::string> lines;
  const auto check = [&](const char* what, const std::string& value_a, const std::string& value_b) {
    if (value_a != value_b) lines.push_back(std::string(what) + ": " + value_a + " and " + value_b);
  };
  const auto engine = [](const LogHeader& header) { return header.engine ? to_string(*header.engine) : "tumble"; };
  check("engine", engine(a), engine(b));
  check("method", a.method, b.method);
  check("method version", std::to_string(a.method_version), std::to_string(b.method_version));
  check("scene", a.scene.name, b.scene.name);
  check("transform", to_string(a.transform), to_string(b.transform));
  const auto start = [](const LogHeader& header) {
    return header.goes_on ? "step " + std::to_string(header.goes_on->step) + " of another session" : "state 0";
  };
  check("begins with", start(a), start(b));
  check("planned steps", std::to_string(a.scene.steps), std::to_string(b.scene.steps));
  check("states", to_string(a.states), to_string(b.states));
  check("written by", a.tool_version + ", " + a.tool_build, b.tool_version + ", " + b.tool_build);
  if (a.phases != b.phases) {
    lines.emplace_back("phases: not the same names, so only states are compared");
  } else if (std::string note = phase_hash_note(a, b); !note.empty()) {
    lines.push_back(std::move(note));
  }
  if (a.goes_on != b.goes_on) return lines;  // the two scenes are those of different steps
  check("bodies at the start", std::to_string(a.scene.boxes.size()), std::to_string(b.scene.boxes.size()));
  if (!(a.scene.world == b.scene.world)) lines.emplace_back("world: not the same parameters");
  if (a.scene.boxes != b.scene.boxes) lines.emplace_back("boxes: not the same at the start");
  if (a.scene.inputs != b.scene.inputs) lines.emplace_back("inputs: not the same script");
  return lines;
}

/// One comparison of two logs, A and B.
///
/// Three kinds of comparison share the loop. Exact: hashes decide, states only name body and field. With tolerances:
/// states decide, as soon as hashes differ. Logs of two engines: dt and states decide, because engines differ in
/// phases, counters and the inputs they know.
class Diff {
 public:
  Diff(LogReader& a, LogReader& b, const Tolerances& tolerances) : a_(a), b_(b), tolerances_(tolerances) {
    same_words_ = same_phase_words(a.header(), b.header());
    if (same_words_ && tolerances.exact()) phases_ = a.header().phases;
    const auto engine = [](const LogHeader& header) { return header.engine.value_or(EngineName()).name; };
    states_only_ = engine(a.header()) != engine(b.header());
    chains_say_all_ = same_words_ && !states_only_;
  }

  Result<DiffReport> run(const Progress& progress) {
    report_.last_a = a_.last_step();
    report_.last_b = b_.last_step();
    const std::uint64_t from = report_.from = std::max(a_.first_state(), b_.first_state());
    const std::uint64_t last = std::min(report_.last_a, report_.last_b);
    if (from > last) return no_common_step();
    report_.steps = last - from;
    report_.headers = different_headers(a_.header(), b_.header());
    if (Status ok = compare_start(from); !ok.ok()) return ok.error();
    if (report_.first) return std::move(report_);
    Result<std::uint64_t> same = last_known_same(from, last);
    if (!same.ok()) return same.error();
    for (std::uint64_t k = *same + 1; k <= last && !report_.first; ++k) {
      if (a_.lost_at(k) != nullptr || b_.lost_at(k) != nullptr) {
        --report_.steps;
        continue;
      }
      if (Status ok = compare_step(k); !ok.ok()) return ok.error();
      if (progress && !progress(k - from, report_.steps)) break;
    }
    return std::move(report_);
  }

 private:
  [[nodiscard]] Error no_common_step() const {
    const auto range = [](const LogReader& log) {
      return log.name() + " holds steps " + std::to_string(log.first_state()) + " to " +
             std::to_string(log.last_step());
    };
    return bad_input("found no step in common: " + range(a_) + ", " + range(b_));
  }

  /// The last step up to which the chains of both logs agree, among the steps at which log A ends a chunk. A chain
  /// value is a hash over all steps before, so two chains that differ once never agree again: a binary search finds the
  /// place. If log B ends a chunk at that step too, the index of each log has the value, and no chunk is decoded.
  [[nodiscard]] Result<std::uint64_t> last_known_same(std::uint64_t from, std::uint64_t last) {
    if (!chains_say_all_) return from;
    const Result<Hash128> chain_a = a_.chain_at(from), chain_b = b_.chain_at(from);
    if (!chain_a.ok()) return chain_a.error();
    if (!chain_b.ok()) return chain_b.error();
    if (*chain_a != *chain_b) return from;
    const std::vector<ChunkPlace>& chunks = a_.chunks();
    const auto ends_by = [](std::uint64_t step, const ChunkPlace& place) { return step < place.end_step() - 1; };
    auto low =
        std::upper_bound(chunks.begin(), chunks.end(), from, ends_by);  // all chunks before it are known to be equal
    auto high = std::upper_bound(chunks.begin(), chunks.end(), last, ends_by);
    std::uint64_t same = from;
    while (low < high) {
      const auto middle = low + (high - low) / 2;
      const Result<Hash128> other = b_.chain_at(middle->end_step() - 1);  // no answer where a record is damaged
      if (other.ok() && *other == middle->chain_after) {
        same = middle->end_step() - 1;
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return same;
  }

  /// Compares the first states of both, without the inputs and phases that led there.
  Status compare_start(std::uint64_t from) {
    StepRecord start_a, start_b;
    if (Status ok = read_start(a_, from, start_a); !ok.ok()) return ok;
    if (Status ok = read_start(b_, from, start_b); !ok.ok()) return ok;
    if (Status ok = can_tolerate(start_a, start_b); !ok.ok()) return ok;
    judge(start_a, start_b);
    if (report_.first) report_.first->phase = "start";
    return {};
  }

  static Status read_start(LogReader& log, std::uint64_t from, StepRecord& start) {
    Result<const StepRecord*> record = log.read_step(from);
    if (!record.ok()) return record.error();
    start.step = from;
    start.state_hash = (*record)->state_hash;
    start.has_states = (*record)->has_states;
    start.states = (*record)->states;
    return {};
  }

  /// Compares step k by hashes. chain_next() covers every field of a record but its states, which the state hash stands
  /// for, so one comparison of 128 bits replaces one a field.
  Status compare_step(std::uint64_t k) {
    Result<const StepRecord*> a = a_.read_hashes(k);
    if (!a.ok()) return a.error();
    Result<const StepRecord*> b = b_.read_hashes(k);
    if (!b.ok()) return b.error();
    if (states_only_ && (*a)->dt == (*b)->dt && (*a)->state_hash == (*b)->state_hash) return {};
    StepRecord actual = **b;
    if (!same_words_) leave_out_phase_words(**a, actual);
    if (chain_next({}, **a) == chain_next({}, actual)) return {};
    return compare_states(k, **a, actual);
  }

  /// Tolerances need states: hashes only tell that two states differ, not by how much.
  [[nodiscard]] Status can_tolerate(const StepRecord& a, const StepRecord& b) const {
    if (tolerances_.exact() || (a.has_states && b.has_states) || a.state_hash == b.state_hash) return {};
    return bad_input("step " + std::to_string(a.step) +
                     ": its hashes differ and one log has no states of it, so tolerances cannot be judged; record "
                     "both with --states all");
  }

  /// Compares a step whose hashes differ, with its states where both logs hold them.
  Status compare_states(std::uint64_t k, const StepRecord& hashes_a, const StepRecord& hashes_b) {
    if (Status ok = can_tolerate(hashes_a, hashes_b); !ok.ok()) return ok;
    StepRecord expected = hashes_a;
    StepRecord actual = hashes_b;
    if (hashes_a.has_states && hashes_b.has_states) {
      Result<const StepRecord*> a = a_.read_step(k);
      if (!a.ok()) return a.error();
      Result<const StepRecord*> b = b_.read_step(k);
      if (!b.ok()) return b.error();
      expected = **a;
      actual = **b;
    }
    judge(expected, actual);
    return {};
  }

  /// Finds the first difference. Fields that this kind of comparison leaves out are first made equal in `actual`.
  void judge(const StepRecord& expected, StepRecord& actual) {
    if (!same_words_) leave_out_phase_words(expected, actual);
    if (!tolerances_.exact()) tolerate(expected, actual);
    if (states_only_) {
      actual.counters = expected.counters;
      actual.inputs = expected.inputs;
    }
    report_.first = first_difference(expected, actual, phases_);
    if (report_.first && in_binary32()) count_in_binary32(*report_.first);
  }

  [[nodiscard]] bool in_binary32() const {
    const auto is_single = [](const LogReader& log) {
      return log.header().engine && log.header().engine->precision_bits == kBinary32Bits;
    };
    return is_single(a_) && is_single(b_);
  }

  /// With tolerances only the visible states decide: hashes and counters differ as soon as one bit does.
  void tolerate(const StepRecord& expected, StepRecord& actual) const {
    forgive(expected.states, actual.states, tolerances_);
    actual.counters = expected.counters;
    if (same_bits(expected.states, actual.states)) actual.state_hash = expected.state_hash;
  }

  LogReader& a_;
  LogReader& b_;
  Tolerances tolerances_;
  std::vector<std::string> phases_;
  bool same_words_ = false;
  bool chains_say_all_ = false;
  bool states_only_ = false;  // of two engines, whose phases and counters cannot be compared
  DiffReport report_;
};

}  // namespace

Status set_tolerance(Tolerances& tolerances, const std::string& field, double value) {
  if (!(value >= 0) || std::isinf(value)) {
    return bad_input("tolerance " + field + ": found " + to_string(FieldValue(value)) + ", wanted a number from 0 on");
  }
  if (field == "position") {
    tolerances.position = value;
  } else if (field == "orientation") {
    tolerances.orientation = value;
  } else if (field == "velocity") {
    tolerances.velocity = value;
  } else if (field == "spin") {
    tolerances.spin = value;
  } else {
    return bad_input("tolerance: found field \"" + field + "\", wanted position, orientation, velocity or spin");
  }
  return {};
}

Result<DiffReport> diff_logs(LogReader& a, LogReader& b, const Tolerances& tolerances, const Progress& progress) {
  return Diff(a, b, tolerances).run(progress);
}

}  // namespace tumble::replay
