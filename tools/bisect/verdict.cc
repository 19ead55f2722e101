#include "tools/bisect/verdict.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"

namespace tumble::tools::bisect {
namespace {

Json facts_json(const CommitFacts& facts) {
  return {{"commit", facts.commit}, {"subject", facts.subject}, {"author", facts.author}, {"author_date", facts.date}};
}

Json number(const std::optional<double>& value) { return value ? number_json(*value) : Json(nullptr); }

Json end_json(const Tested& end) {
  return {{"commit", end.commit.commit},
          {"words", end.answer.message},
          {"metric", number(end.answer.metric)},
          {"sessions_differ", end.answer.sessions_differ}};
}

void print_commit(const CommitFacts& facts) {
  Listing listing;
  listing.add("  commit", facts.commit);
  listing.add("  subject", printable(facts.subject));
  listing.add("  author", printable(facts.author) + ", " + facts.date);
  listing.print();
}

void print_comparison(const Comparison& comparison) {
  if (!comparison.not_compared.empty()) {
    std::cout << "\nthe sessions before and after are not compared: " << printable(comparison.not_compared) << '\n';
    return;
  }
  const replay::DiffReport& report = comparison.report;
  if (report.identical()) {
    std::cout << "\nthe sessions before and after are the same in " << report.scope.every_bit() << '\n';
    print_scope(report.scope);
    return;
  }
  if (!report.first) {
    std::cout << "\nthe sessions before and after differ: " << printable(report.unequal("before", "after")) << '\n';
    return;
  }
  std::cout << "\nthe sessions before and after it\n";
  const Sides sides = {"before", "after"};
  print_divergence(*report.first, sides);
  const std::optional<replay::DifferenceReport>& difference = comparison.difference;
  if (difference && difference->growth) print_growth(*difference->growth, sides);
}

std::string doubt_text(const Tested& tested) {
  const std::string& text = tested.answer.not_repeatable;
  if (!text.empty()) return "; NOT REPEATABLE: " + text;
  const std::string& sessions = tested.answer.sessions_differ;
  return sessions.empty() ? "" : "; NOT REPEATABLE: two runs of it differ, " + printable(sessions);
}

/// Revisions that answered now so, now otherwise: the commit found may be the wrong one.
void print_doubts(const Finding& finding) {
  for (const Tested& tested : finding.tested) {
    const Answer& answer = tested.answer;
    if (!answer.not_repeatable.empty()) {
      std::cout << "\nthe answer of " << tested.commit.shortly() << " is not repeatable (" << answer.not_repeatable
                << "); the result relies on the most frequent one\n";
    }
  }
}

/// A later revision whose session differs from LOG elsewhere than that of the commit found: another commit changed it
/// too. Its name in the list of those asked, null: none is known.
const Tested* changed_again(const Settings& settings, const Finding& finding) {
  const Answer& found = finding.tested[finding.bad].answer;
  if (settings.metric || !settings.case_name.empty() || found.outcome.empty()) return nullptr;
  for (const Tested& tested : finding.tested) {
    const Answer& answer = tested.answer;
    const bool repeats = answer.not_repeatable.empty() && answer.sessions_differ.empty() && answer.other.empty();
    if (tested.verdict == Tested::Verdict::kBad && repeats && differ(found, answer)) return &tested;
  }
  return nullptr;
}

/// Two values of one field, of two runs, need this word: the change that was asked about may be chance.
void print_repeats(const Tested& good, const Tested& bad) {
  for (const Tested* tested : {&good, &bad}) {
    if (tested->answer.sessions_differ.empty()) continue;
    const bool from_here = tested == &bad && good.answer.sessions_differ.empty();
    std::cout << '\n'
              << (from_here ? "from " + tested->commit.shortly() + " on the session is not repeatable"
                            : "the session of " + tested->commit.shortly() + " is not repeatable")
              << ": two runs of it differ from each other, " << printable(tested->answer.sessions_differ)
              << "; the values here are those of one run\n";
  }
}

}  // namespace

Comparison compare_sessions(const Finding& finding, const Workplace& place) {
  Comparison comparison;
  const auto session = [&](std::size_t index) { return place.session(finding.tested[index].commit.commit); };
  Result<replay::LogReader> before = open_log(session(finding.good));
  Result<replay::LogReader> after = open_log(session(finding.bad));
  if (!before.ok() || !after.ok()) {
    comparison.not_compared = "one of the revisions could not record it";
    return comparison;
  }
  Result<replay::DiffReport> report = replay::diff_logs(*before, *after);
  if (!report.ok()) {
    comparison.not_compared = report.error().message;
    return comparison;
  }
  comparison.report = *std::move(report);
  if (!comparison.report.first) return comparison;
  Result<replay::DifferenceReport> difference = replay::report_difference(*before, *after, comparison.report);
  if (!difference.ok()) {
    comparison.not_compared = difference.error().message;
    return comparison;
  }
  name_bodies(*before, *after, difference->first);
  comparison.report.first = difference->first;
  replay::name_by_own_axes(before->header(), after->header(), comparison.report, &*difference);
  comparison.difference = *std::move(difference);
  return comparison;
}

std::string tested_text(const Tested& tested) {
  return padded(name_of(tested.verdict), 5) + ' ' + tested.commit.shortly() + ' ' + tested.commit.date.substr(0, 10) +
         ' ' + printable(tested.commit.subject) + ": " + printable(tested.answer.message) + doubt_text(tested) + " (" +
         seconds_text(tested.seconds) + ')';
}

void print_verdict(const Settings& settings, const Finding& finding, const Comparison& comparison) {
  if (finding.found()) {
    std::cout << "\nthe first commit with another answer (" << printable(settings.question()) << ")\n";
    print_commit(finding.suspects.front());
  } else {
    std::cout << "\none of these " << count_text(finding.suspects.size(), "commit")
              << "; those but the last could not be asked (" << printable(settings.question()) << ")\n";
    for (const CommitFacts& facts : finding.suspects) {
      std::cout << "  " << facts.shortly() << ' ' << facts.date.substr(0, 10) << ' ' << printable(facts.subject)
                << '\n';
    }
  }
  const Tested& good = finding.tested[finding.good];
  const Tested& bad = finding.tested[finding.bad];
  Listing listing;
  listing.add("  before", printable(good.answer.message) + " (" + good.commit.shortly() + ')');
  listing.add("  after", printable(bad.answer.message) + " (" + bad.commit.shortly() + ')');
  listing.print();
  print_repeats(good, bad);
  print_doubts(finding);
  if (const Tested* again = changed_again(settings, finding)) {
    std::cout << "\na later commit changed the session again: " << again->commit.shortly() << " answers "
              << printable(again->answer.message) << "; to find the next one, record LOG at " << bad.commit.shortly()
              << " and ask with it as --good\n";
  }
  print_comparison(comparison);
}

Json verdict_json(const Settings& settings, const Finding& finding, const Comparison& comparison) {
  const Tested& good = finding.tested[finding.good];
  const Tested& bad = finding.tested[finding.bad];
  Json json = {{"found", finding.found()}, {"question", settings.question()}};
  json["commit"] = finding.found() ? facts_json(finding.suspects.front()) : Json(nullptr);
  json["suspects"] = Json::array();
  for (const CommitFacts& facts : finding.suspects) json["suspects"].push_back(facts_json(facts));
  json["before"] = end_json(good);
  json["after"] = end_json(bad);
  json["sessions"] = nullptr;
  if (comparison.not_compared.empty()) {
    const replay::DiffReport& report = comparison.report;
    json["sessions"] = comparison_json(report.identical(), report.steps, report.first);
    const bool has_growth = comparison.difference && comparison.difference->growth;
    json["sessions"]["aftermath"] = has_growth ? growth_json(*comparison.difference->growth) : Json(nullptr);
  }
  json["tested"] = Json::array();
  for (const Tested& tested : finding.tested) {
    json["tested"].push_back({{"commit", tested.commit.commit},
                              {"subject", tested.commit.subject},
                              {"verdict", name_of(tested.verdict)},
                              {"words", tested.answer.message},
                              {"metric", number(tested.answer.metric)},
                              {"not_repeatable", tested.answer.not_repeatable},
                              {"sessions_differ", tested.answer.sessions_differ},
                              {"seconds", tested.seconds}});
  }
  return json;
}

}  // namespace tumble::tools::bisect
