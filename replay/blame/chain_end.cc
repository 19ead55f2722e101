#include "replay/blame/chain_end.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/blame/body_motion.h"
#include "replay/blame/value_history.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

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
