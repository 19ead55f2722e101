#include "tools/output/difference_output.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace tumble::tools {
namespace {

constexpr std::size_t kRowsJson = 4000;
constexpr std::size_t kContactsShown = 8;
constexpr std::size_t kMetricsNamed = 6;

/// The strongest kind of difference between the two.
const char* kind_of(const replay::Separation& separation) {
  if (separation.bodies_from) return "bodies";
  if (separation.freezing_from) return "freezing";
  if (separation.contacts_from) return "contacts";
  return "numbers";
}

/// Steps before the first difference were not looked at.
std::string since(const std::optional<std::uint64_t>& step, bool had_any, const replay::Separation& separation) {
  if (step) return "differ from step " + std::to_string(*step) + " on";
  const std::string first = std::to_string(separation.rows.front().step);
  return had_any ? "the same" : "none in either log from step " + first + " on";
}

/// Contacts of our own sessions are compared by their number alone.
std::string contacts_text(const replay::Separation& separation, const Sides& sides) {
  if (!separation.compares_contacts) return "not compared";
  if (!separation.contacts_from && separation.had_contacts && !separation.contacts_by_value)
    return "the same in number; their values are not compared";
  std::string text = since(separation.contacts_from, separation.had_contacts, separation);
  if (!separation.first_contact) return text;
  const auto& [pair, words] = *separation.first_contact;
  text += ", first of " + sides.body(pair.first) + " and ";
  return text + (pair.second == 0 ? "the ground" : sides.body(pair.second)) + ": " + words;
}

std::string distance_text(double distance, const char* unit) {
  if (std::isnan(distance)) return "not a number";
  return std::isfinite(distance) ? rounded(distance, unit) : "infinite";
}

/// "1 body only in a.tumble, 2 bodies only in b.tumble", which have no separation.
std::string only_in_text(const replay::SeparationRow& row, const Sides& sides) {
  std::string text;
  for (const auto& [count, side] : {std::pair(row.only_in_a, sides.expected), std::pair(row.only_in_b, sides.actual)}) {
    if (count > 0) text += (text.empty() ? "" : ", ") + count_text(count, "body") + " only in " + side;
  }
  return text;
}

std::string separation_text(const replay::SeparationRow& row, const Sides& sides) {
  std::string text = distance_text(row.separation, "m");
  if (row.body) text += ", " + sides.body(*row.body);
  return text;
}

/// A few rows to print: 0, 1, 2, 4, 8, … steps after the first, and the last.
std::vector<const replay::SeparationRow*> chosen_rows(const replay::Separation& separation) {
  std::vector<const replay::SeparationRow*> rows;
  for (std::size_t i = 0; i < separation.rows.size(); i = i == 0 ? 1 : 2 * i) rows.push_back(&separation.rows[i]);
  if (rows.back() != &separation.rows.back()) rows.push_back(&separation.rows.back());
  return rows;
}

/// Rounded, unless that would make them look alike.
std::pair<std::string, std::string> values_apart(const std::optional<double>& a, const std::optional<double>& b) {
  const auto text = [](const std::optional<double>& value) { return value ? rounded(*value, "") : "none"; };
  if (!a || !b || text(a) != text(b)) return {text(a), text(b)};
  return {exact(*a), exact(*b)};
}

/// A metric over a body that is lost has no number: such metrics are named and not set side by side.
void print_metrics(const std::vector<replay::MovedMetric>& moved, const Sides& sides) {
  const auto is_none = [](const std::optional<double>& value) { return value && std::isnan(*value); };
  Table metrics({"  metric that moved", ">" + sides.expected, ">" + sides.actual, "unit"});
  std::vector<std::string> in_a, in_b;
  for (const replay::MovedMetric& m : moved) {
    if (is_none(m.a)) in_a.push_back(m.name);
    if (is_none(m.b)) in_b.push_back(m.name);
    if (is_none(m.a) || is_none(m.b)) continue;
    const auto [text_a, text_b] = values_apart(m.a, m.b);
    metrics.add({"  " + m.name, text_a, text_b, m.unit});
  }
  if (in_a.size() + in_b.size() < moved.size()) metrics.print();
  for (const auto& [names, side] : {std::pair(in_a, sides.expected), std::pair(in_b, sides.actual)}) {
    if (names.empty()) continue;
    std::cout << "no number in " << side << ", where a body is lost: ";
    for (std::size_t i = 0; i < std::min(kMetricsNamed, names.size()); ++i)
      std::cout << (i == 0 ? "" : ", ") << names[i];
    if (names.size() > kMetricsNamed) std::cout << " and " << names.size() - kMetricsNamed << " more metrics";
    std::cout << '\n';
  }
}

Json row_json(const replay::SeparationRow& row) {
  return {{"step", row.step},
          {"bodies", row.bodies},
          {"only_in_a", row.only_in_a},
          {"only_in_b", row.only_in_b},
          {"gap", number_json(row.separation)},
          {"body", row.body ? Json(*row.body) : Json(nullptr)}};
}

Json number(const std::optional<double>& value) { return value ? number_json(*value) : Json(nullptr); }
Json step_or_null(const std::optional<std::uint64_t>& step) { return step ? Json(*step) : Json(nullptr); }

const char* follows(const replay::DivergenceLocation& location) {
  if (location.as_a) return location.as_b ? "both" : "A";
  return location.as_b ? "B" : "neither";
}

/// For people: the logs that this build's step matches.
std::string match_text(const replay::DivergenceLocation& location, const Sides& sides) {
  if (location.as_a && location.as_b) return "matches both logs in that step";
  if (location.as_a || location.as_b) {
    return "matches " + (location.as_a ? sides.expected : sides.actual) + " in that step";
  }
  return "matches neither log in that step";
}

Json lost_json(const std::optional<replay::LostBody>& lost) {
  if (!lost) return nullptr;
  return {{"step", lost->step}, {"body", lost->body}, {"field", lost->field}, {"in", lost->in_a ? "A" : "B"}};
}

void print_headlines(const replay::DifferenceReport& report, const Sides& sides) {
  Listing listing;
  if (!report.cause.empty()) listing.add("cause", sides.named(printable(report.cause)));
  if (report.effect) {
    listing.add("effect", effect_text(*report.effect, sides));
  } else if (!report.first.field.empty() && report.first.field != "error") {
    const auto last = [&] { return std::to_string(report.growth->separation.rows.back().step); };
    listing.add("effect", report.growth ? "in no state up to step " + last() : "not known");
  }
  listing.print();
}

/// "differs from step 12 on, by up to 1e-07 rad (step 12)".
std::string channel_text(const replay::ChannelSeparation& channel) {
  std::string text = "differs from step " + std::to_string(channel.from) + " on";
  if (!channel.is_number)
    return text + ", in up to " + count_text(static_cast<std::uint64_t>(channel.largest), "value");
  text += channel.largest <= std::numeric_limits<double>::denorm_min()
              ? ", in bits alone"
              : ", by up to " + distance_text(channel.largest, channel.unit.c_str());
  return text + " (step " + std::to_string(channel.largest_step) + ")";
}

Json channel_separation_json(const replay::ChannelSeparation& channel) {
  return {{"name", channel.name},
          {"unit", channel.unit},
          {"from", channel.from},
          {"largest", number_json(channel.largest)},
          {"largest_step", channel.largest_step},
          {"last", number_json(channel.distance.back())}};
}

}  // namespace

void print_growth(const replay::DivergenceGrowth& growth, const Sides& sides) {
  const replay::Separation& separation = growth.separation;
  Listing listing;
  listing.section("growth of the difference");
  if (separation.lost) {
    listing.add("  lost", sides.body(separation.lost->body) + ", step " + std::to_string(separation.lost->step) + ": " +
                              separation.lost->field + " is no finite number in " +
                              (separation.lost->in_a ? sides.expected : sides.actual));
  }
  for (const replay::SeparationMark& mark : separation.marks) {
    listing.add("  separation above " + rounded(mark.above, "m"),
                "from step " + std::to_string(mark.step) + ", " + sides.body(mark.body));
  }
  const std::string of_both = separation.bodies_from ? ", of the bodies that both have" : "";
  listing.add("  largest separation", separation_text(separation.largest, sides) + ", step " +
                                          std::to_string(separation.largest.step) + of_both);
  listing.add("  separation at the end", separation_text(separation.rows.back(), sides) + of_both);
  if (separation.clocks) listing.add("  clocks", clocks_text(*separation.clocks));
  listing.add("  contacts", contacts_text(separation, sides));
  listing.add("  freezing", since(separation.freezing_from, separation.had_frozen, separation));
  if (separation.bodies_from) {
    const std::string alone = only_in_text(separation.rows.back(), sides);
    listing.add("  bodies", "not the same ones from step " + std::to_string(*separation.bodies_from) +
                                " on; at the end " + (alone.empty() ? "the same ones" : alone));
  }
  for (const replay::ChannelSeparation& channel : separation.channels) {
    listing.add("  channel " + printable(channel.name), printable(channel_text(channel)));
  }
  listing.print();

  std::cout << '\n';
  Table steps({">  step", ">bodies that differ", ">separation, m"});
  for (const replay::SeparationRow* row : chosen_rows(separation)) {
    steps.add({std::to_string(row->step), std::to_string(row->bodies), distance_text(row->separation, "")});
  }
  steps.print();
  std::cout << '\n';
  if (!growth.not_measured.empty()) {
    std::cout << "metrics are not compared: " << printable(growth.not_measured) << '\n';
  } else if (growth.metrics.empty()) {
    std::cout << "no metric moved\n";
  } else {
    print_metrics(growth.metrics, sides);
  }
}

Json growth_json(const replay::DivergenceGrowth& growth) {
  const replay::Separation& separation = growth.separation;
  Json json = {{"kind", kind_of(separation)}, {"marks", Json::array()}};
  for (const replay::SeparationMark& mark : separation.marks)
    json["marks"].push_back({{"above", mark.above}, {"step", mark.step}, {"body", mark.body}});
  json["lost"] = lost_json(separation.lost);
  json["contacts_from"] = step_or_null(separation.contacts_from);
  json["first_contact"] = nullptr;
  if (const auto& first = separation.first_contact)
    json["first_contact"] = {{"bodies", {first->pair.first, first->pair.second}}, {"difference", first->words}};
  json["freezing_from"] = step_or_null(separation.freezing_from);
  json["bodies_from"] = step_or_null(separation.bodies_from);
  json["clocks"] = clocks_json(separation.clocks);
  json["channels"] = Json::array();
  for (const replay::ChannelSeparation& channel : separation.channels)
    json["channels"].push_back(channel_separation_json(channel));
  json["largest"] = row_json(separation.largest);
  json["last"] = row_json(separation.rows.back());
  json["metrics"] = growth.not_measured.empty() ? Json::array() : Json(nullptr);
  for (const replay::MovedMetric& m : growth.metrics)
    json["metrics"].push_back({{"name", m.name}, {"unit", m.unit}, {"expected", number(m.a)}, {"actual", number(m.b)}});
  json["steps"] = Json::array();
  const std::size_t stride = separation.rows.size() / kRowsJson + 1;
  for (std::size_t i = 0; i < separation.rows.size(); i += stride)
    json["steps"].push_back(row_json(separation.rows[i]));
  return json;
}

void print_location(const replay::DivergenceLocation& location, const Sides& sides) {
  if (!location.not_taken.empty()) {
    std::cout << "  the step could not be taken again: " << printable(location.not_taken) << '\n';
    return;
  }
  Listing listing;
  if (location.taken) listing.add("  this build", match_text(location, sides));
  if (!location.bodies.empty())
    listing.add("  after it", count_text(location.bodies.size(), "body") + " in another state");
  for (std::size_t i = 0; i < std::min(kContactsShown, location.contacts.size()); ++i) {
    listing.add(i == 0 ? "  contacts" : "", sides.named(replay::describe(location.contacts[i])));
  }
  const std::size_t contacts = location.contacts.size();
  if (contacts > kContactsShown) listing.add("", std::to_string(contacts - kContactsShown) + " more (all with --json)");
  listing.print();
}

Json location_json(const replay::DivergenceLocation& location) {
  Json json;
  json["this_build_follows"] = location.taken ? Json(follows(location)) : Json(nullptr);
  json["bodies"] = location.bodies;
  json["contacts"] = Json::array();
  for (const replay::StepContact& contact : location.contacts) {
    json["contacts"].push_back({{"substep", contact.substep},
                                {"bodies", contact.b ? Json{contact.a, *contact.b} : Json{contact.a}},
                                {"normal", {contact.normal.x(), contact.normal.y(), contact.normal.z()}},
                                {"depth", contact.depth},
                                {"impulse", contact.impulse}});
  }
  return json;
}

void print_difference(const replay::DifferenceReport& report, Compared compared, const Sides& sides) {
  print_headlines(report, sides);
  print_divergence(report.first, sides);
  if (compared == Compared::kTwoLogs) {
    print_location(report.location, sides);
  } else {
    Listing contacts;
    for (const replay::StepContact& contact : report.location.contacts)
      contacts.add("  contact", replay::describe(contact));
    contacts.print();
  }
  if (report.growth) {
    print_growth(*report.growth, sides);
  } else if (compared == Compared::kTwoLogs) {
    std::cout << "the growth of the difference is not known: " << printable(report.growth_unknown) << '\n';
  }
}

void add_difference(const replay::DifferenceReport& report, Compared compared, Json& json) {
  json["cause"] = report.cause;
  json["effect"] = report.effect ? divergence_json(*report.effect) : Json(nullptr);
  if (compared == Compared::kTwoLogs) json["narrowed"] = location_json(report.location);
  if (report.growth) json["aftermath"] = growth_json(*report.growth);
}

}  // namespace tumble::tools
