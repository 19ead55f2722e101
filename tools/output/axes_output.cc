#include "tools/output/axes_output.h"

#include <nlohmann/json.hpp>
#include <string>

namespace tumble::tools {

Json axes_json(const replay::EngineAxes& axes) {
  return {{"up", std::string(1, static_cast<char>('x' + axes.up))},
          {"handed", axes.left_handed ? "left" : "right"},
          {"length", axes.unit()},
          {"metres", axes.metres}};
}

}  // namespace tumble::tools
