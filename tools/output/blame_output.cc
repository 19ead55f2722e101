#include "tools/output/blame_output.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

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
  std::string text = "step " + std::to_string(answer.step);
  if (answer.substep) text += " substep " + std::to_string(*answer.substep);
  return text + ", " + answer.phase;
}

std::string change_text(const replay::BlameAnswer& answer) {
  std::string text = answer.value + ' ';
  if (answer.before) text += value_text(*answer.before, "") + " -> ";
  return text + value_text(answer.after, answer.unit);
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

}  // namespace tumble::tools
