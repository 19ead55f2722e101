#include "tools/bisect/bisection.h"

#include <algorithm>
#include <set>
#include <utility>

#include "tools/bisect/known_answers.h"

namespace tumble::tools::bisect {
namespace {

class Bisection {
 public:
  Bisection(const Settings& settings, const Workplace& place, const Git& git, const Asker::Cancel& cancel,
            const EachBegun& begun, const EachTested& each)
      : settings_(settings),
        git_(git),
        askers_(settings, place, cancel),
        begun_(begun),
        each_(each),
        state_(place.state(), settings.fingerprint()) {}

  Result<Finding> run() {
    if (Status ok = resolve_ends(); !ok.ok()) return ok.error();
    if (Status ok = state_.load(); !ok.ok()) return ok.error();
    if (Status ok = askers_.prepare(); !ok.ok()) return ok.error();
    if (Status ok = settings_.good.empty() ? go_back() : ask_ends(); !ok.ok()) return ok.error();
    while (true) {
      const Result<Plan> plan = next();
      if (!plan.ok()) return plan.error();
      if (plan->test.empty()) return finish(*plan);
      const Result<std::vector<std::string>> batch = batch_for(plan->test);
      if (!batch.ok()) return batch.error();
      if (Status ok = ask(plan->test, *batch); !ok.ok()) return ok.error();
    }
  }

 private:
  Status resolve_ends() {
    const Result<std::string> bad = git_.resolve(settings_.bad);
    if (!bad.ok()) return Error{bad.error().kind, "--bad: " + bad.error().message};
    bad_ = *bad;
    if (settings_.good.empty()) return {};
    const Result<std::string> good = git_.resolve(settings_.good);
    if (!good.ok()) return Error{good.error().kind, "--good: " + good.error().message};
    good_ = {*good};
    if (*good == *bad) return bad_input("--good and --bad are the same commit, " + good->substr(0, 10));
    const Result<bool> in_line = git_.is_ancestor(*good, *bad);
    if (!in_line.ok()) return in_line.error();
    if (*in_line) return {};
    return bad_input("--good " + settings_.good + " is no ancestor of --bad " + settings_.bad +
                     "; take their merge base as the good one ('git merge-base'), or exchange them" +
                     git_.shallow_advice());
  }

  [[nodiscard]] static Status could_ask(const Tested& tested, const char* end) {
    if (tested.answer.asked) return {};
    return cannot_finish("the " + std::string(end) + " revision " + tested.commit.shortly() +
                         " cannot be asked: " + tested.answer.message);
  }

  /// Asks both ends first: the good end's answer is the reference for all others.
  Status ask_ends() {
    const std::vector<std::string> ends = {good_.front(), bad_};
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (Status ok = ask(ends[k], ends); !ok.ok()) return ok;
      if (Status ok = could_ask(finding_.tested.back(), k == 0 ? "good" : "bad"); !ok.ok()) return ok;
    }
    if (finding_.tested[0].answer.yes != finding_.tested[1].answer.yes) return {};
    for (const std::size_t k : {0U, 1U}) {
      if (Status ok = look_for_other_outcomes(k); !ok.ok()) return ok;
    }
    const Answer &good = finding_.tested[0].answer, &bad = finding_.tested[1].answer;
    const bool of_log = !settings_.metric && settings_.case_name.empty();
    if (of_log && !good.yes && good.message != bad.message) {
      return bad_input(
          "neither end repeats the log, and their sessions differ from each other (" + settings_.question() +
          "): good: " + good.message + "; bad: " + bad.message +
          "; each did the same whenever it was asked: the log is of another revision, or of an engine whose "
          "sessions depend on more than the revision; record LOG anew at the good revision, twice, and "
          "ask about it if 'tumble diff' says that the two are the same");
    }
    const std::string bound = !settings_.metric ? ""
                              : good.yes        ? ": both are within the bound"
                                                : ": both are out of bound";
    return bad_input("the question (" + settings_.question() + ") has the same answer for both ends" + bound +
                     ": good: " + finding_.tested[0].answer.message + "; bad: " + finding_.tested[1].answer.message);
  }

  /// Two runs may differ from the log in the same way by chance, so an end that does not repeat it is asked again.
  Status look_for_other_outcomes(std::size_t end) {
    constexpr int kMoreTimes = 3;
    const Tested& tested = finding_.tested[end];
    std::string other = tested.answer.other;
    for (int k = 0; k < kMoreTimes && other.empty() && !tested.answer.yes && !tested.answer.outcome.empty(); ++k) {
      const Result<std::vector<Asked>> again = askers_.ask({tested.commit.commit});
      if (!again.ok()) return again.error();
      const Answer& answer = again->front().answer;
      other = differ(tested.answer, answer) || (answer.asked && answer.yes) ? answer.message : answer.other;
    }
    if (other.empty() && tested.answer.not_repeatable.empty()) return {};
    const std::string& one = tested.answer.message;
    const std::string runs = other.empty()  ? tested.answer.not_repeatable
                             : other == one ? "two runs: " + one + ", and each another way in later steps"
                                            : "one run: " + one + "; another: " + other;
    return bad_input("the " + std::string(end == 0 ? "good" : "bad") + " revision " + tested.commit.shortly() +
                     " is not repeatable: its own sessions differ from each other (" + runs +
                     "), so no revision can be told from it by this question (" + settings_.question() +
                     "); make the engine repeatable first, or ask for a bound with --metric");
  }

  /// Looks for the good end: 1, 2, 4 … first parents back, at last the root.
  Status go_back() {
    const std::string from = bad_;
    const Result<std::uint64_t> depth = git_.depth(from);
    if (!depth.ok()) return depth.error();
    std::vector<std::string> line = {from};
    for (std::uint64_t back = 1;; back = std::min(2 * back, *depth)) {
      if (back > *depth) break;
      const Result<std::string> commit = git_.resolve(from + '~' + std::to_string(back));
      if (!commit.ok()) return commit.error();
      line.push_back(*commit);
      if (back == *depth) break;
    }
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (Status ok = ask(line[k], {line.begin() + static_cast<std::ptrdiff_t>(k), line.end()}); !ok.ok()) return ok;
      if (k > 0 && finding_.tested.back().verdict == Tested::Verdict::kGood) return {};
      if (k > 0) continue;
      if (Status ok = could_ask(finding_.tested.back(), "bad"); !ok.ok()) return ok;
    }
    return bad_input("--auto: found no revision with another answer (" + settings_.question() + ") from " +
                     from.substr(0, 10) + " back to the first one, " + line.back().substr(0, 10) + "; " +
                     std::to_string(line.size()) + " were asked: " + finding_.tested.front().answer.message +
                     git_.shallow_advice());
  }

  Result<Plan> next() { return plan_of(good_, bad_); }

  Result<Plan> plan_of(const std::vector<std::string>& good, const std::string& bad) {
    const Result<std::vector<Candidate>> candidates = git_.candidates(good, bad, settings_.first_parent);
    if (!candidates.ok()) return candidates.error();
    return next_step(*candidates, bad, skipped_);
  }

  /// The commit, and those that would be next after each answer to it, as many as are asked at once.
  Result<std::vector<std::string>> batch_for(const std::string& commit) {
    struct Guess {
      std::vector<std::string> good;
      std::string bad;
    };
    std::vector<std::string> batch;
    if (settings_.jobs == 1) return std::vector<std::string>{commit};
    std::vector<Guess> guesses = {{good_, bad_}};
    for (std::size_t k = 0; k < guesses.size() && batch.size() < settings_.jobs; ++k) {
      const Guess guess = guesses[k];
      const Result<Plan> plan = plan_of(guess.good, guess.bad);
      if (!plan.ok()) return plan.error();
      if (plan->test.empty()) continue;
      if (std::ranges::find(batch, plan->test) == batch.end()) batch.push_back(plan->test);
      guesses.push_back({guess.good, plan->test});
      guesses.push_back(guess);
      guesses.back().good.push_back(plan->test);
    }
    return batch;
  }

  /// Asks those of the commits, in order, that are not known, as many as are asked at once.
  Status fetch(const std::vector<std::string>& commits) {
    std::vector<std::string> unknown;
    for (const std::string& commit : commits) {
      if (unknown.size() == settings_.jobs) break;
      if (state_.find(commit) == nullptr) unknown.push_back(commit);
    }
    for (const std::string& commit : unknown) {
      const Result<CommitFacts> facts = git_.facts(commit);
      if (!facts.ok()) return facts.error();
      begun_(*facts);
    }
    const Result<std::vector<Asked>> answers = askers_.ask(unknown);
    if (!answers.ok()) return answers.error();
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      if (Status ok = state_.add(unknown[k], (*answers)[k]); !ok.ok()) return ok;
    }
    return {};
  }

  /// ahead: the commit and those that may be asked beside it.
  Status ask(const std::string& commit, const std::vector<std::string>& ahead) {
    Result<CommitFacts> facts = git_.facts(commit);
    if (!facts.ok()) return facts.error();
    if (state_.find(commit) == nullptr) {
      if (Status ok = fetch(ahead); !ok.ok()) return ok;
    }
    const Asked& known = *state_.find(commit);
    Tested tested;
    tested.commit = *std::move(facts);
    tested.answer = known.answer;
    tested.seconds = known.seconds;
    tested.verdict = judge(tested);
    finding_.tested.push_back(tested);
    return tell();
  }

  /// The good end's answer counts as good, whatever it is: a log that the bad revision recorded serves as well.
  Tested::Verdict judge(const Tested& tested) {
    if (!tested.answer.asked) {
      skipped_.insert(tested.commit.commit);
      return Tested::Verdict::kSkip;
    }
    if (finding_.tested.empty()) good_is_ = settings_.good.empty() ? !tested.answer.yes : tested.answer.yes;
    if (tested.answer.yes == good_is_) {
      if (std::ranges::find(good_, tested.commit.commit) == good_.end()) good_.push_back(tested.commit.commit);
      return Tested::Verdict::kGood;
    }
    bad_ = tested.commit.commit;
    return Tested::Verdict::kBad;
  }

  /// As long as there is no good end, nobody knows how many commits are left.
  Status tell() {
    if (good_.empty()) {
      each_(finding_.tested.back(), 0, 0);
      return {};
    }
    const Result<Plan> plan = next();
    if (!plan.ok()) return plan.error();
    each_(finding_.tested.back(), plan->left, plan->steps);
    return {};
  }

  Result<Finding> finish(const Plan& plan) {
    for (const std::string& commit : plan.suspects) {
      Result<CommitFacts> facts = git_.facts(commit);
      if (!facts.ok()) return facts.error();
      finding_.suspects.push_back(*std::move(facts));
    }
    const Result<std::string> parent = git_.resolve(bad_ + "^1");
    bool has_parent = false;
    for (std::size_t i = 0; i < finding_.tested.size(); ++i) {
      const Tested& tested = finding_.tested[i];
      if (tested.commit.commit == bad_) finding_.bad = i;
      if (tested.verdict != Tested::Verdict::kGood || has_parent) continue;
      finding_.good = i;
      has_parent = parent.ok() && tested.commit.commit == *parent;
    }
    for (const std::size_t k : {finding_.good, finding_.bad}) {
      Tested& tested = finding_.tested[k];
      if (Status ok = askers_.ask_again(tested.commit.commit, tested.answer); !ok.ok()) return ok.error();
    }
    return std::move(finding_);
  }

  const Settings& settings_;
  const Git& git_;
  AskAll askers_;
  const EachBegun& begun_;
  const EachTested& each_;
  KnownAnswers state_;
  std::vector<std::string> good_;
  std::string bad_;
  bool good_is_ = false;  // the answer of the good end
  std::set<std::string> skipped_;
  Finding finding_;
};

}  // namespace

const char* name_of(Tested::Verdict verdict) {
  switch (verdict) {
    case Tested::Verdict::kGood:
      return "good";
    case Tested::Verdict::kBad:
      return "bad";
    case Tested::Verdict::kSkip:
      return "skip";
  }
  return "";
}

Result<Finding> find_commit(const Settings& settings, const Workplace& place, const Git& git,
                            const Asker::Cancel& cancel, const EachBegun& begun, const EachTested& each) {
  return Bisection(settings, place, git, cancel, begun, each).run();
}

}  // namespace tumble::tools::bisect
