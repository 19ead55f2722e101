#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/output/divergence_output.h"
#include "tools/output/text.h"
#include "tumble/replay/body_table.h"
#include "tumble/replay/extras.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/step_record.h"

/// Prints the channels, contacts and notes of a step.
namespace tumble::tools {

/// What a log says of its bodies beside their states.
struct Told {
  replay::EngineAxes axes;
  replay::Declared declared;
  replay::BodyTable bodies;
};

/// A value of a channel as JSON: a number where JSON holds it exactly, else a text; bytes in hexadecimal.
Json channel_json(const replay::ChannelValue& value, replay::ChannelKind kind);

/// Adds name, shape and values of body channels to the JSON of a body. Adds nothing where there is nothing.
void add_body_extras(const replay::Declared& declared, const replay::BodyTable& bodies, const replay::Extras& extras,
                     sim::BodyId id, Json& json);

/// Adds "world" (values of the step by channel), "pairs", "contacts", "notes", "superseded" and "snapshots" (bytes of
/// each) to the JSON of a step, each where the step has any. Contacts are in the axes and the unit of the engine.
void add_step_extras(const replay::Declared& declared, const replay::EngineAxes& axes, const replay::Extras& extras,
                     Json& json);

/// "channel.NAME", with a part "channel.NAME.max", with a unit "channel.NAME (rad)".
std::string column_name(const std::string& prefix, const replay::Channel& channel, const std::string& part = "");

/// Whether the cells or the names of columns hold texts that need the escapes of replay::text_cell(): then all texts
/// have them, and the table begins with replay::kEscapesLine, by which `import` knows.
bool needs_escapes(const replay::Declared& declared, const replay::BodyTable& bodies);

/// The names of the columns that dump --csv has behind those of the states: "name" where the log names bodies,
/// "channel.NAME" of bodies, "world.NAME", "pair.NAME" of pairs, each with its unit. `import` reads them back.
std::vector<std::string> extra_columns(const replay::Declared& declared, const replay::BodyTable& bodies);
/// The cells of these columns for a body; empty where it has no value. Bytes in hexadecimal. The values of pairs stand
/// with their first body: "7=0.25 9=0.5", the second body before each.
std::vector<std::string> extra_cells(const replay::Declared& declared, const replay::BodyTable& bodies,
                                     const replay::Extras& extras, sim::BodyId id);

/// The parts of a step that no cell has: contacts, notes and the like, and values of pairs whose first body is not
/// among `bodies`, which are all of the step. Empty where the cells have everything.
std::vector<std::string> not_in_cells(const replay::Declared& declared, const replay::Extras& extras,
                                      const std::vector<sim::BodyId>& bodies);

/// For people: the lines "step, channel, of, value" of one step. body: only of this one; 0: all.
void add_extra_rows(const Told& told, std::uint64_t step, const replay::Extras& extras, sim::BodyId body, Table& table);

/// Adds a row {name, a, b, same} a channel that both logs compare, and one for contacts: the first value that differs,
/// or the number of values.
void add_extra_differences(replay::LogReader& a, replay::LogReader& b, const replay::StepRecord& in_a,
                           const replay::StepRecord& in_b, Json& rows);

/// Adds to a step side by side "not_compared", channels and columns of tables that no comparison looks at, each with
/// its reason, "notes" on logs that are not whole, and "only_in", data that one of two logs of one engine lacks. False:
/// there is such data.
bool add_left_out(const replay::LogReader& log_a, const replay::LogReader& log_b, Json& step);
/// Prints all three.
void print_left_out(const Json& step, const Sides& sides);

}  // namespace tumble::tools
