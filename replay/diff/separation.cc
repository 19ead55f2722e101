#include "replay/diff/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "replay/format/little_endian.h"
#include "replay/format/not_finite.h"
#include "replay/log/session_clock.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/divergence.h"
#include "tumble/sim/vec.h"

namespace tumble::replay {
namespace {

constexpr double kSquareVanishes = 1e-140;  // m

/// Whether both have the same points of a pair, and at least one, in whatever order.
bool same_points(const std::vector<EngineContact>& a, const std::vector<EngineContact>& b,
                 const std::pair<sim::BodyId, sim::BodyId>& pair) {
  const auto points_in = [&](const std::vector<EngineContact>& all) {
    std::vector<std::vector<std::uint64_t>> points;
    for (const EngineContact& contact : all) {
      if (std::pair(contact.a, contact.b) != pair) continue;
      std::vector<std::uint64_t>& bits = points.emplace_back();
      for (const double number : numbers_of(contact)) bits.push_back(bits_of(number));
    }
    std::ranges::sort(points);
    return points;
  };
  const auto points = points_in(a);
  return !points.empty() && points == points_in(b);
}

/// The error for two steps of which states and hashes contradict each other: equal hashes with unequal states, or the
/// reverse. Blames the log whose states do not match its own hash.
Error broken(const std::string& a, const StepRecord& in_a, const std::string& b, const StepRecord& in_b) {
  const auto lies = [](const StepRecord& record) { return state_hash(record.states) != record.state_hash; };
  const std::string step = "step " + std::to_string(in_a.step);
  if (lies(in_a) || lies(in_b)) {
    return damaged((lies(in_a) ? a : b) + ": the log is broken: the states of " + step +
                   " do not match their state hash; do not trust what diff says of it");
  }
  return damaged(a + " and " + b + ": " + step + ": the states do not match their hashes");
}

/// The length of a vector, also where its square overflows or vanishes.
double distance_of(const sim::Vec3& apart) {
  const double plain = sim::length(apart), largest = apart.cwiseAbs().maxCoeff();
  const bool is_plain = std::isfinite(plain) && plain >= kSquareVanishes;
  return is_plain || largest == 0 || !std::isfinite(largest) ? plain : largest * sim::length(apart / largest);
}

/// Follows two sessions through the steps after their first difference. Keeps one row a step and the first step of each
/// event (a mark exceeded, other contacts, other freezing, other bodies), so memory grows with steps and not with
/// bodies.
class SeparationMeter {
 public:
  SeparationMeter(const SessionSteps& a, const SessionSteps& b, const ChannelMatch* channels) : a_(a), b_(b) {
    if (channels == nullptr) return;
    separation_.compares_contacts = channels->contacts;
    for (const SharedChannel& channel : channels->compared) {
      ChannelSeparation& apart = channels_.emplace_back(channel, ChannelSeparation()).second;
      apart.name = channel.name;
      apart.unit = channel.unit;
      apart.is_number = is_number(channel.type.kind);
    }
  }

  Result<Separation> run(std::uint64_t from, std::uint64_t last, const Progress& progress) {
    SIM_CHECK(from <= last, from, last);  // a result has at least one row
    for (std::uint64_t k = from; k <= last; ++k) {
      Result<const StepRecord*> in_a = a_.read(k);
      if (!in_a.ok()) return in_a.error();
      Result<const StepRecord*> in_b = b_.read(k);
      if (!in_b.ok()) return in_b.error();
      if (Status ok = add(k, **in_a, **in_b); !ok.ok()) return ok.error();
      if (progress && !progress(k - from, last - from)) return cannot_finish("interrupted");
    }
    for (auto& [channel, apart] : channels_) {
      if (apart.largest > 0) separation_.channels.push_back(std::move(apart));
    }
    std::ranges::sort(separation_.channels, natural_less, &ChannelSeparation::name);
    return std::move(separation_);
  }

 private:
  Status add(std::uint64_t k, const StepRecord& in_a, const StepRecord& in_b) {
    row_ = {};
    row_.step = k;
    const std::array<const std::uint32_t sim::StepCounters::*, 3> counts = {
        &sim::StepCounters::pairs, &sim::StepCounters::contacts, &sim::StepCounters::substeps};
    for (const auto count : counts) {
      if (separation_.compares_contacts && in_a.counters.*count != in_b.counters.*count)
        note(separation_.contacts_from);
    }
    if (separation_.compares_contacts) compare(in_a.extras.contacts, in_b.extras.contacts);
    for (const StepRecord* record : {&in_a, &in_b}) {
      const bool had_any = record->counters.pairs > 0 || record->counters.contacts > 0;
      const bool told = separation_.compares_contacts && !record->extras.contacts.empty();
      separation_.had_contacts = separation_.had_contacts || had_any || told;
      separation_.contacts_by_value = separation_.contacts_by_value || told;
    }
    compare(in_a.states, in_b.states);
    compare_clocks(in_a.dt, in_b.dt);
    // States and hashes are stored apart, so a log can lie in one of them. Equal states need equal hashes, and the
    // reverse.
    if ((row_.bodies == 0) != (in_a.state_hash == in_b.state_hash)) return broken(a_.name, in_a, b_.name, in_b);
    mark();
    for (auto& [channel, apart] : channels_) {
      const double distance = channel_distance(channel, in_a, in_b);
      apart.distance.push_back(distance);
      if (distance > 0 && apart.largest == 0) apart.from = k;
      if (!(distance > apart.largest)) continue;
      apart.largest = distance;
      apart.largest_step = k;
    }
    separation_.rows.push_back(row_);
    return {};
  }

  void compare(const std::vector<EngineContact>& a, const std::vector<EngineContact>& b) {
    if (separation_.contacts_from && *separation_.contacts_from != row_.step) return;
    const std::optional<Divergence> found = contact_difference(a, b);
    if (!found) return;
    note(separation_.contacts_from);
    SIM_CHECK(found->pair, row_.step);
    // Without the axis of a vector, whose name is the engine's.
    const std::string field = found->field.substr(found->field.find('.') + 1);
    std::string words = found->note.empty() ? field.substr(0, field.find('.')) : found->note;
    if (same_points(a, b, *found->pair)) words = "the same points in another order";
    separation_.first_contact = {*found->pair, std::move(words)};
  }

  /// dt of a step in each session, s.
  void compare_clocks(double in_a, double in_b) {
    clock_a_.add_step(in_a);
    clock_b_.add_step(in_b);
    if (in_a != in_b && !separation_.clocks) separation_.clocks = ClockSeparation{row_.step, 0, row_.step};
    const double apart = std::fabs(clock_a_.now() - clock_b_.now());
    if (!separation_.clocks || !(apart > separation_.clocks->largest)) return;
    separation_.clocks->largest = apart;
    separation_.clocks->largest_step = row_.step;
  }

  /// Walks both states by ascending id, as two sorted lists are merged.
  void compare(const BodyStates& a, const BodyStates& b) {
    const ConstColumns in_a = columns_of(a), in_b = columns_of(b);
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
      const bool in_both = i < a.size() && j < b.size() && a.id[i] == b.id[j];
      if (!in_both) {
        const bool only_a = j == b.size() || (i < a.size() && a.id[i] < b.id[j]);
        ++(only_a ? i : j);
        ++(only_a ? row_.only_in_a : row_.only_in_b);
        ++row_.bodies;
        note(separation_.bodies_from);
        continue;
      }
      const bool same_frozen = a.frozen[i] == b.frozen[j];
      separation_.had_frozen = separation_.had_frozen || a.frozen[i] != 0 || b.frozen[j] != 0;
      if (!same_frozen) note(separation_.freezing_from);
      const bool same = same_frozen && same_columns(in_a, i, in_b, j);
      if (!same) {
        const bool lost = lose(a, i, true) || lose(b, j, false);
        differs(a.id[i], lost ? std::numeric_limits<double>::infinity() : distance_of(a.position[i] - b.position[j]));
      }
      ++i;
      ++j;
    }
  }

  /// Whether a body has a value that is no finite number; notes the first.
  bool lose(const BodyStates& states, std::size_t i, bool in_a) {
    const std::optional<NotFinite> found = not_finite(states, i, row_.step);
    if (found && !separation_.lost) separation_.lost = LostBody{found->step, found->body, found->field, in_a};
    return found.has_value();
  }

  void differs(sim::BodyId id, double distance) {
    ++row_.bodies;
    if (!(distance > row_.separation)) return;
    row_.separation = distance;
    row_.body = id;
  }

  /// A separation that jumps over several marks in one step passes all of them there.
  void mark() {
    while (next_mark_ < kSeparationMarks.size() && row_.separation > kSeparationMarks[next_mark_]) {
      separation_.marks.push_back({kSeparationMarks[next_mark_++], row_.step, row_.body.value_or(0)});
    }
    if (row_.separation > separation_.largest.separation || separation_.rows.empty()) separation_.largest = row_;
  }

  void note(std::optional<std::uint64_t>& first) const {
    if (!first) first = row_.step;
  }

  const SessionSteps& a_;
  const SessionSteps& b_;
  std::vector<std::pair<SharedChannel, ChannelSeparation>> channels_;
  SessionClock clock_a_, clock_b_;
  SeparationRow row_;
  std::size_t next_mark_ = 0;
  Separation separation_;
};

}  // namespace

Result<Separation> measure_separation(const SessionSteps& a, const SessionSteps& b, std::uint64_t from,
                                      std::uint64_t last, const Progress& progress, const ChannelMatch* channels) {
  return SeparationMeter(a, b, channels).run(from, last, progress);
}

}  // namespace tumble::replay
