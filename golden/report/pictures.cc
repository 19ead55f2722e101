#include "golden/report/pictures.h"

#include <algorithm>

namespace tumble::golden {
namespace {

// The path of a picture in the report, if it was left there. Case and file names need no escaping: suite.h allows
// letters, digits, '_' and '-' only.
std::string figure(const CaseResult& result, const PictureRule& rule, const std::string& kind, ReportFiles& files) {
  const std::string file = rule.file();
  const std::string path = "cases/" + result.name + "/" + file.substr(0, file.rfind('.')) + "." + kind + ".png";
  if (std::ranges::find(result.artifacts, path) == result.artifacts.end()) return "";
  const std::string size =
      " width=\"" + std::to_string(rule.width) + "\" height=\"" + std::to_string(rule.height) + "\"";
  return "<figure data-kind=\"" + kind + "\"><img src=\"" + files.image_source(path) + "\"" + size + " alt=\"" + kind +
         " picture of " + result.name + " at step " + std::to_string(rule.step) + "\"><figcaption>" + kind +
         "</figcaption></figure>\n";
}

}  // namespace

std::string picture_section(const CaseResult& result, ReportFiles& files) {
  if (result.pictures.empty()) return "";
  std::string out = "<h3>Pictures</h3>\n";
  for (const PictureResult& picture : result.pictures) {
    const std::string mark = picture.pass ? "✓ " : "✕ ";
    out += "<p>" + mark + picture.rule.file() + ": " +
           (picture.message.empty() ? "every pixel the same" : "not as blessed");
    if (picture.pixels > 0) {
      out += ", " + std::to_string(picture.pixels) + " pixels differ, " + std::to_string(picture.far_off) +
             " of them far off (bound: " + std::to_string(picture.rule.far_off_max) + ")";
    }
    out += "</p>\n";
    if (picture.message.empty()) continue;
    out += "<div class=\"pictures\" data-step=\"" + std::to_string(picture.rule.step) + "\">" +
           figure(result, picture.rule, "expected", files) + figure(result, picture.rule, "actual", files) +
           figure(result, picture.rule, "difference", files) + "</div>\n";
  }
  return out;
}

}  // namespace tumble::golden
