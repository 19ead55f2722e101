#include "tools/output/axes_output.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

namespace tumble::tools {

Json axes_json(const replay::EngineAxes& axes) {
  return {{"up", std::string(1, static_cast<char>('x' + axes.up))},
          {"handed", axes.left_handed ? "left" : "right"},
          {"length", axes.unit()},
          {"metres", axes.metres}};
}

replay::EngineAxes common_axes(const replay::LogHeader& a, const replay::LogHeader& b) {
  replay::EngineAxes in_a = a.axes(), in_b = b.axes();
  in_a.metres = in_b.metres = 1;
  return in_a == in_b ? in_a : replay::EngineAxes();
}

replay::Divergence in_axes(const replay::EngineAxes& axes, replay::Divergence difference) {
  const auto* const column = std::ranges::find(replay::kColumnNames, difference.field);
  if (axes.ours() || column == replay::kColumnNames.end() || difference.field == "orientation.w") return difference;
  std::string& field = difference.field;
  const bool is_length = field.starts_with("position") || field.starts_with("velocity");
  const int k = field.back() - 'x';
  const replay::EngineAxis axis = is_length ? axes.along(k) : axes.axial_along(k);
  field.back() = axis.letter;
  for (replay::FieldValue* value : {&difference.expected, &difference.actual}) {
    if (auto* number = std::get_if<double>(value)) {
      *number = axis.sign * (is_length ? axes.their_metres(*number) : *number);
    }
  }
  return difference;
}

}  // namespace tumble::tools
