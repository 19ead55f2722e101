#include "replay/blame/origin.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "replay/blame/body_motion.h"
#include "replay/blame/value_history.h"
#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

std::string vector_text(const sim::Vec3& v) {
  return '(' + significant(v.x(), 6) + ", " + significant(v.y(), 6) + ", " + significant(v.z(), 6) + ')';
}

// The bodies that an input is about; none: about all.
std::optional<sim::BodyId> body_of(const sim::Command& input) {
  if (const auto* made = std::get_if<sim::Throw>(&input)) return made->box.id;
  if (const auto* push = std::get_if<sim::Push>(&input)) return push->id;
  if (const auto* remove = std::get_if<sim::Remove>(&input)) return remove->id;
  if (const auto* wake = std::get_if<sim::Wake>(&input)) return wake->id;
  if (const auto* set = std::get_if<sim::SetVelocity>(&input)) return set->id;
  return std::nullopt;
}

BlameAnswer answer_about(std::uint64_t k, const char* phase, const ValueOfBody& value, const FieldValue& after) {
  BlameAnswer answer;
  answer.step = k;
  answer.phase = phase;
  answer.body = value.body;
  answer.value = field_name(value.field);
  answer.unit = unit_of_field(value.field);
  answer.after = after;
  return answer;
}

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view() : line.substr(begin);
}

// The numbers of the lines, from 1, that begin the tables [[name]].
std::vector<std::size_t> table_lines(const std::string& text, std::string_view name) {
  const std::string head = "[[" + std::string(name) + "]]";
  std::vector<std::size_t> lines;
  std::istringstream in(text);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (trimmed(line).starts_with(head)) lines.push_back(number);
  }
  return lines;
}

// The number after "key =" in the table that begins at a line, if it stands on a line of its own.
std::optional<double> number_in_table(const std::string& text, std::size_t table_line, std::string_view key) {
  std::istringstream in(text);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (number <= table_line) continue;
    std::string_view rest = trimmed(line);
    if (rest.starts_with('[')) break;
    if (!rest.starts_with(key)) continue;
    rest = trimmed(rest.substr(key.size()));
    if (!rest.starts_with('=')) continue;
    rest = trimmed(rest.substr(1));
    return parse_exact(rest.substr(0, rest.find_first_of(" \t#\r")));
  }
  return std::nullopt;
}

std::string line_text(std::size_t line, std::string_view table) {
  return "line " + std::to_string(line) + " of the scene, [[" + std::string(table) + "]]";
}

// The step of the input whose table begins at a line; none unless it is written there. A log may hold any text.
std::optional<std::uint64_t> step_in_table(const LogHeader& header, std::size_t line) {
  const std::optional<double> step = number_in_table(header.scene_text, line, "step");
  const std::optional<double> time = number_in_table(header.scene_text, line, "time");
  if (!step && !time) return std::nullopt;
  const double number = step ? *step : 1 + std::round(*time / header.scene.world.dt);
  if (!(number >= 0 && number <= static_cast<double>(sim::kStepsMax))) return std::nullopt;
  return static_cast<std::uint64_t>(number);
}

// The line of the scene's input with this index; none unless every table has its step, so that the order is sure. A log
// that goes on from another has the whole text, but only the inputs that are still to come.
std::optional<std::size_t> input_line(const LogHeader& header, std::size_t index) {
  const std::vector<sim::TimedCommand>& inputs = header.scene.inputs;
  const std::uint64_t begin = header.goes_on ? header.goes_on->step : 0;
  std::vector<std::pair<std::uint64_t, std::size_t>> tables;
  for (const std::size_t line : table_lines(header.scene_text, "input")) {
    const std::optional<std::uint64_t> step = step_in_table(header, line);
    if (!step) return std::nullopt;
    if (*step > begin) tables.emplace_back(*step, line);
  }
  std::ranges::stable_sort(tables, {}, &std::pair<std::uint64_t, std::size_t>::first);
  const auto same = [](const auto& table, const sim::TimedCommand& input) { return table.first == input.step; };
  if (!std::ranges::equal(tables, inputs, same)) return std::nullopt;
  return tables[index].second;
}

}  // namespace

std::string describe_input(const sim::Command& input) {
  std::string text = sim::name_of(input);
  if (const std::optional<sim::BodyId> body = body_of(input)) text += " of body " + std::to_string(*body);
  if (const auto* made = std::get_if<sim::Throw>(&input)) {
    text += ", velocity " + vector_text(made->box.velocity) + " m/s, from " + vector_text(made->box.position) + " m";
  } else if (const auto* push = std::get_if<sim::Push>(&input)) {
    text +=
        ", impulse " + vector_text(push->impulse) + " N s" + (push->at_centre ? "" : " at " + vector_text(push->at));
  } else if (const auto* set = std::get_if<sim::SetVelocity>(&input)) {
    text += ", velocity " + vector_text(set->velocity) + " m/s, spin " + vector_text(set->spin) + " rad/s";
  } else if (const auto* gravity = std::get_if<sim::SetGravity>(&input)) {
    text += " to " + vector_text(gravity->gravity) + " m/s2";
  } else if (const auto* dt = std::get_if<sim::SetDt>(&input)) {
    text += " to " + exact(dt->dt) + " s";
  }
  return text;
}

std::string input_place(const LogHeader& header, std::uint64_t k, const sim::Command& input) {
  const std::vector<sim::TimedCommand>& inputs = header.scene.inputs;
  const auto at = std::ranges::find(inputs, sim::TimedCommand{k, input});
  if (at == inputs.end()) return "an input made while the session ran";
  const auto index = static_cast<std::size_t>(at - inputs.begin());
  const std::optional<std::size_t> line = input_line(header, index);
  if (line) return line_text(*line, "input");
  // Of the inputs of a log that goes on, nothing tells how many came before.
  if (header.goes_on) return "an input of the session that this log goes on from";
  return "input " + std::to_string(index + 1) + " of the scene";
}

std::string body_place(const LogHeader& header, sim::BodyId body) {
  const auto at = std::ranges::lower_bound(header.scene.boxes, body, {}, &sim::BoxDef::id);
  if (at == header.scene.boxes.end() || at->id != body) return "";
  const sim::Origin& origin = at->origin;
  const char* table = name_of(origin.kind);
  const std::vector<std::size_t> lines = table_lines(header.scene_text, table);
  std::string text = origin.table < lines.size()
                         ? line_text(lines[origin.table], table)
                         : "[[" + std::string(table) + "]] " + std::to_string(origin.table + 1) + " of the scene";
  if (origin.kind != sim::Origin::Kind::kBox) {
    text += ", row " + std::to_string(origin.row) + ", column " + std::to_string(origin.column);
  }
  return text;
}

namespace {

BlameAnswer input_answer(const LogHeader& header, std::uint64_t k, const ValueOfBody& value,
                         const std::optional<FieldValue>& before, const FieldValue& after, const sim::Command& input) {
  BlameAnswer answer = answer_about(k, "inputs", value, after);
  answer.before = before;
  answer.text = describe_input(input);
  answer.origin = input_place(header, k, input);
  return answer;
}

BlameAnswer start_answer(const LogHeader& header, std::uint64_t k, const ValueOfBody& value, const FieldValue& after) {
  BlameAnswer answer = answer_about(k, "start", value, after);
  if (header.goes_on) {
    answer.text = "the state with which this log goes on from " + printable(header.goes_on->log);
  } else {
    answer.text = "the scene starts with it";
    answer.origin = body_place(header, value.body);
  }
  return answer;
}

BlameAnswer lost_answer(std::uint64_t k, const ValueOfBody& value, const FieldValue& after) {
  BlameAnswer answer = answer_about(k, "lost", value, after);
  answer.text = "the log holds the value after this step, and has lost the step: what made the value is not there";
  return answer;
}

bool wants_more(const Blame& blame) { return blame.answers.size() < blame.question.answers; }

}  // namespace

Status end_at_inputs(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, Blame& blame) {
  const Result<std::vector<InputChange>> changes = steps.input_changes(k, value.body, value.field);
  if (!changes.ok()) return changes.error();
  std::size_t left = changes->size();
  for (; left > 0 && wants_more(blame); --left) {
    const InputChange& change = (*changes)[left - 1];
    std::optional<FieldValue> before;
    if (change.before) before = *change.before;
    BlameAnswer answer = input_answer(steps.log().header(), k, value, before, change.after.value_or(0.0), change.input);
    if (changes->size() > 1) {
      answer.text += "; number " + std::to_string(left) + " of the " + std::to_string(changes->size()) +
                     " inputs before this step that changed the value";
    }
    blame.answers.push_back(std::move(answer));
  }
  blame.complete = left == 0;
  if (blame.complete) blame.ends = changes->size() == 1 ? "an input set this value" : "inputs set this value";
  return {};
}

Status end_at_rest(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, Blame& blame) {
  const Result<std::vector<sim::Command>> inputs = steps.load_changes(k);
  if (!inputs.ok()) return inputs.error();
  for (const sim::Command& input : *inputs) {
    if (wants_more(blame)) blame.answers.push_back(input_answer(steps.log().header(), k, value, 0.0, 0.0, input));
  }
  blame.complete = true;
  blame.ends = "both bodies of the contact were at rest";
  if (inputs->empty()) {
    blame.ends += ": it carries what else acts on them";
  } else if (inputs->size() == 1) {
    blame.ends += ", and this input can have changed what it carries";
  } else {
    blame.ends += ", and each of " + std::to_string(inputs->size()) + " inputs can have changed what it carries";
  }
  return {};
}

Status end_at_start(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, Blame& blame) {
  const Result<double> found = value_after(steps, k, value.body, value.field);
  if (!found.ok()) return found.error();
  const LogHeader& header = steps.log().header();
  blame.answers.push_back(start_answer(header, k, value, *found));
  blame.complete = !header.goes_on;
  blame.ends = "the scene sets this value";
  if (header.goes_on) {
    const std::string before = printable(header.goes_on->log);
    blame.ends = "what came before is in " + before + ": tumble blame " + shell_quoted(before) + " --body " +
                 std::to_string(value.body) + " --field " + field_name(value.field) + " --step " +
                 std::to_string(header.goes_on->step);
  }
  return {};
}

Status end_at_lost_step(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, const Error& why, Blame& blame) {
  if (why.kind != ErrorKind::kDamaged) return why;
  const Result<double> found = value_after(steps, k, value.body, value.field);
  if (!found.ok()) return found.error();
  blame.answers.push_back(lost_answer(k, value, *found));
  blame.ends = why.message;
  blame.damaged = true;
  return {};
}

}  // namespace tumble::replay
