#pragma once

#include <foxglove.pb.h>

#include <cstddef>
#include <string>
#include <vector>

#include "replay/export/plan/export_plan.h"

namespace tumble::replay {

/// The frames of the bodies: "body_7", or the body's name where no other has it.
inline constexpr const char* kWorldFrame = "world";

std::vector<std::string> frame_names(const ExportPlan& plan);

/// Everything that is there in one exported step, to replace what was there before. Each body is fixed to its frame.
foxglove::SceneUpdate scene_at(const ExportPlan& plan, std::size_t index, const std::vector<std::string>& frames);

}  // namespace tumble::replay
