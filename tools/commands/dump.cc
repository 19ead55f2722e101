// tumble dump: bodies at one step, or one body over many.
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/arrays/pair_cell.h"
#include "replay/log/log_facts.h"
#include "replay/measure/measure_options.h"
#include "replay/session/state_source.h"
#include "src/base/schema_name.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/step_range.h"
#include "tools/files/log_files.h"
#include "tools/output/axes_output.h"
#include "tools/output/extras_output.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

using replay::BodyStates;

struct DumpCommand {
  std::string log;
  std::optional<std::uint64_t> step;
  std::string steps;
  std::string body_named;
  std::optional<std::uint64_t> body;  // as the log has it
  bool csv = false;
  bool json = false;
};

// The numbers of a body, in the order of the columns: position, orientation, velocity, angular velocity.
constexpr std::size_t kNumbers = 13;
constexpr std::array<const char*, kNumbers> kNames = {
    "position.x", "position.y", "position.z", "orientation.w", "orientation.x", "orientation.y", "orientation.z",
    "velocity.x", "velocity.y", "velocity.z", "spin.x",        "spin.y",        "spin.z"};

/// In the axes and units of the session's table.
std::array<double, kNumbers> numbers_of(const replay::EngineAxes& axes, const BodyStates& s, std::size_t i) {
  const sim::Vec3 x = axes.their_length(s.position[i]), v = axes.their_length(s.velocity[i]);
  const sim::Vec3 w = axes.their_axial(s.spin[i]);
  const sim::Quat q = axes.their_turn(s.orientation[i]);
  return {x.x(), x.y(), x.z(), q.w, q.x, q.y, q.z, v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

// Prints the rows of a dump in one of the three forms.
class Output {
 public:
  explicit Output(Told told) : told_(std::move(told)) {}
  virtual ~Output() = default;
  virtual void begin_step(const replay::StepRecord& /*step*/) {}
  virtual void add(const replay::StepRecord& step, std::size_t row) = 0;
  virtual void end_step(const replay::StepRecord& /*step*/, std::uint64_t /*body*/) {}
  virtual void end() {}

 protected:
  Told told_;
};

class CsvOutput : public Output {
 public:
  /// head: of the table. with_dt: the steps differ in length, which the last column then tells.
  CsvOutput(Told told, const std::string& head, bool with_dt)
      : Output(std::move(told)), with_dt_(with_dt), extras_(told_) {
    std::cout << head;
    if (extras_.escaped()) std::cout << replay::kEscapesLine;
    std::cout << "step,id";
    for (const char* name : kNames) std::cout << ',' << name;
    std::cout << ",frozen" << extras_.head() << (with_dt_ ? ",dt\n" : "\n");
  }
  void add(const replay::StepRecord& step, std::size_t row) override {
    const BodyStates& states = step.states;
    std::string line = std::to_string(step.step) + ',' + std::to_string(states.id[row]);
    for (const double number : numbers_of(told_.axes, states, row)) line += ',' + replay::number_cell(number);
    line += states.frozen[row] != 0 ? ",1" : ",0";
    extras_.append_cells(step.extras, states.id[row], line);
    if (with_dt_) line += ',' + replay::number_cell(step.dt);
    std::cout << line << '\n';
  }
  void end_step(const replay::StepRecord& step, std::uint64_t body) override {
    if (body != 0) return;  // one body was asked for
    for (std::string& part : extras_.left_out_of(step.extras, step.states.id)) {
      if (std::ranges::find(left_out_, part) == left_out_.end()) left_out_.push_back(std::move(part));
    }
  }
  void end() override {
    if (!left_out_.empty()) {
      std::cerr << "tumble dump: note: not in the table, which has rows of bodies alone: " << joined(left_out_, ", ")
                << "; --json has them\n";
    }
    if (const std::string units = joined(extras_.units_left_out(), ", "); !units.empty()) {
      std::cerr << "tumble dump: note: not in the table, whose columns end with their unit in brackets: the units of "
                << units << "; 'tumble info --json' has them\n";
    }
  }

 private:
  bool with_dt_;
  TableExtras extras_;
  std::vector<std::string> left_out_;
};

// One object for --step, a list of them for --steps; a line a body, so that text tools can look at it too.
class JsonOutput : public Output {
 public:
  JsonOutput(bool is_list, Told told) : Output(std::move(told)), is_list_(is_list) {
    if (is_list_) std::cout << "[\n";
  }
  void begin_step(const replay::StepRecord& step) override {
    std::cout << (first_step_ ? "" : ",\n") << R"({"schema":")" << schema_name("dump") << R"(","step":)" << step.step
              << ",\"axes\":" << axes_json(told_.axes).dump() << ",\"bodies\":[";
    first_step_ = false;
    first_body_ = true;
  }
  void add(const replay::StepRecord& step, std::size_t i) override {
    const BodyStates& s = step.states;
    Json body;
    body["id"] = s.id[i];
    const std::array<double, kNumbers> numbers = numbers_of(told_.axes, s, i);
    for (std::size_t k = 0; k < kNumbers; ++k) {
      const std::string name = kNames[k];
      body[name.substr(0, name.find('.'))].push_back(number_json(numbers[k]));
    }
    body["frozen"] = s.frozen[i] != 0;
    add_body_extras(told_, step.extras, s.id[i], body);
    std::cout << (first_body_ ? "\n" : ",\n") << text_of(body);
    first_body_ = false;
  }
  void end_step(const replay::StepRecord& step, std::uint64_t /*body*/) override {
    Json extras = Json::object();
    add_step_extras(told_, step.extras, extras);
    std::cout << "\n]";
    if (!extras.empty()) {  // behind the members that there are already
      const std::string text = text_of(extras);
      std::cout << ',' << std::string_view(text).substr(1, text.size() - 2);
    }
    std::cout << '}';
  }
  void end() override { std::cout << (is_list_ ? "\n]\n" : "\n"); }

 private:
  /// On one line. A log may hold text that is not UTF-8.
  static std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

  bool is_list_;
  bool first_step_ = true;
  bool first_body_ = true;
};

// Rounded, to be read by eye.
class TextOutput : public Output {
 public:
  explicit TextOutput(Told told) : Output(std::move(told)), table_(header_of(told_.axes.unit())) {}
  void add(const replay::StepRecord& step, std::size_t row) override {
    const BodyStates& states = step.states;
    const std::array<double, kNumbers> n = numbers_of(told_.axes, states, row);
    const std::string name = told_.bodies.name(states.id[row]);
    std::vector<std::string> cells = {std::to_string(step.step),
                                      name.empty() ? std::to_string(states.id[row]) : printable(name)};
    for (const std::size_t k : {0U, 1U, 2U, 7U, 8U, 9U, 10U, 11U, 12U, 3U, 4U, 5U, 6U}) cells.push_back(fixed(n[k], 6));
    cells.emplace_back(states.frozen[row] != 0 ? "frozen" : "");
    table_.add(std::move(cells));
  }
  void end_step(const replay::StepRecord& step, std::uint64_t body) override {
    if (step.extras.empty()) return;
    add_extra_rows(told_, step.step, step.extras, body, extras_);
    has_extras_ = true;
  }
  void end() override {
    table_.print();
    if (has_extras_) {
      std::cout << '\n';
      extras_.print();
      std::cout << '\n';
    }
    if (!told_.axes.ours()) std::cout << "In the engine's axes and units: " << to_string(told_.axes) << ".\n";
    std::cout << "Rounded; --csv and --json print every bit.\n";
  }

 private:
  static std::vector<std::string> header_of(const std::string& unit) {
    std::vector<std::string> names = {">step", ">body"};
    for (const char* axis : {"x", "y", "z"}) names.push_back(std::string(">") + axis + " " + unit);
    for (const char* axis : {"vx", "vy", "vz"}) names.push_back(std::string(">") + axis + " " + unit + "/s");
    names.insert(names.end(), {">wx rad/s", ">wy rad/s", ">wz rad/s", ">qw", ">qx", ">qy", ">qz", "frozen"});
    return names;
  }

  Table table_;
  Table extras_{{">step", "channel", "of", "value"}};
  bool has_extras_ = false;
};

std::unique_ptr<Output> make_output(const DumpCommand& options, replay::LogReader& log, replay::BodyTable bodies) {
  Told told = told_by(log.header(), std::move(bodies));
  if (options.csv) {  // one state leads to no step
    const bool with_dt = !options.step && replay::dt_varies(log);
    return std::make_unique<CsvOutput>(std::move(told), table_head(log.header()), with_dt);
  }
  if (options.json) return std::make_unique<JsonOutput>(!options.step, std::move(told));
  return std::make_unique<TextOutput>(std::move(told));
}

Result<StepRange> range_of(const DumpCommand& options, const replay::LogReader& log) {
  if (!options.step && options.steps.empty()) return bad_input("wanted --step K or --steps A:B: which steps to print");
  return options.step ? check_range({*options.step, *options.step}, log) : parse_range(options.steps, log);
}

void print_step(const replay::StepRecord& record, const std::optional<std::uint64_t>& body, Output& output) {
  const BodyStates& states = record.states;
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
  Result<replay::LogReader> log = open_log(options.log);
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
  const std::unique_ptr<Output> output = make_output(options, *log, std::move(bodies));
  for (std::uint64_t k = range->first; k <= range->last && std::cout; ++k) {
    const Result<const replay::StepRecord*> record = source.read(k);
    if (!record.ok()) return record.error();
    print_step(**record, options.body, *output);
  }
  output->end();
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
