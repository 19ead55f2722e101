#include "tools/commands/dump_output.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "replay/arrays/pair_cell.h"
#include "src/base/schema_name.h"
#include "src/base/text.h"
#include "tools/output/axes_output.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

using replay::BodyStates;

/// The numbers of a body, in the order of the columns: position, orientation, velocity, angular velocity.
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

class CsvOutput : public DumpOutput {
 public:
  /// head: of the table. with_dt: the steps differ in length, which the last column then tells.
  CsvOutput(Told told, const std::string& head, bool with_dt)
      : DumpOutput(std::move(told)), with_dt_(with_dt), extras_(told_) {
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
  bool end() override {
    if (!left_out_.empty()) {
      std::cerr << "tumble dump: note: not in the table, which has rows of bodies alone: " << joined(left_out_, ", ")
                << "; --json has them\n";
    }
    if (const std::string units = joined(extras_.units_left_out(), ", "); !units.empty()) {
      std::cerr << "tumble dump: note: not in the table, whose columns end with their unit in brackets: the units of "
                << units << "; 'tumble info --json' has them\n";
    }
    return true;
  }

 private:
  bool with_dt_;
  TableExtras extras_;
  std::vector<std::string> left_out_;
};

// One object for --step, a list of them for --steps; a line a body, so that text tools can look at it too.
class JsonOutput : public DumpOutput {
 public:
  JsonOutput(bool is_list, Told told) : DumpOutput(std::move(told)), is_list_(is_list) {
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
  bool end() override {
    std::cout << (is_list_ ? "\n]\n" : "\n");
    return true;
  }

 private:
  /// On one line. A log may hold text that is not UTF-8.
  static std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

  bool is_list_;
  bool first_step_ = true;
  bool first_body_ = true;
};

// Rounded, to be read by eye: a table of states, and behind it one of channels, contacts and notes. The steps of long
// tables come once for the widths of all columns, and then once for each table that was too long to be kept.
class TextOutput : public DumpOutput {
 public:
  explicit TextOutput(Told told) : DumpOutput(std::move(told)), table_(header_of(told_.axes.unit())) {}
  void add(const replay::StepRecord& step, std::size_t row) override {
    if (pass_ == Pass::kExtras) return;
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
    if (step.extras.empty() || pass_ == Pass::kStates) return;
    add_extra_rows(told_, step.step, step.extras, body, extras_);
    has_extras_ = true;
  }
  bool end() override {
    if (pass_ == Pass::kBoth && !table_.print()) {
      pass_ = Pass::kStates;
      return false;
    }
    if (has_extras_) {
      if (pass_ != Pass::kExtras) {
        std::cout << '\n';
        pass_ = Pass::kExtras;
        if (!extras_.print()) return false;
      }
      std::cout << '\n';
    }
    if (!told_.axes.ours()) std::cout << "In the engine's axes and units: " << to_string(told_.axes) << ".\n";
    std::cout << "Rounded; --csv and --json print every bit.\n";
    return true;
  }

 private:
  enum class Pass : std::uint8_t { kBoth, kStates, kExtras };

  static std::vector<std::string> header_of(const std::string& unit) {
    std::vector<std::string> names = {">step", ">body"};
    for (const char* axis : {"x", "y", "z"}) names.push_back(std::string(">") + axis + " " + unit);
    for (const char* axis : {"vx", "vy", "vz"}) names.push_back(std::string(">") + axis + " " + unit + "/s");
    names.insert(names.end(), {">wx rad/s", ">wy rad/s", ">wz rad/s", ">qw", ">qx", ">qy", ">qz", "frozen"});
    return names;
  }

  LongTable table_;
  LongTable extras_{{">step", "channel", "of", "value"}};
  bool has_extras_ = false;
  Pass pass_ = Pass::kBoth;
};

}  // namespace

std::unique_ptr<DumpOutput> csv_dump(Told told, const std::string& head, bool with_dt) {
  return std::make_unique<CsvOutput>(std::move(told), head, with_dt);
}
std::unique_ptr<DumpOutput> json_dump(Told told, bool is_list) {
  return std::make_unique<JsonOutput>(is_list, std::move(told));
}
std::unique_ptr<DumpOutput> text_dump(Told told) { return std::make_unique<TextOutput>(std::move(told)); }

}  // namespace tumble::tools
