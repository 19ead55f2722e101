#include "tools/output/divergence_output.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "src/base/text.h"
#include "tumble/replay/body_states.h"

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

}  // namespace

Json value_json(const replay::FieldValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return number_json(*number);
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) return *whole;
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? Json(nullptr) : Json(*text);
}

Json comparison_json(bool identical, std::uint64_t steps, const std::optional<replay::Divergence>& first) {
  Json json;
  json["identical"] = identical;
  json["steps"] = steps;
  json["first"] = first ? divergence_json(*first) : Json(nullptr);
  return json;
}

Json divergence_json(const replay::Divergence& first) {
  Json out = Json::object();
  out["step"] = first.step;
  out["substep"] = or_null(first.substep);
  out["phase"] = first.phase;
  out["body"] = or_null(first.body);
  out["pair"] = first.pair ? Json{first.pair->first, first.pair->second} : Json(nullptr);
  if (!first.names.empty()) out["names"] = first.names;
  out["field"] = first.field;
  out["expected"] = value_json(first.expected);
  out["actual"] = value_json(first.actual);
  out["ulps"] = or_null(first.ulps);
  out["expected_hex"] = hex_json(first.expected);
  out["actual_hex"] = hex_json(first.actual);
  out["note"] = first.note;
  return out;
}

Sides sides_of(const std::string& a, const std::string& b) {
  const std::string name_a = std::filesystem::path(a).filename().string();
  const std::string name_b = std::filesystem::path(b).filename().string();
  if (name_a != name_b) return {printable(name_a), printable(name_b)};
  if (a != b) return {printable(a), printable(b)};
  return {printable(a) + " (A)", printable(b) + " (B)"};
}

Sides sides_of(replay::LogReader& a, replay::LogReader& b) {
  Sides sides = sides_of(a.name(), b.name());
  for (replay::LogReader* log : {&a, &b}) {
    for (const auto& [id, info] : log->bodies().bodies()) {
      if (id >= replay::kIdsOfNames && !info.name.empty()) sides.names.emplace(id, printable(info.name));
    }
  }
  return sides;
}

std::string Sides::body(sim::BodyId id) const {
  const auto found = names.find(id);
  return "body " + (found == names.end() ? std::to_string(id) : found->second);
}

std::string Sides::named(std::string text) const {
  if (names.empty()) return text;
  constexpr std::string_view kDigits = "0123456789";
  std::string named;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = text.find_first_of(kDigits, from)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of(kDigits, at), text.size());
    const bool whole = (at == 0 || text[at - 1] != '.') && (end == text.size() || text[end] != '.');
    sim::BodyId id = 0;
    const std::errc error = std::from_chars(text.data() + at, text.data() + end, id).ec;
    const auto found = whole && error == std::errc() ? names.find(id) : names.end();
    named.append(text, from, at - from);
    named += found == names.end() ? text.substr(at, end - at) : found->second;
    from = end;
  }
  return named + text.substr(from);
}

void name_bodies(replay::LogReader& a, replay::LogReader& b, replay::Divergence& found) {
  const auto name = [&](sim::BodyId id) {
    const std::string in_a = a.bodies().name(id);
    return in_a.empty() ? b.bodies().name(id) : in_a;
  };
  const auto of_pair = [&](sim::BodyId id) {
    if (id == 0) return std::string("the ground");
    const std::string own = name(id);
    return own.empty() ? std::to_string(id) : own;
  };
  if (found.pair) {
    const auto& [one, other] = *found.pair;
    if (!name(one).empty() || !name(other).empty()) found.names = of_pair(one) + " and " + of_pair(other);
  } else if (found.body) {
    found.names = name(*found.body);
  }
}

Status check_states(const replay::LogReader& log, const replay::StepRecord& record) {
  if (!record.has_states || replay::state_hash(record.states) == record.state_hash) return {};
  return damaged(log.name() + ": the log is broken: the states of step " + std::to_string(record.step) +
                 " do not match their state hash");
}

std::string hex_text(double value) { return hex_text(std::bit_cast<std::uint64_t>(value)); }

std::string hex_text(std::uint64_t word) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "0x";
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(word >> shift) & 15];
  return text;
}

void print_divergence(const replay::Divergence& first, const Sides& sides) {
  Listing listing;
  listing.add("  step", std::to_string(first.step));
  if (first.substep) listing.add("  substep", std::to_string(*first.substep));
  listing.add("  phase", first.phase);
  const std::string names = first.names.empty() ? "" : "  (" + printable(first.names) + ")";
  const bool by_name = first.body && sides.names.contains(*first.body);
  if (first.body) {
    const std::string own = by_name ? sides.names.at(*first.body) : std::to_string(*first.body);
    listing.add("  body", own + (first.pair || by_name ? "" : names));
  }
  if (first.pair) {
    const auto of_names = [&](sim::BodyId id) { return sides.names.contains(id); };
    const bool both = of_names(first.pair->first) && of_names(first.pair->second);
    const std::string ids = std::to_string(first.pair->first) + " and " +
                            (first.pair->second == 0 ? "the ground" : std::to_string(first.pair->second));
    listing.add("  pair", both ? printable(first.names) : ids + names);
  }
  if (replay::is_body_missing(first)) {
    listing.add("  found", only_in(first, sides.expected, sides.actual));
    listing.print();
    return;
  }
  listing.add("  field", first.field);
  listing.add("  " + sides.expected, value_text(first.expected));
  listing.add("  " + sides.actual, value_text(first.actual));
  const std::string size = replay::magnitude(first);
  const std::string ulps = first.ulps ? count_text(*first.ulps, "ULP") : "";
  if (!size.empty() || !ulps.empty()) listing.add("  apart", size + (size.empty() || ulps.empty() ? "" : ", ") + ulps);
  if (!first.note.empty()) listing.add("  note", first.note);
  listing.print();
}

std::string clocks_text(const replay::ClockSeparation& clocks) {
  return "up to " + rounded(clocks.largest, "s") + " apart (step " + std::to_string(clocks.largest_step) +
         "): steps are compared by their numbers, and differ in length from step " + std::to_string(clocks.from) +
         " on";
}

Json clocks_json(const std::optional<replay::ClockSeparation>& clocks) {
  if (!clocks) return nullptr;
  return {{"from", clocks->from}, {"largest", number_json(clocks->largest)}, {"largest_step", clocks->largest_step}};
}

std::string read_of(const replay::LogReader& a, const replay::LogReader& b) {
  const bool sound = a.condition().sound() && b.condition().sound();
  return sound ? "every byte of both logs" : "the intact part of both logs";
}

void print_scope(const replay::ComparisonScope& scope) {
  std::string compared;
  for (const std::string& part : scope.compared) compared += (compared.empty() ? "" : ", ") + part;
  Listing listing;
  listing.add("  compared", printable(compared));
  for (std::size_t i = 0; i < scope.not_compared.size(); ++i) {
    listing.add(i == 0 ? "  not compared" : "", printable(scope.not_compared[i]));
  }
  listing.print();
}

std::string effect_text(const replay::Divergence& effect, const Sides& sides) {
  const std::string& phase = effect.phase;
  const std::string from = phase == "step"     ? ""
                           : phase == "start"  ? ", start"
                           : phase == "inputs" ? ", from its inputs on"
                                               : ", from phase " + phase + " on";
  return "step " + std::to_string(effect.step) + from + (effect.body ? ", " + sides.body(*effect.body) : "") + ", " +
         (replay::is_body_missing(effect) ? only_in(effect, sides.expected, sides.actual) : effect.field) +
         replay::apart_words(effect) + (effect.note.empty() ? "" : "; " + effect.note);
}

Json only_in_json(const replay::OnlyInOne& only_in) { return {{"a", only_in.a}, {"b", only_in.b}}; }

void add_scope(const replay::ComparisonScope& scope, Json& json) {
  json["compared"] = scope.compared;
  json["not_compared"] = scope.not_compared;
}

}  // namespace tumble::tools
