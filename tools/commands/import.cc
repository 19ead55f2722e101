// tumble import: makes a log of a table of another engine's states.
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "replay/import/import_csv.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/commands/import_stream.h"
#include "tools/files/log_files.h"
#include "tools/output/axes_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

constexpr std::size_t kTableBytesMax = std::size_t{4} << 30;

struct ImportCommand {
  std::string table;
  std::string output;
  std::string like;
  std::vector<std::string> settings;
  bool json = false;
};

Result<std::string> read_table(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return bad_input(path + ": cannot be opened; name a table of comma-separated values");
  std::string text;
  std::string block(1 << 20, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    const auto size = static_cast<std::size_t>(file.gcount());
    if (const std::size_t zero = block.find('\0'); zero < size) {
      return bad_input(path + ": found a byte 0 at " + std::to_string(text.size() + zero) +
                       ", wanted a table as text in UTF-8");
    }
    text.append(block, 0, size);
    if (text.size() > kTableBytesMax)
      return bad_input(path + ": found more than 4 GiB, wanted a smaller table; cut it");
  }
  if (text.empty()) return bad_input(path + ": is empty or no file; name a table of comma-separated values");
  return text;
}

Result<replay::LogSummary> import_to(const ImportCommand& options, const std::string& output, const std::string& text,
                                     const replay::ImportOptions& how) {
  ProgressBar bar("importing");
  const process::InterruptGuard guard;
  Result<replay::LogSummary> summary = replay::import_csv(
      text, options.table, [&] { return replay::open_file_sink(output); }, how, bar.progress());
  bar.finish();
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
    json["warnings"] = warnings;
    print_json(json);
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
  listing.add("bodies", std::to_string(header.scene.boxes.size()) + " at the start");
  listing.add("steps", std::to_string(summary.steps));
  listing.add("log", output);
  listing.add("size", bytes_text(summary.bytes));
  listing.add("final hash", to_string(summary.final_hash));
  listing.print();
}

Result<Exit> import_stream_command(const ImportCommand& options, const std::string& output) {
  if (!options.settings.empty() || !options.like.empty()) {
    return bad_input(options.table + ": found --header or --like, wanted neither: a stream says all of it");
  }
  files::OutputGuard guard;
  guard.keep(options.table, "the stream");
  if (Status ok = guard.claim("-o", output); !ok.ok()) return ok.error();
  return import_stream_file({options.table, output, options.json});
}

Result<Exit> import_command(const ImportCommand& options) {
  std::string output = options.output;
  if (output.empty()) {
    const std::size_t name = options.table.find_last_of('/') + 1;  // 0 without one
    output = options.table.substr(name, options.table.find_last_of('.') - name) + ".tumble";
  }
  if (is_stream_file(options.table)) return import_stream_command(options, output);
  const Result<std::string> text = read_table(options.table);
  if (!text.ok()) return text.error();
  replay::ImportOptions how;
  how.settings = options.settings;
  std::vector<std::string> warnings;
  how.warn = [&warnings](const std::string& warning) { warnings.push_back(warning); };
  if (!options.like.empty()) {
    Result<replay::LogReader> log = open_log(options.like);
    if (!log.ok()) return log.error();
    Result<replay::SessionLike> like = replay::session_like(*log);
    if (!like.ok()) return like.error();
    how.like = *std::move(like);
  }
  files::OutputGuard guard;
  guard.keep(options.table, "the table");
  guard.keep(options.like, "the log of --like");
  if (Status ok = guard.claim("-o", output); !ok.ok()) return ok.error();
  const Result<replay::LogSummary> summary = import_to(options, output, *text, how);
  if (!summary.ok()) return summary.error();
  const Result<replay::LogReader> log = replay::LogReader::open(output);
  if (!log.ok()) return log.error();
  for (const std::string& warning : warnings) std::cerr << "tumble import: warning: " << printable(warning) << '\n';
  print_result(options, output, *summary, log->header(), warnings);
  return Exit::kSame;
}

}  // namespace

Action declare_import(Arguments& arguments) {
  auto options = std::make_shared<ImportCommand>();
  arguments.positional("FILE", options->table, "A table, a row a body and step, or a recorder's stream").required();
  arguments.option("-o,--output", "LOG", options->output,
                   "The log to write (if not given: FILE.tumble in this folder)");
  arguments.option("--header", "LINE", options->settings,
                   "A line of the header, \"key: value\", that wins over the table's: \"up: y\", \"dt: 0.01\"");
  arguments.option("--like", "LOG", options->like,
                   "Take sizes, masses, gravity, dt and camera from this log where the table lacks them");
  arguments.json(options->json);
  arguments.footer(
      "Columns: step or time, id, position.x …, orientation.w …, velocity.x …, spin.x … (angular velocity),\n"
      "and any of frozen, size.x …, mass, static, friction, restitution, row, column.\n"
      "Lines \"# key: value\" before them: engine, version, scene,\n"
      "precision, up, handed, length, dt, gravity, ground, size, mass, friction, restitution.\n"
      "docs/other_engines.md explains each. The log can be compared, measured and drawn, but not replayed.\n\n"
      "A stream of replay/recorder/tumble_recorder.h is known by its first bytes.\n\n"
      "Examples:\n"
      "  tumble import mine.csv -o mine.tumble\n"
      "  tumble import mine.tumblestream -o mine.tumble\n"
      "  tumble import mine.csv --header \"engine: mine\" --header \"up: y\" --header \"dt: 0.016666666666666666\"\n"
      "  tumble import mine.csv --like brick_wall.tumble && tumble diff brick_wall.tumble mine.tumble --tolerance "
      "position=0.01");
  return [options] { return import_command(*options); };
}

}  // namespace tumble::tools
