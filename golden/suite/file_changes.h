#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tumble/golden/scene_changes.h"

/// The files of an engine's case as one text: a line "NAME = HASH" each, and behind an empty line the texts of those
/// that are texts and not long.
namespace tumble::golden {

/// The texts behind the hashes. Empty for bytes that are no text, and for long files.
std::string text_to_keep(const std::string& name, std::string_view bytes);

/// The lines of hashes, which alone decide whether a golden is stale.
std::string_view hash_lines(std::string_view files);

/// The first line of each file that changed. Without a text on both sides the line is 0.
std::vector<SceneChange> file_changes(std::string_view before, std::string_view after);

}  // namespace tumble::golden
