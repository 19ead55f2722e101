#include "tools/output/axes_output.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "src/base/text.h"

namespace tumble::tools {

Json axes_json(const replay::EngineAxes& axes) {
  return {{"up", std::string(1, static_cast<char>('x' + axes.up))},
          {"handed", axes.left_handed ? "left" : "right"},
          {"length", axes.unit()},
          {"metres", axes.metres}};
}

std::string table_head(const replay::LogHeader& header) {
  replay::TableSettings settings;
  const replay::EngineAxes axes = header.axes(), ours;
  if (axes.up != ours.up) settings.emplace_back("up", std::string(1, static_cast<char>('x' + axes.up)));
  if (axes.left_handed) settings.emplace_back("handed", "left");
  if (axes.metres != ours.metres) {
    const std::array<std::string_view, 2> words = {"cm", "mm"};
    const bool has_word = std::ranges::find(words, axes.unit()) != words.end();
    settings.emplace_back("length", has_word ? axes.unit() : exact(axes.metres));
  }
  for (const auto& [key, value] : replay::precision_settings(header)) settings.emplace_back(key, value);
  if (std::string derived = replay::derived_columns(header.declared); !derived.empty())
    settings.emplace_back("derived", std::move(derived));
  return replay::setting_lines(settings);
}

}  // namespace tumble::tools
