#include "golden/run/longest_first.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "golden/suite/text_files.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

std::uint64_t body_steps(const CaseFolder& folder) {
  const Result<std::string> text = read_text(folder.file(kSceneFile));
  if (!text.ok()) return 0;
  const Result<sim::SceneDef> scene = scenes::parse_scene(*text, folder.file(kSceneFile).string());
  return scene.ok() ? scene->steps * (scene->boxes.size() + 1) : 0;
}

}  // namespace

std::vector<CaseFolder> longest_first(std::vector<CaseFolder> folders) {
  std::vector<std::pair<std::uint64_t, CaseFolder>> costs;
  costs.reserve(folders.size());
  for (CaseFolder& folder : folders) costs.emplace_back(body_steps(folder), std::move(folder));
  std::ranges::stable_sort(costs, std::greater<>(), &std::pair<std::uint64_t, CaseFolder>::first);
  folders.clear();
  for (auto& [cost, folder] : costs) folders.push_back(std::move(folder));
  return folders;
}

}  // namespace tumble::golden
