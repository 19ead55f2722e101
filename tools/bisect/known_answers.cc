#include "tools/bisect/known_answers.h"

#include <algorithm>
#include <utility>

#include "golden/suite/text_files.h"
#include "tools/files/json_values.h"

namespace tumble::tools::bisect {
namespace {

Json answer_json(const std::string& commit, const Asked& asked) {
  const Answer& answer = asked.answer;
  return {{"commit", commit},
          {"asked", answer.asked},
          {"yes", answer.yes},
          {"words", answer.message},
          {"metric", answer.metric ? number_json(*answer.metric) : Json(nullptr)},
          {"not_repeatable", answer.not_repeatable},
          {"outcome", answer.outcome},
          {"other", answer.other},
          {"sessions_differ", asked.answer.sessions_differ},
          {"seconds", asked.seconds}};
}

Asked asked_from(const Json& row) {
  Asked asked;
  asked.answer.asked = flag_in(row, "asked");
  asked.answer.yes = flag_in(row, "yes");
  asked.answer.message = text_in(row, "words");
  asked.answer.metric = number_of(member(row, "metric"));
  asked.answer.not_repeatable = text_in(row, "not_repeatable");
  asked.answer.outcome = text_in(row, "outcome");
  asked.answer.other = text_in(row, "other");
  asked.answer.sessions_differ = text_in(row, "sessions_differ");
  asked.seconds = number_of(member(row, "seconds")).value_or(0);
  return asked;
}

/// As save() writes it.
bool is_state(const Json& json) {
  const Json answers = member(json, "answers");
  return answers.is_array() && std::ranges::all_of(answers, [](const Json& row) {
           return !text_in(row, "commit").empty() && member(row, "asked").is_boolean() &&
                  member(row, "yes").is_boolean();
         });
}

}  // namespace

KnownAnswers::KnownAnswers(std::string path, const std::string& fingerprint) : path_(std::move(path)) {
  json_["question"] = fingerprint;
}

Status KnownAnswers::load() {
  const Result<std::string> text = golden::read_text(path_);
  if (!text.ok()) return save();
  const Json json = Json::parse(*text, nullptr, false);
  if (!is_state(json)) {
    return damaged(path_ + ": is no list of answers that a bisection wrote; leave --resume out");
  }
  if (member(json, "question") != json_["question"]) {
    return bad_input(path_ + ": is the state of another bisection; leave --resume out, or give the arguments it had");
  }
  json_ = json;
  for (const Json& row : json_["answers"]) known_[text_in(row, "commit")] = asked_from(row);
  return {};
}

const Asked* KnownAnswers::find(const std::string& commit) const {
  const auto found = known_.find(commit);
  return found == known_.end() ? nullptr : &found->second;
}

Status KnownAnswers::add(const std::string& commit, const Asked& asked) {
  known_[commit] = asked;
  json_["answers"].push_back(answer_json(commit, asked));
  return save();
}

Status KnownAnswers::save() {
  if (!json_.contains("answers")) json_["answers"] = Json::array();
  const std::string text = json_.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  return golden::write_file(path_, std::string_view(text));
}

}  // namespace tumble::tools::bisect
