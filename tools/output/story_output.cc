#include "tools/output/story_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace tumble::tools {
namespace {

constexpr std::size_t kRowsJson = 4000;
constexpr std::size_t kContactsShown = 8;

/// The strongest way in which the two differ.
const char* kind_of(const replay::GapStory& gap) {
  if (gap.bodies_from) return "bodies";
  if (gap.freezing_from) return "freezing";
  if (gap.contacts_from) return "contacts";
  return "numbers";
}

std::string since(const std::optional<std::uint64_t>& step) {
  return step ? "differ from step " + std::to_string(*step) + " on" : "the same";
}

std::string gap_text(const replay::GapRow& row) {
  std::string text = rounded(row.gap, "m");
  if (row.body) text += ", body " + std::to_string(*row.body);
  return text;
}

/// Rows worth reading: 0, 1, 2, 4, 8, … steps after the first, and the last.
std::vector<const replay::GapRow*> chosen_rows(const replay::GapStory& gap) {
  std::vector<const replay::GapRow*> rows;
  for (std::size_t i = 0; i < gap.rows.size(); i = i == 0 ? 1 : 2 * i) rows.push_back(&gap.rows[i]);
  if (rows.back() != &gap.rows.back()) rows.push_back(&gap.rows.back());
  return rows;
}

/// Rounded, unless that would make them look alike.
std::pair<std::string, std::string> values_apart(const std::optional<double>& a, const std::optional<double>& b) {
  const auto text = [](const std::optional<double>& value) { return value ? rounded(*value, "") : "none"; };
  if (!a || !b || text(a) != text(b)) return {text(a), text(b)};
  return {exact(*a), exact(*b)};
}

Json row_json(const replay::GapRow& row) {
  return {{"step", row.step},
          {"bodies", row.bodies},
          {"gap", row.gap},
          {"body", row.body ? Json(*row.body) : Json(nullptr)}};
}

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }
Json step_or_null(const std::optional<std::uint64_t>& step) { return step ? Json(*step) : Json(nullptr); }

const char* follows(const replay::Narrowing& narrowing) {
  if (narrowing.as_a) return narrowing.as_b ? "both" : "A";
  return narrowing.as_b ? "B" : "neither";
}

}  // namespace

void print_aftermath(const replay::Aftermath& aftermath, const char* a, const char* b) {
  const replay::GapStory& gap = aftermath.gap;
  Listing listing;
  listing.section("what it led to");
  for (const replay::GapMark& mark : gap.marks) {
    listing.add("  gap above " + rounded(mark.above, "m"),
                "from step " + std::to_string(mark.step) + ", body " + std::to_string(mark.body));
  }
  listing.add("  largest gap", gap_text(gap.largest) + ", step " + std::to_string(gap.largest.step));
  listing.add("  gap at the end", gap_text(gap.rows.back()));
  listing.add("  contacts", since(gap.contacts_from));
  listing.add("  freezing", since(gap.freezing_from));
  if (gap.bodies_from)
    listing.add("  bodies", "not the same ones from step " + std::to_string(*gap.bodies_from) + " on");
  listing.print();

  std::cout << '\n';
  Table steps({">  step", ">bodies that differ", ">largest gap, m"});
  for (const replay::GapRow* row : chosen_rows(gap)) {
    steps.add({std::to_string(row->step), std::to_string(row->bodies), rounded(row->gap, "")});
  }
  steps.print();
  std::cout << '\n';
  if (!aftermath.not_measured.empty()) {
    std::cout << "metrics are not compared: " << printable(aftermath.not_measured) << '\n';
  } else if (aftermath.metrics.empty()) {
    std::cout << "no metric moved\n";
  } else {
    Table metrics({"  metric that moved", std::string(">") + a, std::string(">") + b, "unit"});
    for (const replay::MovedMetric& m : aftermath.metrics) {
      const auto [in_a, in_b] = values_apart(m.a, m.b);
      metrics.add({"  " + m.name, in_a, in_b, m.unit});
    }
    metrics.print();
  }
}

Json aftermath_json(const replay::Aftermath& aftermath) {
  const replay::GapStory& gap = aftermath.gap;
  Json json = {{"kind", kind_of(gap)}, {"marks", Json::array()}};
  for (const replay::GapMark& mark : gap.marks) {
    json["marks"].push_back({{"above", mark.above}, {"step", mark.step}, {"body", mark.body}});
  }
  json["contacts_from"] = step_or_null(gap.contacts_from);
  json["freezing_from"] = step_or_null(gap.freezing_from);
  json["bodies_from"] = step_or_null(gap.bodies_from);
  json["largest"] = row_json(gap.largest);
  json["last"] = row_json(gap.rows.back());
  json["metrics"] = aftermath.not_measured.empty() ? Json::array() : Json(nullptr);
  for (const replay::MovedMetric& m : aftermath.metrics) {
    json["metrics"].push_back({{"name", m.name}, {"unit", m.unit}, {"expected", number(m.a)}, {"actual", number(m.b)}});
  }
  json["steps"] = Json::array();
  const std::size_t stride = gap.rows.size() / kRowsJson + 1;
  for (std::size_t i = 0; i < gap.rows.size(); i += stride) json["steps"].push_back(row_json(gap.rows[i]));
  return json;
}

void print_narrowing(const replay::Narrowing& narrowing) {
  if (!narrowing.not_taken.empty()) {
    std::cout << "  the step could not be taken again: " << printable(narrowing.not_taken) << '\n';
    return;
  }
  Listing listing;
  listing.add("  this build", "takes that step as " + std::string(follows(narrowing)) + " did");
  if (!narrowing.bodies.empty()) {
    listing.add("  after it", count_text(narrowing.bodies.size(), "body") + " in another state");
  }
  for (std::size_t i = 0; i < std::min(kContactsShown, narrowing.contacts.size()); ++i) {
    listing.add(i == 0 ? "  contacts" : "", replay::describe(narrowing.contacts[i]));
  }
  listing.print();
}

Json narrowing_json(const replay::Narrowing& narrowing) {
  Json json;
  json["this_build_follows"] = narrowing.not_taken.empty() ? Json(follows(narrowing)) : Json(nullptr);
  json["bodies"] = narrowing.bodies;
  json["contacts"] = Json::array();
  for (const replay::StepContact& contact : narrowing.contacts) {
    json["contacts"].push_back({{"substep", contact.substep},
                                {"bodies", contact.b ? Json{contact.a, *contact.b} : Json{contact.a}},
                                {"normal", {contact.normal.x(), contact.normal.y(), contact.normal.z()}},
                                {"depth", contact.depth},
                                {"impulse", contact.impulse}});
  }
  return json;
}

}  // namespace tumble::tools
