#pragma once

#include <string>
#include <vector>

#include "src/scenes/table_reader.h"

namespace tumble::golden {

/// [laws] of a metrics.toml: names of hunt::relations() that the case's session must hold, each with the value true.
std::vector<std::string> read_laws(scenes::TableReader& top);

}  // namespace tumble::golden
