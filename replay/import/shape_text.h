#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/replay/channel.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Reads the word of a column `shape`: "box", "sphere", "capsule-x", "cylinder-z" (along an axis of the table),
/// "hull:FILE" or "mesh:FILE". size: the edge lengths of the box around the body, m, in our axes; they give the radii.
/// FILE is a Wavefront file (.obj) in the table's axes and unit, beside the table or by an absolute path. None: a box.
/// Errors (kBadInput): another word; a capsule shorter than its caps; a file that holds no such shape.
Result<std::optional<Shape>> parse_shape(std::string_view text, const sim::Vec3& size, const EngineAxes& axes,
                                         const std::string& table_path);

/// Reads "float64 int64 text", kinds of channels joined by blanks. Empty for any other text, and where a word is
/// "bytes", which no table holds.
std::vector<ChannelKind> parse_kinds(std::string_view text);

}  // namespace tumble::replay
