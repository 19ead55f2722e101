#pragma once

#include <cstddef>
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
  std::vector<std::size_t> listed;  ///< places of the channels in the order in which lists for people have them
};
/// bodies: those that are printed, by bodies_until().
Told told_by(const replay::LogHeader& header, replay::BodyTable bodies);

/// A value of a channel as JSON: a number where JSON holds it exactly, else a text; bytes in hexadecimal.
Json channel_json(const replay::ChannelValue& value, replay::ChannelKind kind);

/// Adds name, shape and values of body channels to the JSON of a body. Adds nothing where there is nothing.
void add_body_extras(const Told& told, const replay::Extras& extras, sim::BodyId id, Json& json);

/// Adds "world" (values of the step by channel), "pairs", "contacts", "notes", "superseded" and "snapshots" (bytes of
/// each) to the JSON of a step, each where the step has any. Contacts are in the axes and the unit of the engine.
void add_step_extras(const Told& told, const replay::Extras& extras, Json& json);

/// The columns that `dump --csv` has behind those of the states: "name" where the log names bodies, "channel.NAME" of
/// bodies, "world.NAME", "pair.NAME" of pairs, each with its unit. `import` reads them back.
class TableExtras {
 public:
  /// `told` must outlive this object.
  explicit TableExtras(const Told& told);

  /// Whether names, texts or bytes need the escapes of replay::text_cell(): then all texts have them, and the table
  /// begins with replay::kEscapesLine, by which `import` knows.
  [[nodiscard]] bool escaped() const { return escaped_; }

  /// The names of the columns, a comma before each.
  [[nodiscard]] std::string head() const;

  /// Appends the cells of a body, a comma before each; a cell is empty where the body has no value. Bytes in
  /// hexadecimal. The values of pairs stand with their first body: "7=0.25 9=0.5", the second body before each.
  void append_cells(const replay::Extras& extras, sim::BodyId id, std::string& line) const;

  /// For messages: the channels with a unit that does not fit behind the name of a column.
  [[nodiscard]] std::vector<std::string> units_left_out() const;

  /// For messages: the parts of a step that no cell has: contacts, notes and the like, and values of bodies, or of
  /// pairs by their first body, that are not among `bodies`, which are all of the step.
  [[nodiscard]] std::vector<std::string> left_out_of(const replay::Extras& extras,
                                                     const std::vector<sim::BodyId>& bodies) const;

 private:
  [[nodiscard]] std::string as_cell(const std::string& text) const;
  void append_value(const replay::ChannelValues& values, const replay::ChannelType& type, sim::BodyId id,
                    std::string& line) const;

  const Told& told_;
  bool named_ = false;    // a body has a name
  bool escaped_ = false;  // texts are as replay::text_cell() writes them
};

/// For people: the lines "step, channel, of, value" of one step. body: only of this one; 0: all.
void add_extra_rows(const Told& told, std::uint64_t step, const replay::Extras& extras, sim::BodyId body,
                    LongTable& table);

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
