// tumble import: makes a log of a table of another engine's states.
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "replay/arrays/array_table.h"
#include "replay/arrays/npz.h"
#include "replay/import/csv/import_csv.h"
#include "src/files/output_file.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/commands/import_stream.h"
#include "tools/files/log_files.h"
#include "tools/output/axes_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

constexpr std::size_t kTableBytesMax = std::size_t{4} << 30;

struct ImportCommand {
  std::string table;
  std::string output;
  std::string like;
  std::vector<std::string> settings;
  std::vector<std::string> map;
  std::string map_file;
  std::string model;
  bool scalar_last = false;
  bool channels = false;
  bool quiet = false;
  bool json = false;
};

Result<std::string> read_table(const std::string& path) {
  std::ifstream opened;
  if (path != "-") opened.open(path, std::ios::binary);
  std::istream& file = path == "-" ? std::cin : opened;
  if (!file) return bad_input(path + ": cannot be opened: " + std::generic_category().message(errno));
  std::error_code ignored;
  if (path != "-" && std::filesystem::is_directory(path, ignored)) return bad_input(path + ": is a folder, not a file");
  std::string text;
  bool is_archive = false;
  if (const std::uintmax_t size = std::filesystem::file_size(path, ignored); !ignored) {
    text.reserve(std::min<std::uintmax_t>(size, kTableBytesMax));
  }
  std::string block(1 << 20, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    const auto size = static_cast<std::size_t>(file.gcount());
    if (text.empty()) {
      is_archive = block.starts_with("PK");
      if (std::string wrong = no_table(path, block.substr(0, size)); !wrong.empty()) return bad_input(std::move(wrong));
    }
    if (const std::size_t zero = block.find('\0'); zero < size && !is_archive) {
      return bad_input(path + ": found a byte 0 at " + std::to_string(text.size() + zero) +
                       ", wanted a table as text in UTF-8");
    }
    text.append(block, 0, size);
    if (text.size() > kTableBytesMax)
      return bad_input(path + ": found more than 4 GiB, wanted a smaller table; cut it");
  }
  if (file.bad()) return cannot_finish(path + ": cannot be read: " + std::generic_category().message(errno));
  if (text.empty()) return bad_input(path + ": is empty; name a recorder's stream, a table or an archive of arrays");
  return text;
}

// A log that was there stays until the new one is complete.
Result<replay::LogSummary> import_to(const ImportCommand& options, const std::string& output, const std::string& text,
                                     const replay::ImportOptions& how) {
  if (Status ok = replay::may_replace(output); !ok.ok()) return ok.error();
  Result<files::OutputFile> file = files::OutputFile::create(output);
  if (!file.ok()) return file.error();
  ProgressBar bar("importing", !options.quiet);
  const process::InterruptGuard guard;
  Result<replay::LogSummary> summary = replay::import_csv(
      text, options.table, [&] { return replay::open_part_sink(file->part(), output); }, how, bar.progress());
  bar.finish();
  if (!summary.ok()) return summary;
  if (Status ok = file->commit(); !ok.ok()) return ok.error();
  return summary;
}

void print_result(const ImportCommand& options, const std::string& output, const replay::LogSummary& summary,
                  const replay::LogHeader& header, const std::vector<std::string>& warnings) {
  if (options.json) {
    Json json;
    json["log"] = output;
    json["engine"] = to_string(*header.engine);
    json["bodies_at_start"] = header.scene.boxes.size();
    json["steps"] = summary.steps;
    json["bytes"] = summary.bytes;
    json["final_hash"] = to_string(summary.final_hash);
    json["axes"] = axes_json(header.axes());
    json["passed_over"] = header.table ? Json(header.table->passed_over) : Json::array();
    json["channels"] = Json::array();
    for (const std::size_t c : listed_order(header.declared.channels))
      json["channels"].push_back(header.declared.channels[c].name);
    json["derived"] = Json::array();
    if (header.declared.velocity_derived) json["derived"].push_back("velocity");
    if (header.declared.spin_derived) json["derived"].push_back("spin");
    json["warnings"] = warnings;
    print_json("import", json);
    return;
  }
  Listing listing;
  listing.add("engine", printable(to_string(*header.engine)));
  listing.add("axes", to_string(header.axes()));
  if (header.table && !header.table->passed_over.empty()) {
    std::string names;
    for (const std::string& name : header.table->passed_over) names += (names.empty() ? "" : ", ") + name;
    listing.add("passed over", "columns " + printable(names));
  }
  if (!header.declared.channels.empty()) {
    std::string names;
    for (const std::size_t c : listed_order(header.declared.channels)) {
      const replay::Channel& channel = header.declared.channels[c];
      names += (names.empty() ? "" : ", ") + channel.name + " (" + name_of(channel.type.kind) + ", " +
               name_of(channel.type.scope) + (channel.unit.empty() ? ")" : ", in " + channel.unit + ")");
    }
    listing.add("channels", printable(names));
  }
  if (header.declared.velocity_derived || header.declared.spin_derived) {
    const bool both = header.declared.velocity_derived && header.declared.spin_derived;
    listing.add("derived", std::string(both                           ? "velocity, spin"
                                       : header.declared.spin_derived ? "spin"
                                                                      : "velocity") +
                               ": not in the table; exact comparisons leave them out");
  }
  listing.add("bodies", std::to_string(header.scene.boxes.size()) + " at the start");
  listing.add("steps", std::to_string(summary.steps));
  listing.add("log", output);
  listing.add("size", bytes_text(summary.bytes));
  listing.add("final hash", to_string(summary.final_hash));
  listing.print();
}

/// The table that an archive of arrays stands for.
Result<std::string> table_of_archive(const ImportCommand& options, std::string bytes,
                                     std::vector<std::string>& warnings) {
  const Result<std::vector<replay::Array>> arrays = replay::read_npz(bytes, options.table);
  if (!arrays.ok()) return arrays.error();
  std::string().swap(bytes);  // the arrays and the table need memory enough
  replay::ArrayOptions how;
  how.scalar_last = options.scalar_last;
  how.warn = [&warnings](const std::string& warning) { warnings.push_back(warning); };
  if (!options.model.empty()) {
    const Result<std::string> xml = read_table(options.model);
    if (!xml.ok()) return xml.error();
    Result<std::vector<replay::MujocoJoint>> joints = replay::read_mujoco_joints(*xml, options.model);
    if (!joints.ok()) return joints.error();
    how.joints = *std::move(joints);
  }
  return replay::table_of_arrays(*arrays, options.table, how);
}

/// The table as text, whatever the file holds.
Result<std::string> read_any_table(const ImportCommand& options, std::vector<std::string>& warnings) {
  Result<std::string> bytes = read_table(options.table);
  if (!bytes.ok() || !bytes->starts_with("PK")) {
    if (bytes.ok() && (!options.model.empty() || options.scalar_last)) {
      return bad_input("--model, --scalar-last: found a table as text, wanted an archive of arrays (.npz)");
    }
    return bytes;
  }
  return table_of_archive(options, *std::move(bytes), warnings);
}

Result<replay::TableMap> map_of(const ImportCommand& options) {
  replay::TableMap map;
  map.others_are_channels = options.channels;
  for (const std::string& entry : options.map) {
    if (Status ok = replay::add_mapping(map, entry, "--map"); !ok.ok()) return ok.error();
  }
  if (options.map_file.empty()) return map;
  if (Status ok = replay::read_map_file(map, options.map_file); !ok.ok()) return ok.error();
  return map;
}

Result<Exit> import_stream_command(const ImportCommand& options, const std::string& output) {
  const bool as_table = !options.settings.empty() || !options.like.empty() || !options.map.empty() ||
                        !options.map_file.empty() || !options.model.empty() || options.channels || options.scalar_last;
  if (as_table) {
    return bad_input(options.table +
                     ": found an option that tells how to read a table, wanted none: a stream says all of it");
  }
  files::OutputGuard guard;
  guard.keep(options.table, "the stream");
  if (Status ok = guard.claim("-o", output); !ok.ok()) return ok.error();
  return import_stream_file({options.table, output, options.json, options.quiet});
}

Result<Exit> import_command(const ImportCommand& options) {
  if (options.table == "-" && options.output.empty()) {
    return bad_input("-: the table comes from standard input, wanted -o LOG: the log to write");
  }
  std::string output = options.output;
  if (output.empty()) {
    const std::size_t name = options.table.find_last_of('/') + 1;  // 0 without one
    output = options.table.substr(name, options.table.find_last_of('.') - name) + ".tumble";
  }
  if (is_stream_file(options.table)) return import_stream_command(options, output);
  std::vector<std::string> warnings;
  const Result<std::string> text = read_any_table(options, warnings);
  if (!text.ok()) return text.error();
  replay::ImportOptions how;
  how.settings = options.settings;
  how.scalar_last = options.scalar_last;
  Result<replay::TableMap> map = map_of(options);
  if (!map.ok()) return map.error();
  how.map = *std::move(map);
  how.warn = [&warnings](const std::string& warning) { warnings.push_back(warning); };
  if (!options.like.empty()) {
    Result<replay::LogReader> log = open_values(options.like);
    if (!log.ok()) return log.error();
    Result<replay::SessionLike> like = replay::session_like(*log);
    if (!like.ok()) return like.error();
    how.like = *std::move(like);
  }
  files::OutputGuard guard;
  if (options.table != "-") guard.keep(options.table, "the table");
  guard.keep(options.map_file, "the mapping file");
  guard.keep(options.model, "the model");
  guard.keep(options.like, "the log of --like");
  if (Status ok = guard.claim("-o", output); !ok.ok()) return ok.error();
  const Result<replay::LogSummary> summary = import_to(options, output, *text, how);
  if (!summary.ok()) return summary.error();
  const Result<replay::LogReader> log = replay::LogReader::open(output);
  if (!log.ok()) return log.error();
  for (const std::string& warning : warnings) std::cerr << "tumble import: warning: " << printable(warning) << '\n';
  if (options.quiet && !options.json) return Exit::kSame;
  print_result(options, output, *summary, log->header(), warnings);
  return Exit::kSame;
}

}  // namespace

Action declare_import(Arguments& arguments) {
  auto options = std::make_shared<ImportCommand>();
  arguments
      .positional(
          "FILE", options->table,
          "A table, a row a body and step (- for standard input); an archive of arrays (.npz); a recorder's stream")
      .required();
  arguments.option("-o,--output", "LOG", options->output,
                   "The log to write (if not given: FILE.tumble in this folder)");
  arguments.option("--header", "LINE", options->settings,
                   "A line of the header, \"key: value\", that wins over the table's: \"up: y\", \"dt: 0.01\"");
  arguments.option("--map", "FIELD=COLUMN", options->map,
                   "The table's name of a column of the format: position.x=px, channel.knee=angle, world.seed=rng; may "
                   "be repeated");
  arguments.option("--map-file", "FILE", options->map_file, "A file with such mappings, one a line");
  arguments.option("--model", "FILE.xml", options->model,
                   "The MuJoCo model (MJCF) whose joints name the numbers of an array qpos");
  arguments.flag("--scalar-last", options->scalar_last, "Quaternions of an archive are x y z w, not w x y z");
  arguments.flag("--channels", options->channels, "Make a channel of every column that the format does not know");
  arguments.option("--like", "LOG", options->like,
                   "Take sizes, masses, gravity, dt and camera from this log where the table lacks them");
  arguments.flag("--quiet", options->quiet, "Print no result and no progress, only warnings and errors");
  arguments.json(options->json);
  arguments.footer(
      "Columns: step or time, id, position.x …, orientation.w …, velocity.x …, spin.x … (angular velocity),\n"
      "and any of frozen, size.x …, mass, static, friction, restitution, row, column, name, shape,\n"
      "channel.NAME (a value of the body), world.NAME (a value of the step), pair.NAME (values of pairs in the row of\n"
      "the first body, \"7=0.25 9=0.5\"). A channel's unit stands behind its name in brackets. euler.1 … stands for\n"
      "orientation; velocity and spin are derived where the table lacks them.\n"
      "Lines \"# key: value\" before them: engine, version, scene, precision, up, handed, length, dt, gravity, "
      "ground,\n"
      "size, mass, friction, restitution, euler, angles, camera.position .target .fov .focus .blur, derived, cells,\n"
      "kinds, escapes (percent: cells have %2c for a comma). Without kinds a channel holds int64 where all its\n"
      "cells are whole numbers, float64 where they are numbers, else text.\n"
      "docs/other_engines.md explains each. The log can be compared, measured and drawn, but not replayed.\n\n"
      "A stream of replay/recorder/tumble_recorder.h is known by its first bytes.\n\n"
      "Examples:\n"
      "  tumble import mine.csv -o mine.tumble\n"
      "  tumble import mine.tumblestream -o mine.tumble\n"
      "  tumble import mine.csv --header \"engine: mine\" --header \"up: y\" --header \"dt: 0.016666666666666666\"\n"
      "  tumble import robot.csv --map position.x=px --map channel.knee=knee_angle --map world.seed=rng\n"
      "  tumble import rollout.npz --model robot.xml -o rollout.tumble\n"
      "  my_engine --csv | tumble import - -o mine.tumble --channels\n"
      "  tumble import mine.csv --like brick_wall.tumble && tumble diff brick_wall.tumble mine.tumble --tolerance "
      "position=0.01");
  return [options] { return import_command(*options); };
}

}  // namespace tumble::tools
