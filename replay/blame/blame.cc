#include "replay/blame/blame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "replay/blame/answer_of_write.h"
#include "replay/blame/contact_making.h"
#include "replay/blame/origin.h"
#include "replay/blame/question.h"
#include "replay/blame/steps_again.h"
#include "replay/blame/value_history.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kEndOfStep = std::numeric_limits<std::size_t>::max();

/// A value that the chain asks about next.
struct Cursor {
  std::uint64_t step = 0;
  sim::BodyId body = 0;
  std::size_t field = 0;
  std::size_t before_write = kEndOfStep;  ///< in the account of the step
  bool began = false;                     ///< where the greater part of the value came from, not its last change

  [[nodiscard]] ValueOfBody value() const { return {body, field}; }
};

/// Follows one value back.
class Chain {
 public:
  Chain(LogReader& log, const BlameQuestion& question, const Progress& progress)
      : steps_(log, progress ? watched(progress) : progress),
        question_(question),
        method_(log.header().scene.world.method) {}

  Result<Blame> run() {
    if (question_.field.empty()) {
      if (const Result<BodyMotion> body = body_asked(steps_, question_.body, question_.step); !body.ok()) {
        return body.error();
      }
      const Result<std::string> chosen = field_changed_most(steps_, question_.body, question_.step);
      if (!chosen.ok()) return chosen.error();
      question_.field = *chosen;
    }
    blame_.question = question_;
    const std::size_t field = field_of(question_.field);
    const Result<double> value = value_asked(steps_, question_);
    if (!value.ok()) return value.error();
    blame_.value = *value;
    blame_.unit = unit_of_field(field);
    const LogCondition& condition = log().condition();
    if (!condition.whole())
      blame_.notes.push_back(log().name() + " is not whole: " + condition.summary(log().last_step()));
    Cursor cursor{question_.step, question_.body, field};
    while (wants_more()) {
      Result<std::optional<Cursor>> next = explain(cursor);
      if (!next.ok()) {
        // What was found stands; only the first answer must not fail.
        if (blame_.answers.empty() || stopped_) return next.error();
        blame_.ends = next.error().message;
        blame_.damaged = next.error().kind == ErrorKind::kDamaged;
        return blame_;
      }
      if (!*next) break;
      cursor = **next;
    }
    if (blame_.ends.empty()) blame_.ends = wants_more() ? "" : "as many answers as were asked for";
    return blame_;
  }

 private:
  LogReader& log() { return steps_.log(); }
  /// An interruption is no end of the chain.
  Progress watched(const Progress& progress) {
    return [this, progress](std::uint64_t done, std::uint64_t all) {
      stopped_ = !progress(done, all);
      return !stopped_;
    };
  }
  [[nodiscard]] bool wants_more() const { return blame_.answers.size() < question_.answers; }
  static Result<std::optional<Cursor>> ended(const Status& ok) {
    return ok.ok() ? Result<std::optional<Cursor>>(std::optional<Cursor>()) : ok.error();
  }

  Result<const BodyAccount*> account(std::uint64_t k, sim::BodyId body) {
    const auto key = std::pair(k, body);
    if (const auto found = accounts_.find(key); found != accounts_.end()) return &found->second;
    Result<BodyAccount> taken = steps_.account(k, body);
    if (!taken.ok()) return taken.error();
    return &accounts_.emplace(key, *std::move(taken)).first->second;
  }

  /// Adds the answer or answers to a cursor; the next one, or none where the chain ends.
  Result<std::optional<Cursor>> explain(const Cursor& cursor) {
    Cursor at = cursor;
    if (cursor.began && at.step > log().first_state()) {
      const Result<StepFound> found = step_it_began(steps_, at.step, at.body, at.field);
      if (!found.ok()) return found.error();
      at.step = found->step;
    }
    if (at.step == log().first_state()) return ended(end_at_start(steps_, at.step, at.value(), blame_));
    if (Status held = steps_.has_step(at.step); !held.ok()) {
      return ended(end_at_lost_step(steps_, at.step, at.value(), held.error(), blame_));
    }
    Result<const BodyAccount*> found = account(at.step, at.body);
    if (!found.ok()) return found.error();
    const BodyAccount& own = **found;
    const auto write = cursor.began ? largest_change(own, at.field) : last_change(own, at.field, at.before_write);
    if (!write) return explain_before(at, own);
    if (!cursor.began) return explain_write(at, own, *write);
    const Result<std::optional<BodyMotion>> before = steps_.after(at.step - 1, at.body);
    if (!before.ok()) return before.error();
    const double then = before->has_value() ? (*before)->of(at.field) : 0, by_inputs = own.start.of(at.field) - then;
    const double by_phase = own.writes[*write].after.of(at.field) - own.writes[*write].before.of(at.field);
    return std::fabs(by_inputs) > std::fabs(by_phase) ? explain_before(at, own) : explain_write(at, own, *write);
  }

  Result<std::optional<Cursor>> explain_write(const Cursor& at, const BodyAccount& own, std::size_t write) {
    blame_.answers.push_back(answer_of(own, own.writes[write], at.field));
    const Source source = source_of(own, write, at.field);
    const bool in_question = at.step == question_.step;
    if (in_question) add_broken_rules(own);
    const bool changes_rest = in_question && at.field != kFrozenField && own.start.frozen() != own.end.frozen() &&
                              source.kind != Source::Kind::kValue;
    if (changes_rest) add_rest_change(own);
    switch (source.kind) {
      case Source::Kind::kValue:
        return std::optional(Cursor{at.step, at.body, source.field, write_before(write, source.field)});
      case Source::Kind::kContact: {
        const ContactFacts* facts = own.contact_with(source.other);
        if (in_question && facts != nullptr) add(making_of(own, *facts, at.field, method_));
        return motion_behind(own, source.other, at);
      }
      case Source::Kind::kGravity:
        return explain_fall(at, own);
      case Source::Kind::kEnd:
        break;
    }
    blame_.ends = "the phase has one cause";
    return std::optional<Cursor>();
  }

  /// Gravity without a contact that took part: what found none, then the value with which the fall began.
  Result<std::optional<Cursor>> explain_fall(const Cursor& at, const BodyAccount& own) {
    const std::size_t answer = blame_.answers.size() - 1;
    if (at.step == question_.step && own.contacts.empty()) {
      add(absence_of(own, method_));
    } else if (at.step == question_.step) {
      add(making_of(own, *std::ranges::min_element(own.contacts, {}, &ContactFacts::approach), at.field, method_));
    }
    const double fall = own.gravity[static_cast<int>(at.field - kVelocity)] * own.dt;
    const Result<StepFound> found = step_before_fall(steps_, at.step, at.body, at.field, fall);
    if (!found.ok()) return found.error();
    const std::uint64_t step = found->step;
    if (step < at.step) {
      const std::string since = std::to_string(step + 1);
      blame_.answers[answer].text +=
          found->lost ? "; falling so in step " + since + " and since; the log lacks step " + std::to_string(step)
                      : "; falling so since step " + since;
    }
    if (step == log().first_state() || found->lost) return std::optional(Cursor{step, at.body, at.field});
    Result<std::optional<Cursor>> before = before_step(step, at.body, at.field);
    if (!before.ok() || (*before)->before_write == 0 || step == at.step) return before;
    return std::optional(Cursor{step, at.body, at.field});
  }

  /// What a phase should have done to the body in the step asked about, and did not: that is in no value it wrote.
  void add_broken_rules(const BodyAccount& own) {
    if (std::exchange(rules_told_, true)) return;
    for (const BlameAnswer& answer : broken_rules_of(own)) {
      if (wants_more()) blame_.answers.push_back(answer);
    }
  }

  /// The body woke or fell asleep in the step: that flag decides what moves it.
  void add_rest_change(const BodyAccount& own) {
    if (const std::optional<std::size_t> write = last_change(own, kFrozenField, kEndOfStep); write) {
      add({answer_of(own, own.writes[*write], kFrozenField)});
    }
  }

  /// A value that the same phase wrote with another is asked for as it was before the phase; frozen flags as after it.
  static std::size_t write_before(std::size_t write, std::size_t to) { return to == kFrozenField ? write + 1 : write; }

  /// Leaves out the phase that the answer before has named.
  void add(const std::vector<BlameAnswer>& answers) {
    const std::string named = blame_.answers.empty() ? std::string() : blame_.answers.back().phase;
    for (const BlameAnswer& answer : answers) {
      if (wants_more() && answer.phase != named) blame_.answers.push_back(answer);
    }
  }

  /// The motion that made a contact press: of the faster of the two bodies along the normal, at the start of the step.
  Result<std::optional<Cursor>> motion_behind(const BodyAccount& own, const std::optional<sim::BodyId>& other,
                                              const Cursor& at) {
    const ContactFacts* facts = own.contact_with(other);
    const sim::Vec3 normal = facts != nullptr ? facts->normal : sim::Vec3(sim::Vec3::Zero());
    sim::BodyId body = own.body;
    BodyMotion motion = own.start;
    if (other) {
      const Result<std::optional<BodyMotion>> of_other = steps_.after(at.step - 1, *other);
      if (!of_other.ok()) return of_other.error();
      if (*of_other && std::fabs(sim::dot((*of_other)->vector(kVelocity), normal)) >
                           std::fabs(sim::dot(own.start.vector(kVelocity), normal))) {
        body = *other;
        motion = **of_other;
      }
    }
    const std::size_t field = largest_of(motion, kVelocity);
    if (motion.of(field) == 0) return ended(end_at_rest(steps_, at.step, {body, field}, blame_));
    return before_step(at.step, body, field);
  }

  /// The value of a body at the start of a step, its inputs applied.
  Result<std::optional<Cursor>> before_step(std::uint64_t k, sim::BodyId body, std::size_t field) {
    const Result<std::optional<BodyMotion>> before = steps_.after(k - 1, body);
    if (!before.ok()) return before.error();
    Result<const BodyAccount*> now = account(k, body);
    if (!now.ok()) return now.error();
    const bool by_input = !before->has_value() || !same_value((*before)->of(field), (*now)->start.of(field));
    if (by_input) return std::optional(Cursor{k, body, field, 0});
    return std::optional(Cursor{k - 1, body, field, kEndOfStep, true});
  }

  /// No phase of the step changed the value: an input before the step did, or an earlier step.
  Result<std::optional<Cursor>> explain_before(const Cursor& at, const BodyAccount& own) {
    const Result<std::optional<BodyMotion>> before = steps_.after(at.step - 1, at.body);
    if (!before.ok()) return before.error();
    const bool by_input = !before->has_value() || !same_value((*before)->of(at.field), own.start.of(at.field));
    if (by_input) return ended(end_at_inputs(steps_, at.step, at.value(), blame_));
    const Result<StepFound> found = step_it_changed(steps_, at.step - 1, at.body, at.field);
    if (!found.ok()) return found.error();
    Result<std::optional<Cursor>> next = explain({found->step, at.body, at.field, kEndOfStep, false});
    if (next.ok() && at.step == question_.step) {
      add_broken_rules(own);
      add_reason_of_rest(own, at.field);
    }
    return next;
  }

  /// No phase of the step asked about changed the value: what left the body as it was.
  void add_reason_of_rest(const BodyAccount& own, std::size_t field) {
    if (own.is_static) return;
    if (own.start.frozen() && own.end.frozen()) add({rest_of(own, method_)});
    if (own.contacts.empty()) return add(absence_of(own, method_));
    add(making_of(own, *std::ranges::min_element(own.contacts, {}, &ContactFacts::approach), field, method_));
  }

  StepsAgain steps_;
  BlameQuestion question_;
  sim::Method method_;
  Blame blame_;
  bool rules_told_ = false;
  bool stopped_ = false;
  std::map<std::pair<std::uint64_t, sim::BodyId>, BodyAccount> accounts_;  // of all answers so far
};

}  // namespace

Result<Blame> blame(LogReader& log, const BlameQuestion& question, const Progress& progress) {
  return Chain(log, question, progress).run();
}

}  // namespace tumble::replay
