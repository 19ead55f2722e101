#include "tools/bisect/settings.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tools/output/text.h"

namespace tumble::tools::bisect {

std::string Settings::question() const {
  const std::string name = std::filesystem::path(log).filename().string();
  if (!case_name.empty()) return (image ? "image verdict of case " : "check of case ") + case_name;
  if (metric) return metric->text + " in the session of " + name;
  return (run.empty() ? "replay of " : "the session of ") + name + ", every bit";
}

std::string Settings::fingerprint() const {
  Json json = {{"repository", repository},
               {"good", good},
               {"bad", bad},
               {"first_parent", first_parent},
               {"log", log},
               {"log_hash", log_hash},
               {"metric", metric ? metric->text : ""},
               {"bodies", to_string(measure.bodies)},
               {"axis", measure.lateral == replay::LateralAxis::kX ? "x" : "y"},
               {"from_step", measure.from_step},
               {"case", case_name},
               {"image", image},
               {"build", build},
               {"program", program},
               {"run", run},
               {"engine_folder", engine_folder},
               {"engine_scene", engine_scene},
               {"scene", scene},
               {"scene_hash", scene_hash},
               {"engine_map", engine_table.map},
               {"engine_map_file", engine_table.map_file},
               {"engine_header", engine_table.header},
               {"engine_model", engine_table.model},
               {"engine_scalar_last", engine_table.scalar_last},
               {"engine_channels", engine_table.channels},
               {"timeout", timeout_s},
               {"shell", shell}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace tumble::tools::bisect
