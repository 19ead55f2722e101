#include "tools/output/axes_output.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "src/base/text.h"

namespace tumble::tools {

Json axes_json(const replay::EngineAxes& axes) {
  return {{"up", std::string(1, static_cast<char>('x' + axes.up))},
          {"handed", axes.left_handed ? "left" : "right"},
          {"length", axes.unit()},
          {"metres", axes.metres}};
}

std::string table_head(const replay::LogHeader& header) {
  std::string head;
  const auto add = [&head](const char* key, const std::string& value) {
    head.append("# ").append(key).append(": ").append(value).append("\n");
  };
  const replay::EngineAxes axes = header.axes(), ours;
  if (axes.up != ours.up) add("up", std::string(1, static_cast<char>('x' + axes.up)));
  if (axes.left_handed) add("handed", "left");
  if (axes.metres != ours.metres) {
    const std::array<std::string_view, 2> words = {"cm", "mm"};
    const bool has_word = std::ranges::find(words, axes.unit()) != words.end();
    add("length", has_word ? axes.unit() : exact(axes.metres));
  }
  if (header.engine && header.engine->precision_bits == replay::kBinary32Bits) {
    add("precision", "float32");
    add("cells", "float64");  // the log keeps doubles
  }
  std::string derived = header.declared.velocity_derived ? "velocity" : "";
  if (header.declared.spin_derived) derived += derived.empty() ? "spin" : " spin";
  if (!derived.empty()) add("derived", derived);
  return head;
}

bool dt_varies(replay::LogReader& log) {
  std::optional<double> first;
  for (const replay::ChunkPlace& place : log.chunks()) {
    for (std::uint64_t k = place.first_step; k < place.end_step(); ++k) {
      const Result<const replay::StepRecord*> record = log.read_hashes(k);
      if (!record.ok()) break;  // the rest of the chunk cannot be read either
      if (first && (*record)->dt != *first) return true;
      first = (*record)->dt;
    }
  }
  return false;
}

}  // namespace tumble::tools
