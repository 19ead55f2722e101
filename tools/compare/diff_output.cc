#include "tools/compare/diff_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "tools/compare/blame_output.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

// If one log is longer and equal so far, the first difference is the step that only this log has.
std::optional<replay::Divergence> first_of(const replay::DiffReport& report) {
  if (report.first || report.last_a == report.last_b) return report.first;
  replay::Divergence end;
  end.step = std::min(report.last_a, report.last_b) + 1;
  end.phase = "step";
  end.field = "steps";
  end.expected = report.last_a;
  end.actual = report.last_b;
  return end;
}

constexpr std::size_t kHeadersShown = 20;

/// The first word of the verdict, and what was read for it.
std::string same_text(const DiffQuestion& question, const replay::DiffReport& report, const std::string& steps) {
  if (report.steps == 0 && !question.brief) {
    return std::string(question.exact_bits ? "identical" : "same within tolerances") + " at state " +
           std::to_string(report.from) + " alone: there is no step to compare";
  }
  const std::uint64_t zeros = report.zeros;
  std::string words = question.exact_bits ? "identical: " + steps : "same within tolerances: " + steps;
  if (zeros > 0) words += ", but for the sign of " + count_text(zeros, "zero");
  if (question.brief) return words + ", by " + read_in_brief(report);
  if (zeros > 0) return words;
  return words + (question.exact_bits ? ", " + report.scope.every_bit() : "");
}

/// "different in channels: only a.tumble has channel knee; the 40 steps are the same, every compared bit".
std::string unequal_text(const DiffQuestion& question, const replay::DiffReport& report, const Sides& sides,
                         const std::string& steps) {
  const std::string missing = report.only_in.text(sides.expected, sides.actual);
  const auto end = [&](std::uint64_t last) {
    return last == report.until ? "goes on to step " + std::to_string(last) + ", the last that was asked for"
                                : "ends with step " + std::to_string(last);
  };
  std::string text = report.last_a != report.last_b ? "different in length: the first " + end(report.last_a) +
                                                          ", the second " + end(report.last_b) + "; "
                                                    : "different in what was recorded: ";
  text += missing + (missing.empty() ? "" : "; ") + "the " + steps + " of both are the same";
  if (!question.exact_bits) return text + " within tolerances";
  return text + (missing.empty() ? "" : " in all else that was compared");
}

void print_text(const DiffQuestion& question, const replay::DiffReport& report, const Sides& sides) {
  for (std::size_t i = 0; i < std::min(kHeadersShown, report.headers.size()); ++i) {
    std::cout << "header: " << sides.named(printable(describe(report.headers[i]))) << '\n';
  }
  if (report.headers.size() > kHeadersShown) {
    std::cout << "header: " << report.headers.size() - kHeadersShown << " more differences (all with --json)\n";
  }
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  if (report.from > 0) std::cout << "compared from step " << report.from << " on, which both logs have\n";
  const std::string steps = count_text(report.steps, "step");
  if (report.identical()) {
    std::cout << same_text(question, report, steps) << '\n';
    if (!question.excused.empty()) std::cout << "  though " << question.excused << ", as --shared allows\n";
  } else if (report.first) {
    std::cout << "different from step " << report.first->step << " on\n";
  } else {
    std::cout << unequal_text(question, report, sides, steps) << '\n';
  }
  if (const std::string though = report.though(); !though.empty()) std::cout << "  " << though << '\n';
  if (!report.first) print_scope(report.scope);
  if (report.first && !report.behind().empty()) std::cout << "not compared: " << report.behind() << '\n';
}

Json headers_json(const std::vector<replay::HeaderDifference>& headers) {
  Json rows = Json::array();
  for (const replay::HeaderDifference& difference : headers) {
    rows.push_back({{"key", difference.key},
                    {"expected", value_json(difference.a)},
                    {"actual", value_json(difference.b)},
                    {"acts", difference.acts},
                    {"excused", difference.excused}});
  }
  return rows;
}

// The command that explains the first value that differs, in a log whose step this build repeats; empty where there is
// none.
std::string next_command(const DiffQuestion& question, const Difference& difference) {
  if (!difference || !difference->effect) return "";
  const replay::DivergenceLocation& location = difference->location;
  if (!location.as_a && !location.as_b) return "";
  return blame_command(location.as_b ? question.b : question.a, *difference->effect);
}

}  // namespace

std::string read_in_brief(const replay::DiffReport& report) {
  if (report.states_read == 0) return "hashes; payloads not read";
  return "hashes, and the states of " + count_text(report.states_read, "step") +
         " whose hashes differ; other payloads not read";
}

void print_result(const DiffQuestion& question, const replay::DiffReport& report, const Difference& difference,
                  const Further& further) {
  if (question.json) {
    Json json = comparison_json(report.identical(), report.steps, first_of(report));
    json["only_in"] = only_in_json(report.only_in);
    json["read"] = further.read;
    add_scope(report.scope, json);
    json["zeros_of_other_sign"] = report.zeros;
    json["notes"] = report.notes;
    json["headers"] = Json::array();
    for (const replay::HeaderDifference& header : report.headers) {
      json["headers"].push_back(further.sides.named(describe(header)));
    }
    json["header_differences"] = headers_json(report.headers);
    if (difference) add_difference(*difference, Compared::kTwoLogs, json);
    const std::string next = next_command(question, difference);
    json["next"] = next.empty() ? Json(nullptr) : Json(next);
    if (question.zoom) json["zoom"] = further.zoom ? zoom_json(*further.zoom) : Json(nullptr);
    if (question.apart) json["apart"] = parting_json(further.parting, *question.apart);
    print_json("diff", json);
    return;
  }
  const Sides& sides = further.sides;
  print_text(question, report, sides);
  if (difference) {
    print_difference(*difference, Compared::kTwoLogs, sides);
    const std::string next = next_command(question, difference);
    if (!next.empty()) std::cout << "to find the cause of that value: " << printable(next) << '\n';
  } else if (report.first) {
    std::cout << "cause   " << sides.named(printable(replay::cause_of(report, *report.first))) << '\n';
    print_divergence(*report.first, sides);
    if (question.brief) std::cout << "  read        " << further.read << ", so damage in them is not seen\n";
  }
  if (further.zoom) print_zoom(*further.zoom, sides);
}

}  // namespace tumble::tools
