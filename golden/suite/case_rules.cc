#include "tumble/golden/case_rules.h"

#include <algorithm>

#include "src/base/text.h"

namespace tumble::golden {

std::string PictureRule::file() const {
  std::string number = std::to_string(step);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return "frame_" + number + ".png";
}

std::vector<std::string> EngineCase::all_files() const {
  std::vector<std::string> all;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(all, name) == all.end()) all.push_back(name);
  };
  add(scene);
  add(inputs);
  for (const std::string& name : files) add(name);
  return all;
}

bool is_picture_name(std::string_view name) { return name.starts_with("frame_") && name.ends_with(".png"); }

Result<VerdictKind> parse_verdict(std::string_view word) {
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    if (word == kVerdictNames[k]) return static_cast<VerdictKind>(k);
  }
  return bad_input("found " + in_quotes(word) + ", wanted exact, behaviour or image");
}

}  // namespace tumble::golden
