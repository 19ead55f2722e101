#include "tools/bisect/answer.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/base/check.h"
#include "tools/files/json_values.h"
#include "tumble/replay/compare.h"

namespace tumble::tools::bisect {

Answer skipped(const std::string& why) { return {.message = why}; }

bool differ(const Answer& a, const Answer& b) {
  return !a.outcome.empty() && !b.outcome.empty() && a.outcome != b.outcome;
}

Answer answer_of(const std::vector<Answer>& answers) {
  SIM_CHECK(!answers.empty(), answers.size());
  const auto count = [&](bool asked, bool yes) {
    return std::ranges::count_if(answers, [&](const Answer& one) { return one.asked == asked && one.yes == yes; });
  };
  const auto yes = count(true, true), no = count(true, false), none = count(false, false);
  const auto most = std::max({yes, no, none});
  const bool tie = (yes == most) + (no == most) + (none == most) > 1;
  const auto wanted = [&](const Answer& one) {
    if (tie || none == most) return !one.asked;
    return one.asked && one.yes == (yes == most);
  };
  const auto found = std::ranges::find_if(answers, wanted);
  Answer answer = found == answers.end() ? skipped("its answer is not repeatable") : *found;
  const auto unlike = std::ranges::find_if(answers, [&](const Answer& one) { return differ(answer, one); });
  if (unlike != answers.end()) answer.other = unlike->message;
  if (most == std::ssize(answers)) return answer;
  answer.not_repeatable =
      std::to_string(yes) + " of " + std::to_string(answers.size()) + " times yes, " + std::to_string(no) + " times no";
  if (none > 0) answer.not_repeatable += ", " + std::to_string(none) + " times it could not be asked";
  return answer;
}

std::string differs_text(const Json& first) {
  if (!first.is_object()) return "it differs";
  const auto text = [&](const char* key) {
    return text_in(first, key, member(first, key).dump(-1, ' ', false, Json::error_handler_t::replace));
  };
  std::string words = "differs from step " + text("step") + " on, phase " + text("phase");
  if (!member(first, "body").is_null()) words += ", body " + text("body");
  return words + ", " + text("field");
}

std::string same_text(const Json& report) {
  const Json parts = member(report, "not_compared");
  for (const Json& part : parts.is_array() ? parts : Json::array()) {
    if (!part.is_string() || !part.get<std::string>().starts_with("phase hashes")) continue;
    return "the same in every compared bit; not compared: " + part.get<std::string>();
  }
  return "the same in every bit";
}

std::string same_text(const replay::ComparisonScope& scope) {
  std::string text = "the same in " + scope.every_bit();
  const std::vector<std::string> parts = scope.passed_over();
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "; not compared: " : "; ") + parts[i];
  return text;
}

}  // namespace tumble::tools::bisect
