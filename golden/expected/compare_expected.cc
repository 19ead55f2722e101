#include "tumble/golden/compare_expected.h"

#include <algorithm>
#include <cmath>

#include "replay/diff/difference_report.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/tolerance.h"

namespace tumble::golden {
namespace {

constexpr double kTrackGrain = 0.001;  // m: rounding alone can make half of this a difference

std::string number(std::uint64_t value) { return std::to_string(value); }

std::string length_text(double metres) { return significant(metres, 3) + " m"; }

/// The entry of a step in a list that ascends, or null.
template <class T>
const T* at_step(const std::vector<T>& list, std::uint64_t step) {
  const auto found = std::ranges::lower_bound(list, step, {}, &T::step);
  return found != list.end() && found->step == step ? &*found : nullptr;
}

/// Counts the bodies that differ between two lists, and names the first.
std::string different_bodies(const BodyHashes& expected, const BodyHashes& actual, const replay::BodyTable& names) {
  std::size_t count = 0;
  sim::BodyId first = 0;
  std::size_t a = 0;
  std::size_t b = 0;
  std::size_t total = 0;  // of both sides
  while (a < expected.id.size() || b < actual.id.size()) {
    const sim::BodyId id_a = a < expected.id.size() ? expected.id[a] : ~sim::BodyId{0};
    const sim::BodyId id_b = b < actual.id.size() ? actual.id[b] : ~sim::BodyId{0};
    ++total;
    const bool same = id_a == id_b && expected.hash[a] == actual.hash[b];
    if (!same && count++ == 0) first = std::min(id_a, id_b);
    if (id_a <= id_b) ++a;
    if (id_b <= id_a) ++b;
  }
  if (count == 0) return "";
  return "at step " + number(actual.step) + ", " + number(count) + " of " + count_text(total, "body") +
         (count == 1 ? " differs" : " differ") + ", the first is " + names.text(first);
}

/// Whether the difference is one of channels or contacts.
bool is_extra(const FirstDifference& difference) {
  return difference.phase.starts_with("channel.") || difference.phase == "contacts";
}

constexpr std::size_t kExtrasNamed = 4;
constexpr std::size_t kSetupShown = 3;  // in a sentence; the details have all

}  // namespace

std::string describe(const Apart& apart, const replay::BodyTable& names) {
  const std::string where = " (" + names.text(apart.body) + ", step " + number(apart.step) + ")";
  return (std::isfinite(apart.metres) ? length_text(apart.metres) + " apart" : "not a number") + where;
}

std::string describe(const FirstDifference& difference) {
  if (difference.phase == kSetup) {
    std::string text = "the engine was told otherwise";
    for (std::size_t k = 0; k < std::min(difference.details.size(), kSetupShown); ++k) {
      text += (k == 0 ? ": " : "; ") + difference.details[k];
    }
    return text + (difference.states_from ? "; states differ from step " + number(*difference.states_from)
                                          : "; all states agree");
  }
  std::string text = "step " + number(difference.step);
  if (difference.phase.starts_with("before step")) text = difference.phase;
  if (difference.substep) text += ", substep " + number(*difference.substep);
  if (!difference.phase.starts_with("before step")) text += ", phase " + difference.phase;
  if (is_extra(difference)) text = "step " + number(difference.step) + ", " + difference.phase;
  if (!difference.states_from && is_extra(difference)) return text + "; all states agree";
  if (!difference.states_from) return text + "; all states agree, but not the steps between them";
  if (*difference.states_from != difference.step)
    text += "; states differ from step " + number(*difference.states_from);
  return text;
}

ExpectedComparer::ExpectedComparer(const Expected& expected, const replay::LogHeader& header)
    : expected_(expected),
      same_phases_(expected.phases == header.phases && expected.method == header.method),
      same_words_(same_phases_ && expected.phase_hash_version == header.phase_hash_version),
      in_binary32_(replay::in_binary32(header, header)),
      axes_(replay::common_axes(header, header)),
      shapes_(header) {
  if (expected.method != header.method || expected.method_version != header.method_version) {
    notes_.push_back("blessed with method " + expected.method + " version " + number(expected.method_version) +
                     ", run with " + header.method + " version " + number(header.method_version));
  }
  if (expected.extras) {
    extras_.emplace(*expected.extras, header.declared.channels);
  } else if (!header.declared.channels.empty()) {
    notes_.emplace_back(
        "blessed before goldens kept channels: a channel that differs is seen, but not named, and not "
        "in the state of step 0; bless the case to have them compared");
  }
  if (header.engine && !expected.shapes) {
    notes_.emplace_back(
        "blessed before goldens kept shapes: a body of another shape is not seen; bless the case to have them "
        "compared");
  }
  if (header.engine && expected.setup) setup_ = setup_differences(expected.setup->header, header);
  if (header.engine && !expected.setup) {
    notes_.emplace_back(
        "blessed before goldens kept what an engine is told (gravity, ground, masses, materials, names, precision): "
        "a change of these is not seen; bless the case to have them compared");
    setup_ = phase_differences(expected.phases, header.phases);
  }
  if (!same_phases_ && !header.engine)
    notes_.emplace_back("the phases have other names than when it was blessed: only states compare");
}

/// What was done before the step may be why it differs, and says more than its phase.
void ExpectedComparer::note_told(const replay::StepRecord& record) {
  if (first_ && first_->step == record.step && expected_.setup) {
    first_->told = step_difference(*expected_.setup, record, shapes_.names());
  }
}

void ExpectedComparer::note_first(std::uint64_t step, const std::string& phase, std::optional<std::uint32_t> substep) {
  if (!first_)
    first_ = FirstDifference{
        .step = step, .substep = substep, .phase = phase, .told = {}, .states_from = {}, .details = {}, .apart = {}};
}

void ExpectedComparer::add(const replay::StepRecord& record) {
  SIM_CHECK(record.step == next_step_, record.step, next_step_);
  ++next_step_;
  steps_ = record.step;
  if (record.step >= expected_.state_hashes.size()) {
    note_first(record.step, "step");
    return;
  }
  const bool same_state = record.state_hash == expected_.state_hashes[record.step];
  if (record.step > 0 && same_words_) compare_words(record);
  if (!same_state) {
    note_first(record.step, record.step == 0 ? "start" : "step");
    if (!first_->states_from) first_->states_from = record.step;
  }
  shapes_.add(record);  // names the bodies that appear in this step
  if (extras_) compare_extras(record);
  note_told(record);
  if (first_ && first_->states_from) look_closer(record);
  follow_state(record);
  follow_track(record);
}

/// A channel that differs is named with its values at this step, or at the next one whose values the golden keeps.
void ExpectedComparer::compare_extras(const replay::StepRecord& record) {
  if (!extra_details_.empty()) return;
  const std::vector<std::string> fields = extras_->differing(record);
  if (fields.empty()) return;
  if (extra_fields_.empty()) {
    extra_fields_ = fields;
    extra_step_ = record.step;
  }
  note_first(record.step, extra_fields_.front());
  for (const std::string& field : fields) {
    if (extra_details_.size() == kExtrasNamed) break;
    if (std::string text = extras_->detail(field, record, shapes_.names()); !text.empty())
      extra_details_.push_back(std::move(text));
  }
}

std::vector<std::string> ExpectedComparer::lost_channels() const {
  return extras_ ? extras_->lost() : std::vector<std::string>();
}

std::vector<std::string> ExpectedComparer::other_shapes() const { return golden::other_shapes(expected_, shapes_); }

std::vector<std::string> ExpectedComparer::extras() const {
  std::vector<std::string> parts = extras_ ? extras_->compared() : std::vector<std::string>();
  if (expected_.shapes) parts.emplace_back("shapes of bodies");
  if (expected_.setup) parts.emplace_back("gravity, ground, masses, materials and names");
  return parts;
}

/// Finds the first phase word that differs. A golden keeps 16 bits of each phase hash, so that about one difference in
/// 65,536 escapes at its phase; the 32 bits of the whole step, which also cover inputs and counters, and the full state
/// hash show it then. A difference is never missed for the sake of size, only named less exactly.
void ExpectedComparer::compare_words(const replay::StepRecord& record) {
  if (first_ || step_word(record, !extras_) == expected_.step_words[record.step - 1]) return;
  const std::size_t phases = expected_.phases.size();
  const std::vector<std::uint16_t> actual = phase_words_of(record, phases, expected_.phase_detail);
  const std::vector<std::uint16_t>& wanted = expected_.phase_words[record.step - 1];
  const std::size_t shorter = std::min(actual.size(), wanted.size());
  std::size_t word = 0;
  while (word < shorter && actual[word] == wanted[word]) ++word;
  if (word == shorter && actual.size() == wanted.size()) {
    if (record.state_hash != expected_.state_hashes[record.step]) return;
    note_first(record.step, "inputs or counters");
    return;
  }
  std::optional<std::uint32_t> substep;
  if (expected_.phase_detail == PhaseDetail::kSubstep) substep = static_cast<std::uint32_t>(word / phases);
  note_first(record.step, expected_.phases[word % phases], substep);
}

/// Compares bodies and fields at the nearest steps for which the golden holds them.
void ExpectedComparer::look_closer(const replay::StepRecord& record) {
  if (bodies_detail_.empty()) {
    if (const BodyHashes* wanted = at_step(expected_.body_hashes, record.step)) {
      bodies_detail_ = different_bodies(*wanted, hash_bodies(record.step, record.states), shapes_.names());
    }
  }
  if (!field_detail_.empty()) return;
  const KeyState* wanted = at_step(expected_.states, record.step);
  if (wanted == nullptr) return;
  std::optional<replay::Divergence> divergence = replay::first_difference(wanted->states, record.states);
  if (!divergence) return;
  if (in_binary32_) count_in_binary32(*divergence);
  divergence = in_axes(axes_, *std::move(divergence));
  std::string size = replay::magnitude(*divergence);  // comes first: how much says more than how many ULPs
  if (!size.empty()) size.insert(0, ", ");
  if (is_body_missing(*divergence)) {
    const bool is_gone = std::holds_alternative<std::monostate>(divergence->actual);
    field_detail_ = "at step " + number(record.step) + ", " + shapes_.names().text(*divergence->body) +
                    (is_gone ? " is in the golden and not there" : " is there and not in the golden");
    return;
  }
  const std::string body = divergence->body ? shapes_.names().text(*divergence->body) + ", " : "";
  field_detail_ = "at step " + number(record.step) + ", " + body + divergence->field + size + ": expected " +
                  replay::to_string(divergence->expected) + ", actual " + replay::to_string(divergence->actual);
  if (divergence->ulps) field_detail_ += " (" + count_text(*divergence->ulps, "ULP") + " apart)";
}

void ExpectedComparer::note_apart(double metres, std::uint64_t step, sim::BodyId body) {
  const double known = std::isnan(metres) ? INFINITY : metres;  // no number is further away than any
  if (known > apart_.metres) apart_ = {known, step, body};
}

/// The full states that a golden keeps tell the size of a difference below the millimetres of the track.
void ExpectedComparer::follow_state(const replay::StepRecord& record) {
  const KeyState* wanted = first_ ? at_step(expected_.states, record.step) : nullptr;
  if (wanted == nullptr) return;
  const replay::BodyStates& states = record.states;
  std::size_t row = 0;
  for (std::size_t i = 0; i < wanted->states.size(); ++i) {
    const sim::BodyId id = wanted->states.id[i];
    while (row < states.size() && states.id[row] < id) ++row;
    if (row == states.size() || states.id[row] != id) continue;
    note_apart(sim::length(states.position[row] - wanted->states.position[i]), record.step, id);
  }
}

/// Positions are kept to the millimetre and decide nothing: the track tells a person whether a difference of bits has
/// grown into one of metres.
void ExpectedComparer::follow_track(const replay::StepRecord& record) {
  const TrackPoint* point = at_step(expected_.track, record.step);
  if (point == nullptr) return;
  const replay::BodyStates& states = record.states;
  std::size_t row = 0;
  for (std::size_t i = 0; i < point->id.size(); ++i) {
    while (row < states.size() && states.id[row] < point->id[i]) ++row;
    if (row == states.size() || states.id[row] != point->id[i]) continue;
    const double dx = states.position.x[row] - point->x[i] / 1000.0;
    const double dy = states.position.y[row] - point->y[i] / 1000.0;
    const double dz = states.position.z[row] - point->z[i] / 1000.0;
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    if (!(distance <= 2 * kTrackGrain)) note_apart(distance, record.step, point->id[i]);
  }
}

std::optional<FirstDifference> ExpectedComparer::finish(const Hash128& continuation) {
  if (steps_ != expected_.steps()) {
    note_first(std::min(steps_, expected_.steps()) + 1, "step");
    first_->details.push_back("expected " + number(expected_.steps()) + " steps, found " + number(steps_));
    if (!first_->states_from) first_->states_from = first_->step;
  }
  const bool known = continuation != Hash128{} && expected_.continuation != Hash128{} && same_phases_;
  if (known && continuation != expected_.continuation) note_first(steps_, "hidden state");
  if (!first_ && !setup_.empty()) note_first(0, kSetup);
  if (!first_) return std::nullopt;
  if (!first_->told.empty()) first_->details.push_back(first_->told);
  first_->details.insert(first_->details.end(), setup_.begin(), setup_.end());
  for (const std::string& detail : {bodies_detail_, field_detail_}) {
    if (!detail.empty()) first_->details.push_back(detail);
  }
  if (extra_fields_.size() > 1 || (!extra_fields_.empty() && !is_extra(*first_))) {
    std::string text = "channels and contacts that differ in step " + number(extra_step_) + ": ";
    for (std::size_t i = 0; i < extra_fields_.size(); ++i) text += (i == 0 ? "" : ", ") + extra_fields_[i];
    first_->details.push_back(std::move(text));
  }
  first_->details.insert(first_->details.end(), extra_details_.begin(), extra_details_.end());
  if (apart_.metres > 0) {
    first_->apart = apart_;
    first_->details.insert(first_->details.begin(), "largest distance from an expected position: " +
                                                        describe(apart_, shapes_.names()) + ", of the steps kept");
  }
  return first_;
}

}  // namespace tumble::golden
