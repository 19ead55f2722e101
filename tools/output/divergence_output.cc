#include "tools/output/divergence_output.h"

#include <bit>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

namespace tumble::tools {
namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json hex_json(const replay::FieldValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? Json(nullptr) : Json(hex_text(*number));
}

// Doubles also by their bits, because two that differ may print alike.
std::string value_text(const replay::FieldValue& value) {
  std::string text = printable(replay::to_string(value));
  if (const auto* number = std::get_if<double>(&value)) text += "  " + hex_text(*number);
  return text;
}

Json value_json(const replay::FieldValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

}  // namespace

Json comparison_json(bool identical, std::uint64_t steps, const std::optional<replay::Divergence>& first) {
  Json json;
  json["identical"] = identical;
  json["steps"] = steps;
  json["first"] = nullptr;
  if (!first) return json;
  Json& out = json["first"] = Json::object();
  out["step"] = first->step;
  out["substep"] = or_null(first->substep);
  out["phase"] = first->phase;
  out["body"] = or_null(first->body);
  out["pair"] = first->pair ? Json{first->pair->first, first->pair->second} : Json(nullptr);
  out["field"] = first->field;
  out["expected"] = value_json(first->expected);
  out["actual"] = value_json(first->actual);
  out["ulps"] = or_null(first->ulps);
  out["expected_hex"] = hex_json(first->expected);
  out["actual_hex"] = hex_json(first->actual);
  return json;
}

std::string hex_text(double value) { return hex_text(std::bit_cast<std::uint64_t>(value)); }

std::string hex_text(std::uint64_t word) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "0x";
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(word >> shift) & 15];
  return text;
}

void print_divergence(const replay::Divergence& first) {
  Listing listing;
  listing.add("  step", std::to_string(first.step));
  if (first.substep) listing.add("  substep", std::to_string(*first.substep));
  listing.add("  phase", first.phase);
  if (first.body) listing.add("  body", std::to_string(*first.body));
  if (first.pair) {
    listing.add("  pair", std::to_string(first.pair->first) + " and " + std::to_string(first.pair->second));
  }
  listing.add("  field", first.field);
  listing.add("  expected", value_text(first.expected));
  listing.add("  actual", value_text(first.actual));
  if (first.ulps) listing.add("  apart", std::to_string(*first.ulps) + " ULPs");
  listing.print();
}

}  // namespace tumble::tools
