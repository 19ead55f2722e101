#include "golden/report/pictures.h"

#include <algorithm>

#include "golden/report/html_parts.h"

namespace tumble::golden {
namespace {

/// One picture of a rule, if it was left in the report.
Html figure(const CaseResult& result, const PictureRule& rule, const std::string& kind, ReportFiles& files) {
  const std::string file = rule.file();
  const std::string place = "cases/" + result.name + "/" + file.substr(0, file.rfind('.')) + "." + kind + ".png";
  if (std::ranges::find(result.artifacts, place) == result.artifacts.end()) return {};
  const std::string alt = kind + " picture of " + result.name + " at step " + std::to_string(rule.step);
  Html out("<figure data-kind=\"");
  out << text(kind) << "\"><img src=\"" << files.image_source(place) << "\" width=\""
      << text(std::to_string(rule.width)) << "\" height=\"" << text(std::to_string(rule.height)) << "\" alt=\""
      << text(alt) << "\"><figcaption>" << text(kind) << "</figcaption></figure>\n";
  return out;
}

std::string words_of_picture(const PictureResult& picture) {
  std::string words = mark_of(picture.pass) + picture.rule.file() + ": ";
  if (picture.message.empty()) return words + "every pixel the same";
  words += "not as blessed";
  if (picture.pixels == 0) return words;
  return words + ", " + std::to_string(picture.pixels) + " pixels differ, " + std::to_string(picture.far_off) +
         " of them far off (bound: " + std::to_string(picture.rule.far_off_max) + ")";
}

}  // namespace

Html picture_section(const CaseResult& result, ReportFiles& files) {
  if (result.pictures.empty()) return {};
  Html out("<h3>Pictures</h3>\n");
  for (const PictureResult& picture : result.pictures) {
    out << element("<p>", words_of_picture(picture), "</p>\n");
    if (picture.message.empty()) continue;
    out << "<div class=\"pictures\" data-step=\"" << text(std::to_string(picture.rule.step)) << "\">"
        << figure(result, picture.rule, "expected", files) << figure(result, picture.rule, "actual", files)
        << figure(result, picture.rule, "difference", files) << "</div>\n";
  }
  return out;
}

}  // namespace tumble::golden
