#include "tools/bisect/known_answers.h"

#include <utility>

#include "golden/suite/text_files.h"

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
  asked.answer.asked = row.value("asked", false);
  asked.answer.yes = row.value("yes", false);
  asked.answer.message = row.value("words", "");
  asked.answer.metric = number_of(row.value("metric", Json()));
  asked.answer.not_repeatable = row.value("not_repeatable", "");
  asked.answer.outcome = row.value("outcome", "");
  asked.answer.other = row.value("other", "");
  asked.answer.sessions_differ = row.value("sessions_differ", "");
  asked.seconds = row.value("seconds", 0.0);
  return asked;
}

}  // namespace

KnownAnswers::KnownAnswers(std::string path, const std::string& fingerprint) : path_(std::move(path)) {
  json_["question"] = fingerprint;
}

Status KnownAnswers::load() {
  const Result<std::string> text = golden::read_text(path_);
  if (!text.ok()) return save();
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object() || json.value("question", "") != json_["question"] || !json.contains("answers")) {
    return bad_input(path_ + ": is the state of another bisection; leave --resume out, or give the arguments it had");
  }
  json_ = json;
  for (const Json& row : json_["answers"]) known_[row.value("commit", "")] = asked_from(row);
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
