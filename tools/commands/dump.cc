// tumble dump: bodies at one step, or one body over many.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/log/log_facts.h"
#include "replay/measure/measure_options.h"
#include "replay/session/state_source.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/step_range.h"
#include "tools/commands/dump_output.h"
#include "tools/files/log_files.h"
#include "tools/output/axes_output.h"
#include "tools/output/extras_output.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

struct DumpCommand {
  std::string log;
  std::optional<std::uint64_t> step;
  std::string steps;
  std::string body_named;
  std::optional<std::uint64_t> body;  // as the log has it
  bool csv = false;
  bool json = false;
};

std::unique_ptr<DumpOutput> make_output(const DumpCommand& options, replay::LogReader& log, replay::BodyTable bodies) {
  Told told = told_by(log.header(), std::move(bodies));
  if (options.csv) {  // one state leads to no step
    return csv_dump(std::move(told), table_head(log.header()), !options.step && replay::dt_varies(log));
  }
  return options.json ? json_dump(std::move(told), !options.step) : text_dump(std::move(told));
}

Result<StepRange> range_of(const DumpCommand& options, const replay::LogReader& log) {
  if (!options.step && options.steps.empty()) return bad_input("wanted --step K or --steps A:B: which steps to print");
  return options.step ? check_range({*options.step, *options.step}, log) : parse_range(options.steps, log);
}

void print_step(const replay::StepRecord& record, const std::optional<std::uint64_t>& body, DumpOutput& output) {
  const replay::BodyStates& states = record.states;
  output.begin_step(record);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (body && states.id[i] != *body) continue;
    output.add(record, i);
  }
  output.end_step(record, body.value_or(0));
}

// True if the body exists at any step of the range. Asked before anything is printed.
Result<bool> body_exists(replay::StateSource& source, const StepRange& range, std::uint64_t body) {
  for (std::uint64_t k = range.first; k <= range.last; ++k) {
    const Result<const replay::StepRecord*> record = source.read(k);
    if (!record.ok()) return record.error();
    if (std::ranges::binary_search((*record)->states.id, body)) return true;
  }
  return false;
}

Error no_such_body(const DumpCommand& options, const replay::LogReader& log, const StepRange& range) {
  const std::string where = range.first == range.last
                                ? "at step " + std::to_string(range.first)
                                : "in steps " + std::to_string(range.first) + " to " + std::to_string(range.last);
  return bad_input(log.name() + ": found no body " + std::to_string(*options.body) + ' ' + where +
                   "; 'tumble dump' without --body lists those there are");
}

Result<Exit> dump(DumpCommand options) {
  Result<replay::LogReader> log = open_values(options.log);
  if (!log.ok()) return log.error();
  const Result<StepRange> range = range_of(options, *log);
  if (!range.ok()) return range.error();
  replay::BodyTable bodies = replay::bodies_until(*log, range->last);
  if (!options.body_named.empty()) {
    const Result<sim::BodyId> body = replay::parse_body(options.body_named, bodies);
    if (!body.ok()) return bad_input("--body: " + body.error().message);
    options.body = *body;
  }
  replay::StateSource source(*log);
  if (options.body) {
    const Result<bool> exists = body_exists(source, *range, *options.body);
    if (!exists.ok()) return exists.error();
    if (!*exists) return no_such_body(options, *log, *range);
  }
  const std::unique_ptr<DumpOutput> output = make_output(options, *log, std::move(bodies));
  do {
    for (std::uint64_t k = range->first; k <= range->last && std::cout; ++k) {
      const Result<const replay::StepRecord*> record = source.read(k);
      if (!record.ok()) return record.error();
      print_step(**record, options.body, *output);
    }
  } while (!output->end() && std::cout);
  return judge("dump", *log, Exit::kSame);
}

}  // namespace

Action declare_dump(Arguments& arguments) {
  auto options = std::make_shared<DumpCommand>();
  arguments.positional("LOG", options->log, "The log to read").required();
  const Argument step =
      arguments.whole("--step", "K", options->step, 0, sim::kStepsMax, "The state after step K; 0 is the start");
  arguments.option("--steps", "A:B", options->steps, "The states after steps A to B").excludes(step);
  arguments.option("--body", "ID", options->body_named, "Only the body with this id, or of this name");
  const Argument csv = arguments.flag("--csv", options->csv, "Print a table of comma-separated values");
  arguments.json(options->json).excludes(csv);
  arguments.footer(
      "Numbers of --csv and --json read back to the same bits; the table for people is rounded. JSON has no NaN\n"
      "and no infinity: the value is a text with the 64 bits then, \"nan(0x7ff8000000000000)\".\n"
      "An imported session is printed in the axes and the unit of its table, with the names of its bodies and its\n"
      "channels; --csv leaves out contacts, begins with lines \"# key: value\" of axes and precision where they are "
      "not\n"
      "ours, and ends with a column dt where the steps differ in length.\n\n"
      "Examples:\n"
      "  tumble dump brick_wall.tumble --step 0\n"
      "  tumble dump brick_wall.tumble --steps 0:300 --body 9000 --csv");
  return [options] { return dump(*options); };
}

}  // namespace tumble::tools
