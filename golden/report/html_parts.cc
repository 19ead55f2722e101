#include "golden/report/html_parts.h"

#include <array>

namespace tumble::golden {

Html element(Html::Markup open, std::string_view words, Html::Markup close) {
  return Html(open) << text(words) << close;
}

Html list_of(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  Html out("<ul>\n");
  for (const std::string& sentence : sentences) out << element("<li>", sentence, "</li>\n");
  return out << "</ul>\n";
}

const char* class_of(Outcome outcome) {
  constexpr std::array kClasses = {"none", "pass", "fail"};
  return kClasses[static_cast<std::size_t>(outcome)];
}

const char* mark_of(bool passed) { return passed ? "✓ " : "✕ "; }

std::string words_of(Outcome outcome) {
  constexpr std::array kWords = {"– none", "✓ passed", "✕ failed"};
  return kWords[static_cast<std::size_t>(outcome)];
}

Html chip(const char* name, Outcome outcome) {
  constexpr std::array kMarks = {"– ", "✓ ", "✕ "};
  constexpr std::array kWords = {" none", " passed", " failed"};
  const auto k = static_cast<std::size_t>(outcome);
  return Html("<span class=\"chip ") << text(class_of(outcome)) << "\">" << text(kMarks[k]) << text(name)
                                     << text(kWords[k]) << "</span>";
}

Html cell(std::string_view name, std::string_view words, bool is_number) {
  Html out("<td");
  if (is_number) out << " class=\"number\"";
  return out << " data-name=\"" << text(name) << "\">" << text(words) << "</td>";
}

}  // namespace tumble::golden
