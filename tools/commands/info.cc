// tumble info: the header of a log, its counts, and a check of every hash.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "replay/log/log_facts.h"
#include "replay/log/verify.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/output/axes_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

using replay::LogCondition;
using replay::LogFacts;
using replay::LogHeader;
using replay::LogReader;

struct InfoCommand {
  std::string log;
  bool json = false;
};

std::string version_of(const LogHeader& header) {
  return std::to_string(header.format_major) + '.' + std::to_string(header.format_minor);
}

std::string inputs_text(const LogFacts& facts) {
  std::string text;
  for (const auto& [kind, count] : facts.inputs) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " × " + kind;
  }
  return text.empty() ? "none" : text;
}

std::string channels_text(const replay::Declared& declared) {
  std::string text;
  for (const std::size_t c : listed_order(declared.channels)) {
    const replay::Channel& channel = declared.channels[c];
    text += (text.empty() ? "" : ", ") + channel.name + " (" + name_of(channel.type.kind) + " of " +
            name_of(channel.type.scope) + ")";
  }
  return text;
}

/// The scene's dt, or what the steps have in its place.
std::string dt_text(const LogHeader& header, const LogFacts& facts) {
  if (header.engine && !facts.dt_min) return "not told: there is no step";
  if (!facts.dt_min || *facts.dt_min == *facts.dt_max)
    return exact(facts.dt_min.value_or(header.scene.world.dt)) + " s";
  return exact(*facts.dt_min) + " to " + exact(*facts.dt_max) + " s, varies";
}

void add_header(Listing& listing, const LogHeader& header, const LogFacts& facts) {
  listing.add("scene", printable(header.scene.name));
  if (!header.scene.title.empty()) listing.add("title", printable(header.scene.title));
  if (!header.scene.category.empty()) listing.add("category", printable(header.scene.category));
  if (!header.overrides.empty()) listing.add("set", printable(joined(header.overrides, ", ")));
  if (header.goes_on) {
    listing.add("goes on from",
                "step " + std::to_string(header.goes_on->step) + " of " + printable(header.goes_on->log));
  }
  if (!header.transform.identity()) listing.add("image", to_string(header.transform));
  if (header.engine) {
    const char* numbers = header.engine->precision_bits == replay::kBinary32Bits ? ", computes in binary32" : "";
    listing.add("engine", printable(to_string(*header.engine)) + numbers);
    listing.add("axes", to_string(header.axes()));
    if (header.table && !header.table->passed_over.empty()) {
      listing.add("passed over", "columns " + printable(joined(header.table->passed_over, ", ")) + " of the table");
    }
    if (!header.declared.channels.empty()) listing.add("channels", printable(channels_text(header.declared)));
  } else {
    listing.add("method", printable(header.method) + ", version " + std::to_string(header.method_version));
  }
  listing.add("dt", dt_text(header, facts));
  if (!header.phases.empty()) listing.add("phases", printable(joined(header.phases, ", ")));
  if (!header.engine) {
    const std::uint32_t every = header.hashes.every;
    const std::string of = every == 0 ? ", of no step" : ", of one step in " + std::to_string(every);
    listing.add("phase hashes", "version " + std::to_string(header.phase_hash_version) + (every == 1 ? "" : of));
  }
  listing.add("states", to_string(header.states));
  listing.add("format", version_of(header) + ", " + printable(header.float_format));
  listing.add("written by", "tumble " + printable(header.tool_version) + ", " + printable(header.tool_build));
}

void print_text(const LogReader& log, const LogFacts& facts, const LogCondition& condition) {
  Listing listing;
  listing.add("log", log.name());
  add_header(listing, log.header(), facts);
  std::string bodies = std::to_string(facts.bodies_at_start + facts.bodies_thrown);
  if (facts.bodies_thrown > 0) bodies += ", " + std::to_string(facts.bodies_thrown) + " of them thrown in";
  listing.add("bodies", bodies);
  listing.add("steps", std::to_string(log.step_count()) + ", " + seconds_text(facts.seconds));
  listing.add("inputs", inputs_text(facts));
  listing.add("chunks", std::to_string(log.chunks().size()));
  const std::optional<double> each = facts.bytes_per_moving_body_step(log.file_bytes());
  const std::string per_step = each ? ", " + rounded(*each, "bytes per moving body-step") : "";
  listing.add("size", bytes_text(log.file_bytes()) + per_step);
  listing.add("final hash", facts.final_hash ? to_string(*facts.final_hash) : "none");
  if (!facts.told.empty()) listing.add("cut", printable(facts.told));
  const std::string& cut_short = log.header().declared.cut_short;
  listing.add("condition", !condition.whole()  ? condition.summary(log.last_step())
                           : cut_short.empty() ? "whole, every hash as written"
                                               : "every hash as written; the session may have gone on: " + cut_short);
  listing.print();
}

void put_header(Json& json, const LogHeader& header) {
  json["format"] = version_of(header);
  json["tool_version"] = header.tool_version;
  json["tool_build"] = header.tool_build;
  json["engine"] = nullptr;
  if (header.engine) {
    json["engine"] = {{"name", header.engine->name},
                      {"version", header.engine->version},
                      {"precision_bits", header.engine->precision_bits}};
  }
  json["axes"] = axes_json(header.axes());
  json["passed_over"] = header.table ? Json(header.table->passed_over) : Json::array();
  json["channels"] = Json::array();
  for (const std::size_t c : listed_order(header.declared.channels)) {
    const replay::Channel& channel = header.declared.channels[c];
    json["channels"].push_back({{"name", channel.name},
                                {"kind", name_of(channel.type.kind)},
                                {"scope", name_of(channel.type.scope)},
                                {"unit", channel.unit}});
  }
  json["method"] = header.method;
  json["method_version"] = header.method_version;
  json["float_format"] = header.float_format;
  json["phases"] = header.phases;
  json["phase_hash_version"] = header.phase_hash_version;
  json["scene"] = {{"name", header.scene.name}, {"title", header.scene.title}, {"category", header.scene.category}};
  json["set"] = header.overrides;
  json["goes_on"] = nullptr;
  if (header.goes_on) {
    json["goes_on"] = {{"log", header.goes_on->log},
                       {"step", header.goes_on->step},
                       {"continuation_hash", to_string(header.goes_on->continuation_hash)}};
  }
  json["transform"] = to_string(header.transform);
  json["dt"] = header.scene.world.dt;
  json["planned_steps"] = header.scene.steps;
  json["states"] = to_string(header.states);
  json["hashes"] = to_string(header.hashes);
}

void print_as_json(const LogReader& log, const LogFacts& facts, const LogCondition& condition) {
  Json json;
  json["log"] = log.name();
  put_header(json, log.header());
  json["bodies"] = facts.bodies_at_start + facts.bodies_thrown;
  json["bodies_at_start"] = facts.bodies_at_start;
  json["steps"] = log.step_count();
  json["first_state"] = log.first_state();
  json["seconds"] = facts.seconds;
  json["dt_min"] = facts.dt_min ? Json(*facts.dt_min) : Json(nullptr);
  json["dt_max"] = facts.dt_max ? Json(*facts.dt_max) : Json(nullptr);
  json["chunks"] = log.chunks().size();
  json["inputs"] = Json::object();
  for (const auto& [kind, count] : facts.inputs) json["inputs"][kind] = count;
  json["bytes"] = log.file_bytes();
  json["moving_body_steps"] = facts.moving_body_steps ? Json(*facts.moving_body_steps) : Json(nullptr);
  const std::optional<double> each = facts.bytes_per_moving_body_step(log.file_bytes());
  json["bytes_per_moving_body_step"] = each ? Json(*each) : Json(nullptr);
  json["whole"] = condition.whole();
  json["cut_values"] = facts.told;
  json["cut_short"] = log.header().declared.cut_short;
  json["torn"] = condition.torn;
  json["torn_at_byte"] = condition.torn ? Json(condition.torn_offset) : Json(nullptr);
  json["damages"] = Json::array();
  for (const replay::Damage& damage : condition.damages) {
    json["damages"].push_back(
        {{"record", replay::name_of(damage.kind)}, {"byte", damage.offset}, {"message", damage.message}});
  }
  json["final_hash"] = facts.final_hash ? Json(to_string(*facts.final_hash)) : Json(nullptr);
  print_json("info", json);
}

Result<Exit> info(const InfoCommand& options) {
  Result<LogReader> log = LogReader::open(options.log);
  if (!log.ok()) return log.error();
  ProgressBar bar("reading");
  const replay::VerifyReport report = replay::verify(*log, bar.progress());
  const LogFacts facts = replay::collect_facts(*log, bar.progress());
  bar.finish();
  if (options.json) {
    print_as_json(*log, facts, report.condition);
  } else {
    print_text(*log, facts, report.condition);
  }
  if (report.condition.whole()) return Exit::kSame;
  std::cerr << "tumble info: " << log->name() << ": " << report.condition.summary(log->last_step()) << '\n';
  return Exit::kDamaged;
}

}  // namespace

Action declare_info(Arguments& arguments) {
  auto options = std::make_shared<InfoCommand>();
  arguments.positional("LOG", options->log, "The log to read").required();
  arguments.json(options->json);
  arguments.footer(
      "Reads every byte and checks every hash. Exit status: 0 whole, 3 damaged or torn; the intact\n"
      "part is printed.\n\n"
      "Examples:\n"
      "  tumble info brick_wall.tumble\n"
      "  tumble info brick_wall.tumble --json");
  return [options] { return info(*options); };
}

}  // namespace tumble::tools
