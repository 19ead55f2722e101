// tumble import, of a recorder's stream.
#include "tools/commands/import_stream.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "replay/stream/import_stream.h"
#include "replay/stream/stream_format.h"
#include "replay/stream/stream_tail.h"
#include "src/files/output_file.h"
#include "src/process/interrupt.h"
#include "tools/files/log_files.h"
#include "tools/output/axes_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/prelude.h"

namespace tumble::tools {
namespace {

using replay::StreamReader;

Json rollback_json(const replay::RollbackCheck& check) {
  Json json = {{"compared", check.compared},
               {"not_compared", check.not_compared},
               {"different", check.different},
               {"first", nullptr}};
  if (!check.first) return json;
  json["first"] = {{"step", check.first->step},
                   {"body", check.first->body ? Json(*check.first->body) : Json(nullptr)},
                   {"field", check.first->field},
                   {"before", check.first->before},
                   {"after", check.first->after}};
  return json;
}

void print_json_result(const StreamFiles& files, const StreamReader& stream, const replay::StreamImport& done) {
  Json json;
  json["log"] = files.output;
  json["engine"] = to_string(stream.header().engine);
  json["steps"] = done.log.steps;
  json["bytes"] = done.log.bytes;
  json["final_hash"] = to_string(done.log.final_hash);
  json["axes"] = axes_json(stream.header().axes);
  json["finished"] = stream.condition().finished;
  json["refusal"] = stream.condition().refusal.empty() ? Json(nullptr) : Json(stream.condition().refusal);
  json["damaged"] = stream.condition().damage.has_value();
  json["hashes_only"] = stream.header().hashes_only;
  json["rewinds"] = stream.rewinds();
  json["superseded_steps"] = stream.superseded().size();
  json["rollbacks"] = rollback_json(done.rollbacks);
  json["passed_over"] = Json::array();  // of a stream the log keeps all
  json["warnings"] = done.warnings;
  print_json("import", json);
}

void print_listing(const StreamFiles& files, const StreamReader& stream, const replay::StreamImport& done) {
  Listing listing;
  listing.add("engine", printable(to_string(stream.header().engine)));
  listing.add("axes", to_string(stream.header().axes));
  if (stream.rewinds() > 0) {
    listing.add("rewinds", std::to_string(stream.rewinds()) + "; " + count_text(stream.superseded().size(), "step") +
                               " recorded again");
    listing.add("sync test", printable(replay::describe(done.rollbacks)));
  }
  if (stream.header().hashes_only) listing.add("holds", "hashes only: no body can be compared or drawn");
  listing.add("steps", std::to_string(done.log.steps));
  listing.add("log", files.output);
  listing.add("size", bytes_text(done.log.bytes));
  listing.add("final hash", to_string(done.log.final_hash));
  listing.print();
}

/// Of a recorder that was stopped: its last steps are beside its stream, unless only the stream was copied.
void advise_about_tail(const StreamFiles& files, const StreamReader& stream, replay::StreamImport& done) {
  const std::string tail = files.stream + replay::kStreamTailSuffix;
  std::error_code error;
  if (stream.condition().finished || stream.condition().damage || !stream.condition().refusal.empty()) return;
  if (std::filesystem::exists(tail, error)) {
    if (replay::has_own_tail(files.stream)) return;
    done.warnings.push_back(
        tail +
        ": is not the tail of this stream, and was passed over; if there is one beside the original "
        "stream, put it here: it has the last steps");
    return;
  }
  done.warnings.push_back(tail +
                          ": found no such file; if there is one beside the original stream, put it here: it has "
                          "the last steps; where the engine went on, the recorder could not write, or an older one "
                          "refused a call, and tumble_rec_message() says why");
}

}  // namespace

std::string no_table(const std::string& path, const std::string& start) {
  if (start.size() >= replay::kMagicEnd && replay::starts_like_log(std::as_bytes(std::span(start)))) {
    return path +
           ": is a log of Tumble already, wanted a table, an archive or a stream; give it to the other commands as it "
           "is ('tumble info " +
           path + "')";
  }
  if (start.substr(0, 16).find("tumblestream") != std::string::npos && start.size() >= replay::kStreamMagic.size()) {
    return path +
           ": is a recorder's stream that was copied as text: line ends or bytes beyond 7 bits are other ones now, and "
           "what it held cannot be told; copy the original in binary mode (of git: *.tumblestream binary in "
           ".gitattributes)";
  }
  const std::string_view magic(reinterpret_cast<const char*>(replay::kStreamMagic.data()), replay::kStreamMagic.size());
  if (start.empty() || start.size() >= magic.size() || !magic.starts_with(start)) return "";
  return path + ": is the beginning of a recorder's stream, cut to " + count_text(start.size(), "byte") +
         ": nothing of the session is in it";
}

bool is_stream_file(const std::string& path) {
  std::array<char, replay::kStreamMagic.size()> first{};
  std::ifstream file(path, std::ios::binary);
  file.read(first.data(), first.size());
  return file.good() && StreamReader::is_stream(std::as_bytes(std::span(first)));
}

Result<Exit> import_stream_file(const StreamFiles& files) {
  Result<std::unique_ptr<replay::ByteSource>> source = replay::open_stream_source(files.stream);
  if (!source.ok()) return source.error();
  Result<StreamReader> stream = StreamReader::open(*std::move(source));
  if (!stream.ok()) return stream.error();
  if (Status ok = replay::may_replace(files.output); !ok.ok()) return ok.error();
  Result<files::OutputFile> file =
      files::OutputFile::create(files.output);  // what was there stays until this is complete
  if (!file.ok()) return file.error();
  ProgressBar bar("importing", !files.quiet);
  const process::InterruptGuard guard;
  Result<replay::StreamImport> done = replay::import_stream(
      *stream, [&] { return replay::open_part_sink(file->part(), files.output); }, bar.progress());
  bar.finish();
  if (!done.ok()) return done.error();
  if (Status ok = file->commit(); !ok.ok()) return ok.error();
  advise_about_tail(files, *stream, *done);
  for (const std::string& warning : done->warnings)
    std::cerr << "tumble import: warning: " << printable(warning) << '\n';
  if (!done->refused.empty()) {
    const std::uint64_t last = stream->steps().front().step + done->log.steps;
    return bad_input(done->refused + "; the log holds the steps before, up to " + std::to_string(last));
  }
  if (files.json) print_json_result(files, *stream, *done);
  if (!files.json && !files.quiet) print_listing(files, *stream, *done);
  if (done->rollbacks.first) {
    std::cerr << "tumble import: warning: rollback: " << printable(replay::describe(done->rollbacks)) << '\n';
  }
  return stream->condition().damage ? Exit::kDamaged : Exit::kSame;
}

}  // namespace tumble::tools
