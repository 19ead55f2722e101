#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "replay/view/body_history.h"
#include "replay/view/contact_points.h"
#include "replay/view/timeline.h"
#include "replay/view/viewed_bodies.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"

/// What the session page reads as JSON. Lengths in m, speeds in m/s, energies in J, our axes.
namespace tumble::tools {

/// {"path", "name", "title", "method", "engine", "summary", "finished", "ours", "first", "last", "dt", "ground",
/// "camera", "gaps": [[first, last, why]], "channels": [{"name", "unit", "of":
/// "step", "bodies" or "pairs"}] of the timeline, of bodies and pairs the largest value in each step}.
Json head_json(const replay::LogReader& log);

/// {"version", "id", "size" (3 a body), "static", "texture", "origin" (4 a body: kind, table, row, column), "name":
/// {row: name}, "shape": {row: index}, "shapes": [{"kind", "axis", "radius", "half_length", "points", "triangles",
/// "words": as `dump` has it}]};
/// size 0 0 0 for a body that nothing read so far defines.
Json bodies_json(const replay::ViewedBodies& table);

/// Columns of numbers, one a row: {"step", "time", "read", "kinetic", …}; null where a number has no meaning.
Json timeline_json(std::span<const replay::TimelineRow> rows);

/// [{"step", "kind", "body", "text"}].
Json inputs_json(std::span<const replay::TimelineInput> inputs);

/// Columns, a step each: {"step", "x", "y", "z" (m), "speed", "spin", "asleep"}, null where the body is not shown, and
/// "next": the step to ask for next. from: the first step that was asked for.
Json history_json(std::uint64_t from, std::span<const replay::BodyMoment> history);

/// [[a, b or 0, x, y, z, normal x, y, z, depth, impulse]].
Json contact_rows_json(std::span<const replay::ContactPoint> points);

/// The text of JSON; bytes that are not UTF-8 become replacement characters.
std::string dumped(const Json& json);

/// All digits, for what a search compares; "Infinity" and "-Infinity", which JSON has no number for; null for none.
Json exact_json(double value);

/// Seven significant digits; null for a number that is not finite.
Json short_json(double value);

}  // namespace tumble::tools
