#include "replay/blame/answer_of_write.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "replay/blame/contact_making.h"
#include "src/base/text.h"
#include "src/math/grid.h"

namespace tumble::replay {
namespace {

double part_in(const ContactPart& part, std::size_t field) {
  const std::size_t quantity = quantity_of(field);
  if (quantity == kVelocity) return part.velocity[static_cast<int>(field - kVelocity)];
  if (quantity == kSpin) return part.spin[static_cast<int>(field - kSpin)];
  if (quantity == kPosition) return part.position[static_cast<int>(field - kPosition)];
  return 0;
}

// Phases in which a body flies free, in one piece.
bool flies(const std::string& phase) { return phase == "finish_motion" || phase == "integrate"; }

bool once_a_step(const std::string& phase) {
  return phase == "prepare_manifolds" || phase == "part_overlaps" || phase == "wake_islands" ||
         phase == "bounce_contacts" || phase == "finish_motion" || phase == "update_sleeping";
}

/// Collects the shares of a change.
class Shares {
 public:
  Shares(const BodyAccount& account, const Write& write, std::size_t field)
      : account_(account), write_(write), field_(field) {}

  void add_all() {
    for (const ContactPart& part : write_.parts) add("contact", part_in(part, field_), part.other);
    const std::size_t quantity = quantity_of(field_);
    const double change = write_.after.of(field_) - write_.before.of(field_);
    if (quantity == kVelocity) {
      const int axis = static_cast<int>(field_ - kVelocity);
      if (write_.phase == "apply_forces") add("gravity", sim::VelocityGrid::round(account_.gravity[axis] * substep()));
      if (flies(write_.phase) && account_.air_drag == 0) add("gravity", change);
      if (flies(write_.phase) && account_.air_drag != 0) add("gravity and drag", change);
    }
    if (quantity == kPosition && write_.parts.empty()) add("velocity", change);
    if (quantity == kOrientation) add("spin", change);
    const double left = write_.after.of(field_) - (write_.before.of(field_) + sum());
    exact_ = left == 0;
    if (left != 0 && std::isfinite(left)) add(name_of_rest(), left);
    std::ranges::stable_sort(
        shares, [](const BlameShare& a, const BlameShare& b) { return std::fabs(a.amount) > std::fabs(b.amount); });
  }

  [[nodiscard]] bool exact() const { return exact_; }
  std::vector<BlameShare> shares;

 private:
  [[nodiscard]] double substep() const { return account_.substep_s; }
  [[nodiscard]] double sum() const {
    double sum = 0;
    for (const BlameShare& share : shares) sum += share.amount;
    return sum;
  }
  [[nodiscard]] const char* name_of_rest() const {
    if (write_.phase == "update_sleeping" || write_.phase == "update_freezing") return "put to rest";
    if (write_.phase == "part_overlaps" || write_.phase == "apply_outcomes") return "paid for being lifted";
    if (write_.phase == "prepare_manifolds") return "lent inertia";
    if (write_.phase == "apply_forces" && account_.lent != 0) return "lent inertia";
    return "rest";
  }
  void add(const char* kind, double amount, std::optional<sim::BodyId> other = std::nullopt) {
    if (amount != 0) shares.push_back({kind, other, amount});
  }

  const BodyAccount& account_;
  const Write& write_;
  std::size_t field_;
  bool exact_ = false;
};

std::string share_text(const BlameShare& share, const std::string& unit) {
  const std::string who = share.kind == "contact" ? contact_name(share.other) : share.kind;
  return who + ' ' + (share.amount > 0 ? "+" : "") + rounded(share.amount, unit);
}

std::string text_of(const BlameAnswer& answer, const BodyAccount& account, std::size_t field) {
  if (field == kFrozenField) {
    if (answer.phase == "wake_islands") return "woken with its island, since something is about to touch it";
    const bool froze = answer.after == FieldValue(1.0);
    return froze ? "put to rest: slow for long enough" : "woken";
  }
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(answer.shares.size(), 4); ++k) {
    text += (k == 0 ? "" : ", ") + share_text(answer.shares[k], answer.unit);
  }
  if (answer.shares.size() > 4) text += ", and " + std::to_string(answer.shares.size() - 4) + " more";
  if (account.contacts.empty() && flies(answer.phase)) text += "; the body touched nothing in this step";
  return text;
}

}  // namespace

std::optional<std::size_t> last_change(const BodyAccount& account, std::size_t field, std::size_t end) {
  for (std::size_t k = std::min(end, account.writes.size()); k > 0; --k) {
    const Write& write = account.writes[k - 1];
    if (!same_value(write.before.of(field), write.after.of(field))) return k - 1;
  }
  return std::nullopt;
}

std::optional<std::size_t> largest_change(const BodyAccount& account, std::size_t field) {
  std::optional<std::size_t> found;
  double largest = 0;
  for (std::size_t k = 0; k < account.writes.size(); ++k) {
    const double change = std::fabs(account.writes[k].after.of(field) - account.writes[k].before.of(field));
    if (change == 0 || change < largest) continue;
    largest = change;
    found = k;
  }
  return found;
}

BlameAnswer answer_of(const BodyAccount& account, const Write& write, std::size_t field) {
  BlameAnswer answer;
  answer.step = account.step;
  if (!once_a_step(write.phase)) answer.substep = write.substep;
  answer.phase = write.phase;
  answer.body = account.body;
  answer.value = field_name(field);
  answer.unit = unit_of_field(field);
  answer.before = write.before.of(field);
  answer.after = write.after.of(field);
  if (field != kFrozenField) {
    Shares shares(account, write, field);
    shares.add_all();
    answer.shares = std::move(shares.shares);
    answer.exact = shares.exact();
  }
  answer.text = text_of(answer, account, field);
  return answer;
}

Source source_of(const BodyAccount& account, std::size_t write, std::size_t field) {
  const Write& at = account.writes[write];
  const std::size_t quantity = quantity_of(field);
  if (quantity == kFrozenField) {
    // Who wakes a body is about to touch it; who falls asleep was slow.
    const auto waker = std::ranges::min_element(account.contacts, {}, &ContactFacts::approach);
    if (at.after.of(field) == 0 && waker != account.contacts.end()) return {Source::Kind::kContact, 0, waker->other};
    return {Source::Kind::kValue, largest_of(at.before, kVelocity), {}};
  }
  if (at.phase == "update_sleeping" || at.phase == "update_freezing") return {Source::Kind::kValue, kFrozenField, {}};
  const bool by_motion = quantity == kOrientation || (quantity == kPosition && at.parts.empty());
  if (by_motion) {
    const std::size_t axis = field - kPosition;
    return {Source::Kind::kValue, quantity == kPosition ? kVelocity + axis : largest_of(at.before, kSpin), {}};
  }
  // The contact that did most to this quantity in the step so far: the last sweep may have changed next to nothing.
  std::vector<ContactPart> sums;
  for (std::size_t k = 0; k <= write; ++k) {
    for (const ContactPart& part : account.writes[k].parts) {
      auto same = std::ranges::find(sums, part.other, &ContactPart::other);
      if (same == sums.end()) same = sums.insert(same, ContactPart{part.other});
      ContactPart& sum = *same;
      sum.velocity += part.velocity;
      sum.spin += part.spin;
      sum.position += part.position;
    }
  }
  const auto most =
      std::ranges::max_element(sums, {}, [&](const ContactPart& part) { return std::fabs(part_in(part, field)); });
  if (most != sums.end()) return {Source::Kind::kContact, 0, most->other};
  return {quantity == kVelocity ? Source::Kind::kGravity : Source::Kind::kEnd, 0, {}};
}

}  // namespace tumble::replay
