#include "tools/output/axes_output.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "replay/format/engine_column.h"

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
  const std::optional<replay::EngineColumn> column = replay::column_in(axes, difference.field);
  if (axes.ours() || !column) return difference;
  difference.field = column->name;
  for (replay::FieldValue* value : {&difference.expected, &difference.actual}) {
    if (auto* number = std::get_if<double>(value)) {
      *number = column->sign * (column->is_length ? axes.their_metres(*number) : *number);
    }
  }
  return difference;
}

replay::DifferenceReport in_axes(const replay::EngineAxes& axes, replay::DifferenceReport report) {
  report.first = in_axes(axes, std::move(report.first));
  if (report.effect) report.effect = in_axes(axes, *std::move(report.effect));
  if (!report.growth || !report.growth->separation.lost) return report;
  replay::LostBody& lost = *report.growth->separation.lost;
  if (const auto column = replay::column_in(axes, lost.field)) lost.field = column->name;
  return report;
}

}  // namespace tumble::tools
