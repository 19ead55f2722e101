#include "tools/compare/blame_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "golden/run/external_engine.h"
#include "tools/output/divergence_output.h"

namespace tumble::tools {
namespace {

std::string value_text(const replay::FieldValue& value, const std::string& unit) {
  std::string text = printable(replay::to_string(value));
  if (!unit.empty() && std::holds_alternative<double>(value)) text += ' ' + unit;
  return text;
}

std::string place_text(const replay::BlameAnswer& answer) {
  if (answer.phase == "start") return "step " + std::to_string(answer.step) + ", start";
  if (answer.phase == "inputs") return "before step " + std::to_string(answer.step) + ", input";
  if (answer.phase == "lost") return "step " + std::to_string(answer.step) + ", lost";
  std::string text = "step " + std::to_string(answer.step);
  if (answer.substep) text += " substep " + std::to_string(*answer.substep);
  return text + ", " + answer.phase;
}

std::string change_text(const replay::BlameAnswer& answer) {
  std::string text = answer.value + ' ';
  const std::string after = value_text(answer.after, answer.unit);
  // What kept a value as it is: a body at rest that nothing woke.
  if (answer.before && value_text(*answer.before, answer.unit) == after) return text + after + ", unchanged";
  if (answer.before) text += value_text(*answer.before, "") + " -> ";
  return text + after;
}

Json vector_json(const sim::Vec3& v) { return {number_json(v.x()), number_json(v.y()), number_json(v.z())}; }

std::string vector_text(const sim::Vec3& v) {
  return significant(v.x(), 4) + ' ' + significant(v.y(), 4) + ' ' + significant(v.z(), 4);
}

Json share_json(const replay::BlameShare& share) {
  Json json;
  json["kind"] = share.kind;
  if (share.kind == "contact") json["with"] = share.other ? Json(*share.other) : Json(nullptr);
  json["amount"] = number_json(share.amount);
  return json;
}

Json answer_json(const replay::BlameAnswer& answer) {
  Json json;
  json["step"] = answer.step;
  json["substep"] = answer.substep ? Json(*answer.substep) : Json(nullptr);
  json["phase"] = answer.phase;
  json["body"] = answer.body ? Json(*answer.body) : Json(nullptr);
  json["contact"] = nullptr;
  if (answer.contact) json["contact"] = {{"with", answer.other ? Json(*answer.other) : Json(nullptr)}};
  json["value"] = answer.value;
  json["unit"] = answer.unit;
  json["before"] = answer.before ? value_json(*answer.before) : Json(nullptr);
  json["after"] = value_json(answer.after);
  json["shares"] = Json::array();
  for (const replay::BlameShare& share : answer.shares) json["shares"].push_back(share_json(share));
  json["exact"] = answer.exact;
  json["origin"] = answer.origin;
  json["text"] = answer.text;
  return json;
}

}  // namespace

void print_blame(const replay::Blame& blame) {
  for (const std::string& note : blame.notes) std::cout << "note: " << printable(note) << '\n';
  const replay::BlameQuestion& asked = blame.question;
  std::cout << "body " << asked.body << ' ' << printable(asked.field) << " after step " << asked.step << ": "
            << value_text(blame.value, blame.unit) << '\n';
  for (std::size_t k = 0; k < blame.answers.size(); ++k) {
    const replay::BlameAnswer& answer = blame.answers[k];
    const std::string number = padded_left(std::to_string(k + 1), 3);
    std::cout << number << "  " << place_text(answer) << ": ";
    if (answer.contact) {
      std::cout << printable(answer.text) << '\n';
      continue;
    }
    std::cout << "body " << *answer.body << ' ' << change_text(answer) << '\n';
    if (!answer.text.empty()) std::cout << "     " << printable(answer.text) << '\n';
    if (!answer.origin.empty()) std::cout << "     " << printable(answer.origin) << '\n';
  }
  if (!blame.ends.empty())
    std::cout << (blame.complete ? "began there: " : "ends there: ") << printable(blame.ends) << '\n';
}

Json blame_json(const replay::Blame& blame) {
  Json json;
  json["body"] = blame.question.body;
  json["field"] = blame.question.field;
  json["step"] = blame.question.step;
  json["value"] = value_json(blame.value);
  json["unit"] = blame.unit;
  json["answers"] = Json::array();
  for (const replay::BlameAnswer& answer : blame.answers) json["answers"].push_back(answer_json(answer));
  json["complete"] = blame.complete;
  json["ends"] = blame.ends;
  json["notes"] = blame.notes;
  return json;
}

std::string blame_command(const std::string& log, const replay::Divergence& difference) {
  const bool of_body = difference.body && replay::is_in_state(difference) && !replay::is_body_missing(difference);
  if (!of_body) return "";
  return "tumble blame " + shell_quoted(log) + " --body " + std::to_string(*difference.body) + " --field " +
         difference.field + " --step " + std::to_string(difference.step) + " --back 5";
}

void print_contacts(const replay::BodyContacts& contacts) {
  for (const std::string& note : contacts.notes) std::cout << "note: " << printable(note) << '\n';
  Listing listing;
  listing.add("body", std::to_string(contacts.body) + ", step " + std::to_string(contacts.step));
  listing.add("mass", rounded(contacts.mass, "kg"));
  if (contacts.borne) listing.add("bears", rounded(*contacts.borne, "kg"));
  if (contacts.lent && *contacts.lent != 0) listing.add("is lent", rounded(*contacts.lent, "kg of inertia"));
  constexpr std::size_t kShown = 12;
  std::string island;
  for (std::size_t k = 0; k < std::min(kShown, contacts.island.size()); ++k) {
    island += (k == 0 ? "" : ", ") + std::to_string(contacts.island[k]);
  }
  if (contacts.island.size() > kShown) island += " and " + std::to_string(contacts.island.size() - kShown) + " more";
  listing.add("island", count_text(contacts.island.size(), "body") + ": " + island);
  if (contacts.contacts.empty()) listing.add("contacts", "none in this step");
  listing.print();
  if (contacts.contacts.empty()) return;
  std::cout << '\n';
  Table table({">substep", "with", "normal", ">impulse N s", ">friction N s", "point", ">depth m", ">impulse N s", ""});
  for (const replay::BodyContact& contact : contacts.contacts) {
    const std::string with = contact.other ? "body " + std::to_string(*contact.other) : "the ground";
    const char* kind = contact.asleep ? "asleep" : contact.fast ? "fast pair" : "";
    table.add({std::to_string(contact.substep), with, vector_text(contact.normal), significant(contact.impulse, 4),
               significant(sim::length(contact.friction), 4), "", "", "", kind});
    for (const replay::BodyContactPoint& point : contact.points) {
      table.add(
          {"", "", "", "", "", vector_text(point.at), significant(point.depth, 4), significant(point.impulse, 4), ""});
    }
  }
  table.print();
}

Json contacts_json(const replay::BodyContacts& contacts) {
  const auto or_null = [](const std::optional<double>& value) { return value ? number_json(*value) : Json(nullptr); };
  Json json;
  json["body"] = contacts.body;
  json["step"] = contacts.step;
  json["mass"] = contacts.mass;
  json["island"] = contacts.island;
  json["borne"] = or_null(contacts.borne);
  json["lent"] = or_null(contacts.lent);
  json["contacts"] = Json::array();
  for (const replay::BodyContact& contact : contacts.contacts) {
    Json one;
    one["substep"] = contact.substep;
    one["with"] = contact.other ? Json(*contact.other) : Json(nullptr);
    one["normal"] = vector_json(contact.normal);
    one["impulse"] = number_json(contact.impulse);
    one["friction"] = vector_json(contact.friction);
    one["twist"] = number_json(contact.twist);
    one["asleep"] = contact.asleep;
    one["fast"] = contact.fast;
    one["points"] = Json::array();
    for (const replay::BodyContactPoint& point : contact.points) {
      one["points"].push_back({{"at", vector_json(point.at)},
                               {"depth", number_json(point.depth)},
                               {"impulse", number_json(point.impulse)},
                               {"load", number_json(point.load)}});
    }
    json["contacts"].push_back(std::move(one));
  }
  json["notes"] = contacts.notes;
  return json;
}

}  // namespace tumble::tools
