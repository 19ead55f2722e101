// tumble recover: makes a whole log of the intact parts of a damaged one.
#include "replay/recover/recover.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "replay/log/verify.h"
#include "src/files/output_file.h"
#include "src/files/output_guard.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/output/text.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

using replay::RecoverReport;

constexpr std::size_t kDamagesShown = 12;

struct RecoverCommand {
  std::string damaged;
  std::string log;
  bool json = false;
};

Status check_names(const RecoverCommand& options) {
  files::OutputGuard guard;
  guard.keep(options.damaged, "the damaged log");
  if (Status ok = guard.claim("-o", options.log); !ok.ok()) return ok;
  return replay::may_replace(options.log);
}

/// Reads the new log from end to end before success is reported.
Status verify_written(const std::string& path, const RecoverReport& report) {
  Result<replay::LogReader> log = replay::LogReader::open(path);
  if (!log.ok()) return log.error();
  const replay::VerifyReport verified = replay::verify(*log);
  if (!verified.condition.sound()) {
    return cannot_finish(path + ": the new log does not read back: " + verified.condition.summary(log->last_step()) +
                         "; the damaged log was not touched");
  }
  if (verified.steps_checked == report.steps && log->last_step() == report.last_step) return {};
  return cannot_finish(path + ": found " + std::to_string(verified.steps_checked) + " steps in the new log, " +
                       "wanted " + std::to_string(report.steps) + "; the damaged log was not touched");
}

std::string lost_text(const RecoverReport& report) {
  std::string text;
  for (const replay::MissingSteps& run : report.lost) text += (text.empty() ? "" : ", ") + to_string(run);
  if (!report.end_known) {
    text += (text.empty() ? "" : ", and ") + std::string("what may have come after step ") +
            std::to_string(report.last_step) + " (the end was not written or is gone)";
  }
  if (report.header_lost)
    text += (text.empty() ? "" : "; ") + std::string("the header: names, looks, camera, scene text");
  const replay::OtherParts& others = report.others;
  if (others.records > 0) {
    text += (text.empty() ? "" : "; ") + count_text(others.records, "record") +
            (others.logs == 1 ? " of another log" : " of other logs") + " (" + count_text(others.steps, "step") + ")";
  }
  if (others.unfit_chunks > 0) {
    text += (text.empty() ? "" : "; ") + count_text(others.unfit_chunks, "whole chunk") + " (" +
            count_text(others.unfit_steps, "step") + ") beside this session with an equal header";
  }
  return text.empty() ? "nothing" : text;
}

std::string with_bytes(const RecoverReport& report) {
  if (report.lost_bytes == 0) return lost_text(report);
  if (report.nothing_lost()) {
    return "nothing of the session; left out: " + bytes_text(report.lost_bytes) + " that are part of no whole record";
  }
  return lost_text(report) + "; " + bytes_text(report.lost_bytes) + " of the file are not in the new log";
}

void print_text(const RecoverCommand& options, const RecoverReport& report) {
  Listing listing;
  listing.add("recovered", options.log + ", " + bytes_text(report.bytes));
  listing.add("steps", count_text(report.steps, "step") + " in " + count_text(report.chunks, "chunk") + ", states " +
                           std::to_string(report.first_state) + " to " + std::to_string(report.last_step));
  listing.add("lost", with_bytes(report));
  listing.add("checked", "every byte of it was read again");
  listing.print();
  for (std::size_t i = 0; i < report.damages.size() && i < kDamagesShown; ++i) {
    std::cout << "  byte " << report.damages[i].offset << ": " << printable(report.damages[i].message) << '\n';
  }
  if (report.damages.size() > kDamagesShown) {
    std::cout << "  and " << report.damages.size() - kDamagesShown << " more; --json has them all\n";
  }
}

void print_as_json(const RecoverCommand& options, const RecoverReport& report) {
  Json json;
  json["damaged"] = options.damaged;
  json["log"] = options.log;
  json["nothing_lost"] = report.nothing_lost();
  json["first_state"] = report.first_state;
  json["last_step"] = report.last_step;
  json["steps"] = report.steps;
  json["chunks"] = report.chunks;
  json["bytes"] = report.bytes;
  json["lost_steps"] = Json::array();
  for (const replay::MissingSteps& run : report.lost)
    json["lost_steps"].push_back({run.first_step, run.end_step() - 1});
  json["end_known"] = report.end_known;
  json["header_lost"] = report.header_lost;
  json["lost_bytes"] = report.lost_bytes;
  json["other_records"] = report.others.records;
  json["unfit_chunks"] = report.others.unfit_chunks;
  json["damages"] = Json::array();
  for (const replay::Damage& damage : report.damages) {
    json["damages"].push_back({{"byte", damage.offset}, {"message", damage.message}});
  }
  print_json("recover", json);
}

Result<RecoverReport> write_partial(const replay::ByteSource& source, const files::OutputFile& file,
                                    const std::string& path) {
  Result<std::unique_ptr<replay::ByteSink>> sink = replay::open_part_sink(file.part(), path);
  if (!sink.ok()) return sink.error();
  return replay::recover_log(source, *std::move(sink));
}

Result<Exit> recover(const RecoverCommand& options) {
  Result<std::unique_ptr<replay::ByteSource>> source = replay::open_file_source(options.damaged);
  if (!source.ok()) return source.error();
  if (Status ok = check_names(options); !ok.ok()) return ok.error();
  Result<files::OutputFile> file =
      files::OutputFile::create(options.log);  // the old log stays until the new one is read
  if (!file.ok()) return file.error();
  const Result<RecoverReport> report = write_partial(**source, *file, options.log);
  if (!report.ok()) return report.error();
  if (file->is_device())
    return bad_input("-o: " + options.log + ": found a device or a pipe, wanted a file to read back");
  if (Status ok = verify_written(file->part(), *report); !ok.ok()) return ok.error();
  if (Status ok = file->commit(); !ok.ok()) return ok.error();
  if (options.json) {
    print_as_json(options, *report);
  } else {
    print_text(options, *report);
  }
  if (report->nothing_lost()) return Exit::kSame;
  std::cerr << "tumble recover: " << options.damaged << ": lost: " << lost_text(*report) << '\n';
  return Exit::kDamaged;
}

}  // namespace

Action declare_recover(Arguments& arguments) {
  auto options = std::make_shared<RecoverCommand>();
  arguments.positional("DAMAGED", options->damaged, "The log to recover; it is only read").required();
  arguments.option("-o,--output", "LOG", options->log, "The log to write").required();
  arguments.json(options->json);
  arguments.footer(
      "Keeps every intact chunk, wherever it lies in the file, also behind damage, and reads the new log from end to\n"
      "end before it reports success. Exit status: 0 nothing was lost, 3 something was, and is named; 2 the file was\n"
      "never a log; 4 the new log could not be written.\n\n"
      "Examples:\n"
      "  tumble recover torn.tumble -o saved.tumble\n"
      "  tumble recover torn.tumble -o saved.tumble --json");
  return [options] { return recover(*options); };
}

}  // namespace tumble::tools
