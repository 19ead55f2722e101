#include "tests/tree/includes.h"

#include <algorithm>
#include <fstream>
#include <queue>
#include <set>
#include <sstream>

namespace tumble::test {
namespace {

std::string unit_of(const std::string& path) { return path.substr(0, path.find_last_of('.')); }

// For each unit the include that leads to each other unit, the first where there are several.
using Graph = std::map<std::string, std::map<std::string, const Include*>>;

Graph graph_of(const std::vector<Include>& includes) {
  Graph graph;
  for (const Include& include : includes) {
    const std::string from = unit_of(include.from);
    const std::string to = unit_of(include.file);
    if (from != to) graph[from].emplace(to, &include);
  }
  return graph;
}

// The shortest way from a unit back to itself, breadth first; empty if there is none.
std::vector<const Include*> way_round(const Graph& graph, const std::string& start) {
  std::map<std::string, const Include*> came_by;
  std::queue<std::string> open({start});
  while (!open.empty() && !came_by.contains(start)) {
    const auto edges = graph.find(open.front());
    open.pop();
    if (edges == graph.end()) continue;
    for (const auto& [to, include] : edges->second) {
      if (came_by.emplace(to, include).second) open.push(to);
    }
  }
  std::vector<const Include*> way;
  if (!came_by.contains(start)) return way;
  std::string unit = start;
  do {
    way.push_back(came_by.at(unit));
    unit = unit_of(way.back()->from);
  } while (unit != start);
  std::ranges::reverse(way);
  return way;
}

}  // namespace

const std::map<std::string, std::string>& public_headers() {
  static const std::map<std::string, std::string> kHeaders = [] {
    std::map<std::string, std::string> headers;
    std::ifstream in(std::string(TUMBLE_SOURCE_DIR) + "/cmake/public_headers.txt");
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string spelled;
      std::string file;
      if (words >> spelled >> file && spelled.front() != '#') headers.emplace(spelled, file);
    }
    return headers;
  }();
  return kHeaders;
}

std::vector<Include> includes_of(const std::vector<SourceFile>& files) {
  constexpr std::string_view kStart = "#include \"";
  std::vector<Include> includes;
  for (const SourceFile& file : files) {
    if (!file.is_code()) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      if (!line.starts_with(kStart)) continue;
      const std::string spelled = line.substr(kStart.size(), line.find('"', kStart.size()) - kStart.size());
      const auto is_public = public_headers().find(spelled);
      includes.push_back({.from = file.path,
                          .spelled = spelled,
                          .file = is_public == public_headers().end() ? spelled : is_public->second,
                          .line = i + 1});
    }
  }
  return includes;
}

std::vector<std::string> circles(const std::vector<Include>& includes) {
  const Graph graph = graph_of(includes);
  std::set<std::string> named;
  std::vector<std::string> texts;
  for (const auto& [unit, edges] : graph) {
    if (named.contains(unit)) continue;
    std::string text;
    for (const Include* include : way_round(graph, unit)) {
      named.insert(unit_of(include->from));
      text += (text.empty() ? "" : ", ") + include->from + " includes " + include->file;
    }
    if (!text.empty()) texts.push_back(text);
  }
  return texts;
}

}  // namespace tumble::test
