#include "tools/output/side_by_side.h"

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "replay/diff/difference_report.h"
#include "replay/diff/input_difference.h"
#include "replay/diff/step_contacts.h"
#include "replay/format/little_endian.h"
#include "replay/log/hashes_only.h"
#include "replay/session/state_source.h"
#include "tools/output/axes_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/extras_output.h"
#include "tools/output/text.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/tolerance.h"

namespace tumble::tools {
namespace {
constexpr std::size_t kBodiesShown = 12;

Json inputs_json(const replay::StepRecord& record) {
  Json names = Json::array();
  for (const sim::Command& input : record.inputs) names.push_back(sim::name_of(input));
  return names;
}

std::string word_text(const replay::StepRecord& record, std::size_t word) {
  return word < record.phase_words.size() ? hex_text(record.phase_words[word]) : "-";
}

/// One row a substep and phase; none where the two have different phases.
Json phases_json(const replay::StepRecord& a, const replay::StepRecord& b, const std::vector<std::string>& phases) {
  Json rows = Json::array();
  const std::size_t words = std::max(a.phase_words.size(), b.phase_words.size());
  for (std::size_t w = 0; w < words && !phases.empty(); ++w) {
    const std::string in_a = word_text(a, w), in_b = word_text(b, w);
    rows.push_back({{"substep", w / phases.size()},
                    {"phase", phases[w % phases.size()]},
                    {"a", in_a},
                    {"b", in_b},
                    {"same", in_a == in_b}});
  }
  return rows;
}

/// The kind of the two logs, which decides what can be compared.
struct Kind {
  bool same_words = false;     ///< phase words and contacts mean the same
  bool imported = false;       ///< by another engine, which counts neither pairs nor contacts nor what it dissipates
  bool binary32 = false;       ///< ULPs are those of floats
  replay::EngineAxes axes;     ///< that name fields
  bool values_in_one = false;  ///< the other holds hashes: only the lengths of steps are in both
  bool no_states = false;      ///< a log holds hashes, so no inputs, states and energies are there
};

Json values_json(const replay::StepRecord& a, const replay::StepRecord& b, const Kind& kind) {
  Json rows = Json::array();
  const auto add = [&](const char* name, const Json& in_a, const Json& in_b, bool same) {
    rows.push_back({{"name", name}, {"a", in_a}, {"b", in_b}, {"same", same}});
  };
  const auto number = [&](const char* name, double in_a, double in_b) {
    add(name, number_json(in_a), number_json(in_b), replay::bits_of(in_a) == replay::bits_of(in_b));
  };
  number("dt", a.dt, b.dt);
  if (kind.no_states) return rows;
  add("inputs", inputs_json(a), inputs_json(b), !replay::first_difference(std::span(a.inputs), std::span(b.inputs)));
  const auto count = [&](const char* name, std::uint32_t in_a, std::uint32_t in_b) {
    add(name, in_a, in_b, in_a == in_b);
  };
  if (!kind.imported) {
    count("substeps", a.counters.substeps, b.counters.substeps);
    count("pairs", a.counters.pairs, b.counters.pairs);
  }
  if (kind.same_words && !kind.imported) count("contacts", a.counters.contacts, b.counters.contacts);
  number("kinetic", a.counters.kinetic, b.counters.kinetic);
  number("potential", a.counters.potential, b.counters.potential);
  number("input_energy", a.counters.inputs, b.counters.inputs);
  if (!kind.imported) number("removed_energy", a.counters.removed, b.counters.removed);
  add("state_hash", to_string(a.state_hash), to_string(b.state_hash), a.state_hash == b.state_hash);
  return rows;
}

/// The fields that differ, of body i of a and body j of b.
Json fields_json(const replay::BodyStates& a, std::size_t i, const replay::BodyStates& b, std::size_t j,
                 const Kind& kind) {
  Json fields = Json::array();
  const replay::ConstColumns in_a = replay::columns_of(a), in_b = replay::columns_of(b);
  for (std::size_t c = 0; c < replay::kColumnCount; ++c) {
    const double one = (*in_a[c])[i], other = (*in_b[c])[j];
    if (replay::bits_of(one) == replay::bits_of(other)) continue;
    replay::Divergence shown;
    shown.field = replay::kColumnNames[c];
    shown.expected = one;
    shown.actual = other;
    shown = in_axes(kind.axes, std::move(shown));
    const double shown_a = std::get<double>(shown.expected), shown_b = std::get<double>(shown.actual);
    const std::optional<std::uint64_t> ulps =
        kind.binary32 ? replay::ulps32_between(one, other) : replay::ulps_between(one, other);
    fields.push_back({{"field", shown.field},
                      {"a", number_json(shown_a)},
                      {"b", number_json(shown_b)},
                      {"a_hex", hex_text(shown_a)},
                      {"b_hex", hex_text(shown_b)},
                      {"ulps", ulps ? Json(*ulps) : Json(nullptr)}});
  }
  const bool sleeps_in_a = a.frozen[i] != 0, sleeps_in_b = b.frozen[j] != 0;
  if (sleeps_in_a != sleeps_in_b) fields.push_back({{"field", "frozen"}, {"a", sleeps_in_a}, {"b", sleeps_in_b}});
  return fields;
}

/// Bodies that differ, or that one of the two lacks.
Json bodies_json(const replay::BodyStates& a, const replay::BodyStates& b, const Kind& kind) {
  Json bodies = Json::array();
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const bool only_a = j == b.size() || (i < a.size() && a.id[i] < b.id[j]);
    const bool only_b = !only_a && (i == a.size() || b.id[j] < a.id[i]);
    if (only_a || only_b) {
      bodies.push_back({{"id", only_a ? a.id[i] : b.id[j]}, {"only_in", only_a ? "a" : "b"}});
    } else if (Json fields = fields_json(a, i, b, j, kind); !fields.empty()) {
      bodies.push_back({{"id", a.id[i]}, {"fields", std::move(fields)}});
    }
    if (!only_b) ++i;
    if (!only_a) ++j;
  }
  return bodies;
}

/// Takes the step again from both logs: whether it comes out as recorded, the number of contacts, and the first contact
/// that differs.
Json contacts_json(replay::LogReader& a, replay::LogReader& b, std::uint64_t k) {
  if (k <= a.first_state() || k <= b.first_state()) return nullptr;
  const Result<replay::RetakenStep> in_a = replay::retake_step(a, k);
  const Result<replay::RetakenStep> in_b = replay::retake_step(b, k);
  if (!in_a.ok() || !in_b.ok()) return nullptr;
  Json json = {{"a_as_recorded", in_a->same},
               {"b_as_recorded", in_b->same},
               {"a", in_a->contacts.size()},
               {"b", in_b->contacts.size()},
               {"first", nullptr}};
  const std::size_t both = std::min(in_a->contacts.size(), in_b->contacts.size());
  for (std::size_t i = 0; i < both; ++i) {
    const std::string one = replay::describe(in_a->contacts[i]), other = replay::describe(in_b->contacts[i]);
    if (one == other) continue;
    json["first"] = {{"a", one}, {"b", other}};
    break;
  }
  return json;
}

std::string cell(const Json& value) {
  if (value.is_string()) return printable(value.get<std::string>());
  return value.is_number_float() ? exact(value.get<double>()) : value.dump();
}

void print_fields(const Json& body, Table& table) {
  const std::string id = body["id"].dump();
  if (body.contains("only_in")) {
    table.add({"  " + id, "only in " + body["only_in"].get<std::string>(), "", "", ""});
    return;
  }
  for (const Json& field : body["fields"]) {
    const std::string name = field["field"];
    if (!field.contains("ulps")) {
      table.add({"  " + id, name, cell(field["a"]), cell(field["b"]), ""});
      continue;
    }
    table.add(
        {"  " + id, name, cell(field["a"]), cell(field["b"]), field["ulps"].is_null() ? "" : field["ulps"].dump()});
    table.add({"", "", cell(field["a_hex"]), cell(field["b_hex"]), ""});
  }
}

/// One step of two logs.
struct SideBySide {
  bool same = false;  ///< in every bit that both logs hold of it
  Json json;
};

Result<SideBySide> step_side_by_side(replay::LogReader& a, replay::LogReader& b, std::uint64_t k) {
  replay::StateSource source_a(a), source_b(b);
  // A log without states, in a build that cannot simulate them, still has hashes to show.
  const auto record_of = [k](replay::LogReader& log, replay::StateSource& source) {
    Result<const replay::StepRecord*> record = source.read(k);
    return record.ok() || record.error().kind != ErrorKind::kCannotFinish ? record : log.read_hashes(k);
  };
  const Result<const replay::StepRecord*> read_a = record_of(a, source_a);
  if (!read_a.ok()) return read_a.error();
  const Result<const replay::StepRecord*> read_b = record_of(b, source_b);
  if (!read_b.ok()) return read_b.error();
  const replay::StepRecord& in_a = **read_a;
  replay::StepRecord in_b = **read_b;
  if (Status ok = check_states(a, in_a); !ok.ok()) return ok.error();
  if (Status ok = check_states(b, in_b); !ok.ok()) return ok.error();
  const Kind kind = {
      replay::same_phase_words(a.header(), b.header()),      a.header().engine || b.header().engine,
      replay::in_binary32(a.header(), b.header()),           common_axes(a.header(), b.header()),
      replay::one_holds_hashes_only(a.header(), b.header()), replay::lack_states(a.header(), b.header())};
  const bool signs = kind.imported && replay::forgive_zeros(in_a, in_b) > 0;
  if (signs && replay::same_bits(in_a.states, in_b.states)) in_b.state_hash = in_a.state_hash;

  SideBySide step;
  Json& json = step.json = {{"step", k}, {"same", false}};
  std::string note = replay::phase_hash_note(a.header(), b.header());
  const bool held = a.header().hashes.holds(k) && b.header().hashes.holds(k);
  if (note.empty() && !held)
    note = "phase hashes: a log holds none of step " + std::to_string(k) + ", so none compared";
  json["note"] = note;
  json["values"] = values_json(in_a, in_b, kind);
  if (!kind.values_in_one) add_extra_differences(a, b, in_a, in_b, json["values"]);
  const bool all = add_left_out(a, b, json);
  const bool have_words = replay::same_phase_words(a.header(), b.header(), k);
  json["phases"] = phases_json(in_a, in_b, have_words ? a.header().phases : std::vector<std::string>());
  const bool have_states = in_a.has_states && in_b.has_states && !kind.no_states;
  json["bodies"] = have_states ? bodies_json(in_a.states, in_b.states, kind) : Json(nullptr);
  json["axes"] = kind.axes.ours() ? Json(nullptr) : axes_json(kind.axes);
  const auto same_rows = [](const Json& rows) {
    return std::ranges::all_of(rows, [](const Json& row) { return row["same"].get<bool>(); });
  };
  step.same = all && same_rows(json["values"]) && same_rows(json["phases"]) && (!have_states || json["bodies"].empty());
  json["same"] = step.same;
  json["read"] = "the chunks with this step; not the rest of the logs";
  json["states"] = have_states;
  json["contacts"] = contacts_json(a, b, k);
  return step;
}

void print_text(const SideBySide& step, const Sides& sides) {
  const Json& json = step.json;
  std::cout << "step " << json["step"].dump() << ": " << (step.same ? "the same" : "different") << "\n  read  "
            << cell(json["read"]) << (json["states"].get<bool>() ? "" : "; states not compared: a log holds none of it")
            << "\n\n";
  const auto verdict = [](const Json& row) { return row["same"].get<bool>() ? "same" : "DIFFERENT"; };
  Table values({"  value", sides.expected, sides.actual, ""});
  for (const Json& row : json["values"]) {
    values.add({"  " + cell(row["name"]), cell(row["a"]), cell(row["b"]), verdict(row)});
  }
  values.print();
  print_left_out(json, sides);
  if (const std::string note = json["note"]; !note.empty()) std::cout << '\n' << note << '\n';
  if (!json["phases"].empty()) {
    std::cout << '\n';
    std::size_t on_one_side = 0;
    Table phases({">  substep", "phase", "hash in " + sides.expected, "hash in " + sides.actual, ""});
    for (const Json& row : json["phases"]) {
      if (row["a"] == "-" || row["b"] == "-") {
        ++on_one_side;
        continue;
      }
      phases.add({row["substep"].dump(), cell(row["phase"]), cell(row["a"]), cell(row["b"]), verdict(row)});
    }
    phases.print();
    if (on_one_side > 0) std::cout << "  (substeps that only one of them has are left out)\n";
  }
  if (!json["axes"].is_null()) std::cout << "\nfields are named by the engine's axes\n";
  if (const std::size_t count = json["bodies"].size(); count > 0) {  // null has none
    std::cout << '\n' << count_text(count, "body") << " differ" << (count == 1 ? "s" : "");
    if (count > kBodiesShown) std::cout << "; the first " << kBodiesShown << " (all with --json)";
    std::cout << '\n';
    Table bodies({"  body", "field", sides.expected, sides.actual, ">ULPs"});
    for (std::size_t i = 0; i < std::min(count, kBodiesShown); ++i) print_fields(json["bodies"][i], bodies);
    bodies.print();
  }
  const Json& contacts = json["contacts"];
  if (contacts.is_null()) return;
  const auto recorded = [&](const char* key) { return contacts[key].get<bool>() ? "as recorded" : "not as recorded"; };
  std::cout << "\ntaken again by this build: " << sides.expected << ' ' << recorded("a_as_recorded") << ", "
            << contacts["a"].dump() << " contacts; " << sides.actual << ' ' << recorded("b_as_recorded") << ", "
            << contacts["b"].dump() << " contacts\n";
  if (contacts["first"].is_null()) return;
  std::cout << "  first contact that differs\n    " << sides.expected << "  " << cell(contacts["first"]["a"])
            << "\n    " << sides.actual << "  " << cell(contacts["first"]["b"]) << '\n';
}

}  // namespace

Result<bool> print_side_by_side(replay::LogReader& a, replay::LogReader& b, std::uint64_t k, bool as_json) {
  const Result<SideBySide> step = step_side_by_side(a, b, k);
  if (!step.ok()) return step.error();
  if (as_json) {
    print_json("diff", step->json);
  } else {
    print_text(*step, sides_of(a.name(), b.name()));
  }
  return step->same;
}

}  // namespace tumble::tools
