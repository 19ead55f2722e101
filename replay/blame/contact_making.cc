#include "replay/blame/contact_making.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/base/text.h"
#include "src/kernels/contacts/contact_batch.h"

namespace tumble::replay {
namespace {

std::string normal_text(const sim::Vec3& n) {
  return '(' + significant(n.x(), 4) + ", " + significant(n.y(), 4) + ", " + significant(n.z(), 4) + ')';
}

/// Answers on one contact of an account.
class Making {
 public:
  Making(const BodyAccount& account, const ContactFacts& facts) : account_(account), facts_(facts) {}

  void add(const std::string& phase, const std::string& value, const char* unit, FieldValue after,
           const std::string& text) {
    BlameAnswer answer;
    answer.step = account_.step;
    answer.phase = phase;
    answer.body = account_.body;
    answer.contact = true;
    answer.other = facts_.other;
    answer.value = value;
    answer.unit = unit;
    answer.after = std::move(after);
    answer.text =
        "contact of body " + std::to_string(account_.body) + " with " + contact_name(facts_.other) + ": " + text;
    answers.push_back(std::move(answer));
  }

  std::string found_text() const {
    std::string text = count_text(facts_.points, "point") + ", normal " + normal_text(facts_.normal) + ", " +
                       (facts_.separation < 0 ? rounded(-facts_.separation, "m") + " deep"
                                              : rounded(facts_.separation, "m") + " apart") +
                       ", friction " + significant(facts_.friction, 4) + ", restitution " +
                       significant(facts_.restitution, 4);
    return text;
  }

  std::vector<BlameAnswer> answers;

 private:
  const BodyAccount& account_;
  const ContactFacts& facts_;
};

bool parted(const BodyAccount& account, const std::optional<sim::BodyId>& other) {
  return std::ranges::any_of(account.writes, [&](const Write& write) {
    return write.phase == "part_overlaps" &&
           std::ranges::any_of(write.parts, [&](const ContactPart& part) { return part.other == other; });
  });
}

void near_pairs(const BodyAccount& account, const char* phase, Making& making) {
  making.add(phase, "pair", "", std::uint64_t{account.near.size()},
             "near enough to be tested; body " + std::to_string(account.body) + " is near " +
                 count_text(account.near.size(), "other body"));
}

constexpr double kDeep = 1e-4;  // m; shallower overlaps are touching

void add_fast(const BodyAccount& account, const ContactFacts& facts, Making& making) {
  making.add("find_fast_contacts", "separation", "m", facts.separation,
             "a fast pair, whose contacts are found in every substep: " + making.found_text() + ", meeting at " +
                 rounded(-facts.approach, "m/s"));
  making.add("find_manifolds", "fast", "", std::string("true"), "listed as a fast pair");
  near_pairs(account, "find_near_pairs", making);
}

void add_prepared(const BodyAccount& account, const ContactFacts& facts, Making& making) {
  std::string text =
      facts.approach < 0 ? "the bodies meet at " + rounded(-facts.approach, "m/s") : "the bodies part or rest";
  if (facts.split > 1) {
    text += "; " + significant(facts.split, 4) + " contacts of its layer share the mass of body " +
            std::to_string(account.body);
  }
  making.add("prepare_manifolds", "approach", "m/s", facts.approach, text);
}

void add_weight(const BodyAccount& account, const ContactFacts& facts, Making& making) {
  if (facts.load == 0 && account.lent == 0 && facts.started == 0) return;
  std::string text = "bears " + rounded(facts.load, "N s") + " a substep at rest";
  if (facts.started != 0) text += ", and being new starts from " + rounded(facts.started, "N s");
  if (account.lent != 0) text += "; body " + std::to_string(account.body) + " is lent " + rounded(account.lent, "kg");
  making.add("carry_weights", "load", "N s", facts.load, text);
}

// Contacts that rest are made by the weight that they bear, contacts that meet by their masses and speed. What happens
// to few contacts stands first.
void layered(const BodyAccount& account, const ContactFacts& facts, Making& making) {
  if (facts.fast) return add_fast(account, facts, making);
  if (facts.asleep) {
    making.add(facts.found_by, "asleep", "", std::string("true"),
               "both rest, so it is kept with " + rounded(facts.recalled, "N s") + " and not solved");
    return near_pairs(account, "find_near_pairs", making);
  }
  if (facts.woke) making.add("wake_islands", "woken", "", std::string("true"), "woken in this step");
  if (parted(account, facts.other) || facts.separation < -kDeep) {
    making.add("part_overlaps", "separation", "m", facts.separation,
               parted(account, facts.other) ? "overlapped and was parted in this step"
                                            : "overlaps, and was not parted in this step");
  }
  const bool rests = facts.approach >= -sim::kRestingSpeed;
  if (!rests) add_prepared(account, facts, making);
  add_weight(account, facts, making);
  making.add(facts.found_by, "separation", "m", facts.separation,
             (facts.recalled > 0 ? "found again with " + rounded(facts.recalled, "N s") + " of the step before: "
                                 : std::string("found without an impulse of the step before: ")) +
                 making.found_text());
  const auto add_sweeps = [&] {
    making.add("assign_levels", "sweeps", "", static_cast<std::uint64_t>(facts.sweeps),
               (facts.hard ? "its island is hard (a bar, or bodies of very different masses) and is"
                           : std::string("its island is")) +
                   " swept " + count_text(static_cast<std::uint64_t>(facts.sweeps), "time"));
  };
  if (facts.hard) add_sweeps();
  if (rests) add_prepared(account, facts, making);
  if (!facts.hard) add_sweeps();
  near_pairs(account, "find_near_pairs", making);
}

void thesis(const BodyAccount& account, const ContactFacts& facts, bool of_place, Making& making) {
  if (of_place) {
    making.add("compute_separation", "separation", "m", facts.separation,
               "the bodies are moved apart by " + rounded(facts.depth, "m"));
  }
  if (!of_place || facts.rests) {
    making.add("compute_impulses", "approach", "m/s", facts.approach,
               "the bodies " + std::string(facts.approach < 0 ? "meet at " : "part at ") +
                   rounded(std::fabs(facts.approach), "m/s") + "; each collision meets one of " +
                   significant(facts.split, 4) + " parts of body " + std::to_string(account.body));
  }
  making.add("find_contacts", "separation", "m", facts.separation, making.found_text());
  making.add("find_planes", "planes", "", std::string("none"), "no plane separates the two");
  near_pairs(account, "find_pairs", making);
}

}  // namespace

std::string contact_name(const std::optional<sim::BodyId>& other) {
  return other ? "body " + std::to_string(*other) : "the ground";
}

std::vector<BlameAnswer> making_of(const BodyAccount& account, const ContactFacts& facts, std::size_t field,
                                   sim::Method method) {
  Making making(account, facts);
  if (method == sim::Method::kThesis) {
    thesis(account, facts, quantity_of(field) == kPosition, making);
  } else {
    layered(account, facts, making);
  }
  return std::move(making.answers);
}

std::vector<BlameAnswer> absence_of(const BodyAccount& account, sim::Method method) {
  const bool is_thesis = method == sim::Method::kThesis;
  std::string near;
  for (std::size_t k = 0; k < std::min<std::size_t>(account.near.size(), 4); ++k) {
    near += (near.empty() ? "" : ", ") + std::to_string(account.near[k]);
  }
  const auto answer = [&](const char* phase, const char* value, FieldValue after, const std::string& text) {
    BlameAnswer one;
    one.step = account.step;
    one.phase = phase;
    one.body = account.body;
    one.value = value;
    one.after = std::move(after);
    one.text = text;
    return one;
  };
  const std::string body = "body " + std::to_string(account.body);
  std::vector<BlameAnswer> answers;
  if (account.remembered || !account.near.empty()) {
    answers.push_back(answer(is_thesis ? "find_planes" : "find_manifolds", "contacts", std::uint64_t{0},
                             "found no contact of " + body +
                                 (account.remembered ? ", which had one in the step before" : "") +
                                 (near.empty() ? "" : "; near it: " + near)));
  }
  answers.push_back(answer(is_thesis ? "find_pairs" : "find_near_pairs", "pairs", std::uint64_t{account.near.size()},
                           body + " is near " + count_text(account.near.size(), "other body")));
  return answers;
}

std::vector<BlameAnswer> broken_rules_of(const BodyAccount& account) {
  std::vector<BlameAnswer> answers;
  for (const BrokenRule& rule : account.broken) {
    const auto same = [&](const BrokenRule& other) { return other.phase == rule.phase && other.value == rule.value; };
    if (&*std::ranges::find_if(account.broken, same) != &rule) continue;
    const auto more = static_cast<std::uint64_t>(std::ranges::count_if(account.broken, same) - 1);
    BlameAnswer answer;
    answer.step = rule.step_before ? account.step - 1 : account.step;
    if (!rule.step_before) answer.substep = rule.substep;
    answer.phase = rule.phase;
    // From the side of the body asked about, where it is one of the two.
    const bool other_way = rule.other == account.body;
    answer.body = other_way ? account.body : rule.body;
    answer.contact = true;
    answer.other = other_way ? rule.body : rule.other;
    answer.value = rule.value;
    answer.unit = rule.unit;
    answer.after = rule.found;
    answer.text = "breaks a rule of this phase: contact of body " + std::to_string(*answer.body) + " with " +
                  contact_name(answer.other) + ": " + rule.text +
                  (more > 0 ? "; so do " + count_text(more, "other contact") : std::string());
    answers.push_back(std::move(answer));
  }
  return answers;
}

BlameAnswer rest_of(const BodyAccount& account, sim::Method method) {
  BlameAnswer answer;
  answer.step = account.step;
  answer.phase = method == sim::Method::kThesis ? "update_freezing" : "wake_islands";
  answer.body = account.body;
  answer.value = "frozen";
  answer.before = answer.after = 1.0;
  answer.text = "the body is at rest, and nothing in this step woke it";
  if (!account.contacts.empty()) {
    answer.text += "; it touches " + contact_name(account.contacts.front().other);
    if (account.contacts.size() > 1) answer.text += " and " + count_text(account.contacts.size() - 1, "other");
  }
  return answer;
}

}  // namespace tumble::replay
