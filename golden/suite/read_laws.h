#pragma once

#include <string>
#include <vector>

#include "src/scenes/table_reader.h"

namespace tumble::golden {

/// The law that no process ends while the session is taken and judged by every law and relation: `check` runs a case in
/// a process of its own, whose end is a problem of the case.
inline constexpr const char* kSurvivesLaw = "survives";

/// [laws] of a metrics.toml: names of hunt::relations() that the case's session must hold, or kSurvivesLaw, each with
/// the value true.
std::vector<std::string> read_laws(scenes::TableReader& top);

}  // namespace tumble::golden
