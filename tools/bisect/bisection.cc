#include "tools/bisect/bisection.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "golden/suite/text_files.h"
#include "tools/output/text.h"

namespace tumble::tools::bisect {
namespace {

Json answer_json(const std::string& commit, const Answer& answer, double seconds) {
  return {{"commit", commit},
          {"asked", answer.asked},
          {"yes", answer.yes},
          {"words", answer.message},
          {"metric", answer.metric ? number_json(*answer.metric) : Json(nullptr)},
          {"seconds", seconds}};
}

struct Known {
  Answer answer;
  double seconds = 0;
};

/// The answers so far, in a file that is never half written.
class State {
 public:
  State(std::string path, std::string fingerprint) : path_(std::move(path)) {
    json_["question"] = std::move(fingerprint);
  }

  Status load() {
    const Result<std::string> text = golden::read_text(path_);
    if (!text.ok()) return save();
    const Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object() || json.value("question", "") != json_["question"] || !json.contains("answers")) {
      return bad_input(path_ + ": is the state of another bisection; leave --resume out, or give the arguments it had");
    }
    json_ = json;
    for (const Json& row : json_["answers"]) {
      Known known;
      known.answer.asked = row.value("asked", false);
      known.answer.yes = row.value("yes", false);
      known.answer.message = row.value("words", "");
      known.answer.metric = number_of(row.value("metric", Json()));
      known.seconds = row.value("seconds", 0.0);
      known_[row.value("commit", "")] = known;
    }
    return {};
  }

  [[nodiscard]] const Known* find(const std::string& commit) const {
    const auto found = known_.find(commit);
    return found == known_.end() ? nullptr : &found->second;
  }

  Status add(const std::string& commit, const Answer& answer, double seconds) {
    known_[commit] = {answer, seconds};
    json_["answers"].push_back(answer_json(commit, answer, seconds));
    return save();
  }

 private:
  Status save() {
    if (!json_.contains("answers")) json_["answers"] = Json::array();
    const std::string text = json_.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
    return golden::write_file(path_, std::string_view(text));
  }

  std::string path_;
  Json json_;
  std::map<std::string, Known> known_;
};

class Bisection {
 public:
  Bisection(const Settings& settings, const Workplace& place, const Git& git, const Asker::Cancel& cancel,
            const EachBegun& begun, const EachTested& each)
      : settings_(settings),
        git_(git),
        asker_(settings, place, git, cancel),
        begun_(begun),
        each_(each),
        state_(place.state(), settings.fingerprint()) {}

  Result<Finding> run() {
    if (Status ok = resolve_ends(); !ok.ok()) return ok.error();
    if (Status ok = state_.load(); !ok.ok()) return ok.error();
    if (Status ok = asker_.prepare(); !ok.ok()) return ok.error();
    if (Status ok = ask_ends(); !ok.ok()) return ok.error();
    while (true) {
      const Result<Plan> plan = next();
      if (!plan.ok()) return plan.error();
      if (plan->test.empty()) return finish(*plan);
      if (Status ok = ask(plan->test); !ok.ok()) return ok.error();
    }
  }

 private:
  Status resolve_ends() {
    const Result<std::string> good = git_.resolve(settings_.good), bad = git_.resolve(settings_.bad);
    if (!good.ok()) return Error{good.error().kind, "--good: " + good.error().message};
    if (!bad.ok()) return Error{bad.error().kind, "--bad: " + bad.error().message};
    good_ = {*good};
    bad_ = *bad;
    if (*good == *bad) return bad_input("--good and --bad are the same commit, " + good->substr(0, 10));
    const Result<bool> in_line = git_.is_ancestor(*good, *bad);
    if (!in_line.ok()) return in_line.error();
    if (*in_line) return {};
    return bad_input("--good " + settings_.good + " is no ancestor of --bad " + settings_.bad +
                     "; take their merge base as the good one ('git merge-base'), or exchange them");
  }

  /// Asks both ends first: the good end's answer is the reference for all others.
  Status ask_ends() {
    for (const std::string& end : {good_.front(), bad_}) {
      if (Status ok = ask(end); !ok.ok()) return ok;
      const Tested& tested = finding_.tested.back();
      if (tested.answer.asked) continue;
      return cannot_finish("the " + std::string(end == bad_ ? "bad" : "good") + " revision " + tested.commit.shortly() +
                           " cannot be asked: " + tested.answer.message);
    }
    if (finding_.tested[0].answer.yes != finding_.tested[1].answer.yes) return {};
    return bad_input("the question (" + settings_.question() + ") has the same answer for both ends: good: " +
                     finding_.tested[0].answer.message + "; bad: " + finding_.tested[1].answer.message);
  }

  Result<Plan> next() {
    const Result<std::vector<Candidate>> candidates = git_.candidates(good_, bad_, settings_.first_parent);
    if (!candidates.ok()) return candidates.error();
    return next_step(*candidates, bad_, skipped_);
  }

  Status ask(const std::string& commit) {
    Result<CommitFacts> facts = git_.facts(commit);
    if (!facts.ok()) return facts.error();
    Tested tested;
    tested.commit = *facts;
    if (const Known* known = state_.find(commit)) {
      tested.answer = known->answer;
      tested.seconds = known->seconds;
    } else {
      begun_(*facts);
      const auto begin = std::chrono::steady_clock::now();
      Result<Answer> answer = asker_.ask(commit);
      if (!answer.ok()) return answer.error();
      tested.answer = *std::move(answer);
      tested.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      if (Status ok = state_.add(commit, tested.answer, tested.seconds); !ok.ok()) return ok;
    }
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
    const bool is_first = finding_.tested.empty();
    if (is_first || tested.answer.yes == finding_.tested.front().answer.yes) {
      if (!is_first) good_.push_back(tested.commit.commit);
      return Tested::Verdict::kGood;
    }
    bad_ = tested.commit.commit;
    return Tested::Verdict::kBad;
  }

  Status tell() {
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
    return std::move(finding_);
  }

  const Settings& settings_;
  const Git& git_;
  Asker asker_;
  const EachBegun& begun_;
  const EachTested& each_;
  State state_;
  std::vector<std::string> good_;
  std::string bad_;
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
