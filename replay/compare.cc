#include "replay/compare.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "replay/columns.h"
#include "replay/little_endian.h"

namespace tumble::replay {
namespace {

double tolerance_of(const Tolerances& tolerances, std::size_t column) {
  if (column >= kOrientation) return tolerances.orientation;
  if (column >= kPosition) return tolerances.position;
  return column >= kSpin ? tolerances.spin : tolerances.velocity;
}

/// Copies into `actual` what lies within tolerance of `expected`, so that an exact comparison passes over it.
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

std::vector<std::string> different_headers(const LogHeader& a, const LogHeader& b) {
  std::vector<std::string> lines;
  const auto check = [&](const char* what, const std::string& value_a, const std::string& value_b) {
    if (value_a != value_b) lines.push_back(std::string(what) + ": " + value_a + " and " + value_b);
  };
  check("method", a.method, b.method);
  check("method version", std::to_string(a.method_version), std::to_string(b.method_version));
  check("scene", a.scene.name, b.scene.name);
  check("bodies at the start", std::to_string(a.scene.boxes.size()), std::to_string(b.scene.boxes.size()));
  check("planned steps", std::to_string(a.scene.steps), std::to_string(b.scene.steps));
  check("states", to_string(a.states), to_string(b.states));
  check("written by", a.tool_version + ", " + a.tool_build, b.tool_version + ", " + b.tool_build);
  if (a.phases != b.phases) lines.emplace_back("phases: not the same names, so only states are compared");
  if (!(a.scene.world == b.scene.world)) lines.emplace_back("world: not the same parameters");
  if (a.scene.boxes != b.scene.boxes) lines.emplace_back("boxes: not the same at the start");
  if (a.scene.inputs != b.scene.inputs) lines.emplace_back("inputs: not the same script");
  return lines;
}

class Diff {
 public:
  Diff(LogReader& a, LogReader& b, const Tolerances& tolerances) : a_(a), b_(b), tolerances_(tolerances) {
    const bool same = a.header().phases == b.header().phases && a.header().phase_rows_max == b.header().phase_rows_max;
    if (same && tolerances.exact()) phases_ = a.header().phases;
    chains_say_all_ = same;
  }

  Result<DiffReport> run(const Progress& progress) {
    report_.steps_a = a_.step_count();
    report_.steps_b = b_.step_count();
    report_.steps = std::min(report_.steps_a, report_.steps_b);
    report_.headers = different_headers(a_.header(), b_.header());
    if (Status ok = compare_step(0); !ok.ok()) return ok.error();
    if (report_.first) return std::move(report_);
    const std::uint64_t same = steps_known_same();
    for (std::uint64_t k = same + 1; k <= report_.steps && !report_.first; ++k) {
      if (Status ok = compare_step(k); !ok.ok()) return ok.error();
      if (progress && !progress(k, report_.steps)) break;
    }
    return std::move(report_);
  }

 private:
  /// The last step up to which the chains of both logs agree, found among the steps at which both end a chunk. A chain
  /// never agrees again once it differed, so half of them can be left out at a time.
  [[nodiscard]] std::uint64_t steps_known_same() const {
    if (!chains_say_all_ || a_.header_prelude().chain_after != b_.header_prelude().chain_after) return 0;
    std::vector<std::pair<const ChunkPlace*, const ChunkPlace*>> ends;
    auto at_b = b_.chunks().begin();
    for (const ChunkPlace& place : a_.chunks()) {
      while (at_b != b_.chunks().end() && at_b->end_step() < place.end_step()) ++at_b;
      if (at_b != b_.chunks().end() && at_b->end_step() == place.end_step()) ends.emplace_back(&place, &*at_b);
    }
    const auto differs = std::partition_point(
        ends.begin(), ends.end(), [](const auto& end) { return end.first->chain_after == end.second->chain_after; });
    return differs == ends.begin() ? 0 : std::prev(differs)->first->end_step() - 1;
  }

  Status compare_step(std::uint64_t k) {
    Result<const StepRecord*> a = k == 0 ? a_.read_step(k) : a_.read_hashes(k);
    if (!a.ok()) return a.error();
    Result<const StepRecord*> b = k == 0 ? b_.read_step(k) : b_.read_hashes(k);
    if (!b.ok()) return b.error();
    if (chain_next({}, **a) == chain_next({}, **b) && k > 0) return {};
    return compare_states(k, **a, **b);
  }

  /// A step whose hashes differ, or state 0: looked at with its states.
  Status compare_states(std::uint64_t k, const StepRecord& hashes_a, const StepRecord& hashes_b) {
    const bool both = hashes_a.has_states && hashes_b.has_states;
    if (!both && !tolerances_.exact() && hashes_a.state_hash != hashes_b.state_hash) {
      return bad_input("step " + std::to_string(k) +
                       ": its hashes differ and one log has no states of it, so tolerances cannot be judged; record "
                       "both with --states all");
    }
    StepRecord expected = hashes_a;
    StepRecord actual = hashes_b;
    if (both && k > 0) {
      Result<const StepRecord*> a = a_.read_step(k);
      if (!a.ok()) return a.error();
      Result<const StepRecord*> b = b_.read_step(k);
      if (!b.ok()) return b.error();
      expected = **a;
      actual = **b;
    }
    if (!tolerances_.exact()) tolerate(expected, actual);
    report_.first = first_difference(expected, actual, phases_);
    if (report_.first && k == 0) report_.first->phase = "start";
    return {};
  }

  /// With tolerances only what a body visibly is counts; hashes and counters of two that differ would differ as well.
  void tolerate(const StepRecord& expected, StepRecord& actual) const {
    forgive(expected.states, actual.states, tolerances_);
    actual.counters = expected.counters;
    if (same_bits(expected.states, actual.states)) actual.state_hash = expected.state_hash;
  }

  LogReader& a_;
  LogReader& b_;
  Tolerances tolerances_;
  std::vector<std::string> phases_;
  bool chains_say_all_ = false;
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
