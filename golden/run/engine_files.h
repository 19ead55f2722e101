#pragma once

#include <string>

#include "tumble/golden/suite.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// The input files of an engine's case as text, a line a file: "crates.xml = <hash of its bytes>". Takes the place of a
/// scene's text: a golden whose text differs is stale, and names the files. Errors: a file that cannot be read.
Result<std::string> engine_files_text(const CaseFolder& folder, const EngineCase& engine);

/// The hash of such a text: takes the place of scene_hash().
Hash128 engine_files_hash(const std::string& text);

}  // namespace tumble::golden
