// tumble export: a session in the formats of other programs.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "replay/export/export_format.h"
#include "replay/export/plan/export_log.h"
#include "replay/export/plan/export_plan.h"
#include "replay/measure/measure_options.h"
#include "src/files/output_file.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/step_range.h"
#include "tools/files/log_files.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

struct ExportCommand {
  std::string log;
  std::string output;
  std::string steps;
  std::string bodies = "all";
  std::optional<std::uint64_t> every;
  bool json = false;
};

Error named_as_ids(const std::string& word, const std::string& own) {
  return bad_input("--bodies: found " + in_quotes(word) + ", the name of body " + own +
                   " and an id or a range of ids too; wanted " + own + "-" + own +
                   " for that body, or ranges, as 2-2, for the others");
}

/// Errors (kBadInput): the name of a body that reads as the ids of others.
Status check_name(const std::string& word, const replay::BodyTable& table) {
  const Result<replay::BodyChoice> read = replay::parse_bodies(word);
  if (!read.ok() || read->ids.empty()) return {};
  const replay::BodyChoice::Ids ids = read->ids.front();
  for (const auto& [id, info] : table.bodies()) {
    if (info.name != word || (read->ids.size() == 1 && ids.first == id && ids.last == id)) continue;
    return named_as_ids(word, std::to_string(id));
  }
  return {};
}

/// "--bodies": names of bodies beside the words of replay::parse_bodies().
/// watch: gets each body that the choice is asked about.
Result<std::function<bool(const sim::BoxDef&, const std::string&)>> parse_choice(
    const std::string& text, const replay::BodyTable& table, std::shared_ptr<replay::ChoiceWatch>& watch) {
  if (text == "all") return std::function<bool(const sim::BoxDef&, const std::string&)>();
  std::set<std::string> named, names;
  for (const auto& [id, info] : table.bodies()) {
    if (!info.name.empty()) named.insert(info.name);
  }
  if (named.contains(text)) {  // a name may have commas
    if (Status ok = check_name(text, table); !ok.ok()) return ok.error();
    return std::function([text](const sim::BoxDef& /*box*/, const std::string& name) { return name == text; });
  }
  std::string others;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    if (named.contains(word)) {
      if (Status ok = check_name(word, table); !ok.ok()) return ok.error();
      names.insert(word);
    } else {
      others += (others.empty() ? "" : ",") + word;
    }
  }
  replay::BodyChoice choice;
  if (!others.empty() || names.empty()) {
    Result<replay::BodyChoice> parsed = replay::parse_bodies(others);
    if (!parsed.ok()) {
      return bad_input("--" + parsed.error().message +
                       (named.empty() ? std::string() : "; or names of bodies, which 'tumble dump' shows"));
    }
    choice = *std::move(parsed);
  }
  const bool by_choice = !others.empty();
  watch = std::make_shared<replay::ChoiceWatch>(choice);
  return std::function([names, choice, by_choice, watch](const sim::BoxDef& box, const std::string& name) {
    watch->add(box);
    return (by_choice && choice.holds(box)) || (!name.empty() && names.contains(name));
  });
}

Result<replay::ExportChoice> choice_of(const ExportCommand& options, replay::LogReader& log,
                                       std::shared_ptr<replay::ChoiceWatch>& watch) {
  const Result<StepRange> range = options.steps.empty()
                                      ? Result<StepRange>(StepRange{log.first_state(), log.last_step()})
                                      : parse_range(options.steps, log);
  if (!range.ok()) return range.error();
  auto holds = parse_choice(options.bodies, log.bodies(), watch);
  if (!holds.ok()) return holds.error();
  return replay::ExportChoice{range->first, range->last, options.every.value_or(1), *std::move(holds)};
}

void print_result(const ExportCommand& options, const replay::ExportFormat& format, const replay::ExportPlan& plan,
                  std::uint64_t bytes, const std::vector<std::string>& left_out) {
  if (options.json) {
    Json json;
    json["file"] = options.output;
    json["format"] = std::string(format.ending).substr(1);
    json["first_step"] = plan.steps.front();
    json["last_step"] = plan.steps.back();
    json["every"] = plan.every;
    json["states"] = plan.steps.size();
    json["bodies"] = plan.bodies.size();
    json["bytes"] = bytes;
    json["left_out"] = left_out;
    print_json("export", json);
    return;
  }
  Listing listing;
  listing.add("format", format.name);
  listing.add("steps", std::to_string(plan.steps.front()) + " to " + std::to_string(plan.steps.back()) +
                           (plan.every > 1 ? ", every " + std::to_string(plan.every) : "") + ": " +
                           count_text(plan.steps.size(), "state"));
  listing.add("bodies", std::to_string(plan.bodies.size()));
  listing.add("file", options.output);
  if (bytes > 0) listing.add("size", bytes_text(bytes));
  for (const std::string& part : left_out) listing.add("left out", printable(part));
  listing.print();
}

Result<std::uint64_t> write_to(const replay::ExportFormat& format, const std::string& path, replay::LogReader& log,
                               const replay::ExportPlan& plan, std::vector<std::string>& left_out,
                               const replay::Progress& progress) {
  Result<files::OutputFile> file = files::OutputFile::create(path);
  if (!file.ok()) return file.error();
  if (file->is_device() && !format.to_pipes) {
    return bad_input(path + ": is a device or a pipe; wanted a file: parts of " + format.ending +
                     " are written at the end that stand at the start");
  }
  const std::unique_ptr<replay::ExportWriter> writer = format.make(*file);
  if (Status ok = export_log(log, plan, *writer, progress); !ok.ok()) return ok.error();
  left_out = plan.left_out;
  left_out.insert(left_out.end(), writer->left_out().begin(), writer->left_out().end());
  const bool device = file->is_device();
  if (Status ok = file->commit(); !ok.ok()) return ok.error();
  std::error_code error;
  const std::uintmax_t bytes = device ? 0 : std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<std::uint64_t>(bytes);
}

Result<Exit> export_command(const ExportCommand& options) {
  const Result<const replay::ExportFormat*> format = replay::export_format(options.output);
  if (!format.ok()) return format.error();
  files::OutputGuard guard;
  guard.keep(options.log, "the log that is exported");
  if (Status ok = claim_output(guard, "-o", options.output, files::kind_by_name(options.output)); !ok.ok())
    return ok.error();
  Result<replay::LogReader> log = open_values(options.log);
  if (!log.ok()) return log.error();
  std::shared_ptr<replay::ChoiceWatch> watch;
  const Result<replay::ExportChoice> choice = choice_of(options, *log, watch);
  if (!choice.ok()) return choice.error();
  ProgressBar bar("exporting");
  const process::InterruptGuard interrupt;
  const Result<replay::ExportPlan> plan = replay::plan_export(*log, *choice, bar.progress());
  if (!plan.ok()) return plan.error();
  if (watch && !watch->missing().empty()) {
    return bad_input(options.log + ": --bodies: found no " + joined(watch->missing(), ", no ") + " up to step " +
                     std::to_string(choice->last) + "; 'tumble dump' lists the bodies of a step");
  }
  std::vector<std::string> left_out;
  const Result<std::uint64_t> bytes = write_to(**format, options.output, *log, *plan, left_out, bar.progress());
  bar.finish();
  if (!bytes.ok()) return bytes.error();
  print_result(options, **format, *plan, *bytes, left_out);
  return judge("export", *log, Exit::kSame);
}

}  // namespace

Action declare_export(Arguments& arguments) {
  auto options = std::make_shared<ExportCommand>();
  arguments.positional("LOG", options->log, "The log to read").required();
  arguments.option("-o,--output", "FILE", options->output, "The file to write; its ending names the format").required();
  arguments.option("--steps", "A:B", options->steps, "The states after steps A to B (if not given: all)");
  arguments.whole("--every", "N", options->every, 1, sim::kStepsMax, "Every Nth of them, from the first on");
  arguments.option("--bodies", "LIST", options->bodies,
                   "These bodies: ids (7), ranges (3-9), names, tables of the scene (grid, tower:1, input), joined by "
                   "commas");
  arguments.json(options->json);
  arguments.footer(
      "  .csv   a row a body and step, with time, size, mass, material and channels; import reads it back to the bit\n"
      "  .npz   arrays for numpy, steps x bodies; import reads it back to the bit\n"
      "  .glb   glTF 2.0: shapes, materials, camera and one animation, for Blender, three.js and viewers\n"
      "  .mcap  Foxglove and Rerun: scene, frames, poses, velocities, a topic a channel\n\n"
      "docs/exporting.md says what each format holds. Parts of a session that the format has no place for are "
      "listed.\n\n"
      "Examples:\n"
      "  tumble export brick_wall.tumble -o brick_wall.npz\n"
      "  tumble export brick_wall.tumble -o ball.csv --bodies 9000 --steps 0:300 --every 10");
  return [options] { return export_command(*options); };
}

}  // namespace tumble::tools
