#include "replay/import/end_reason.h"

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "replay/log/record_reader.h"
#include "replay/log/record_writer.h"
#include "src/files/output_file.h"
#include "tumble/replay/log_reader.h"

namespace tumble::replay {
namespace {

Status copy_chunk(LogReader& log, const ChunkPlace& place, RecordWriter& writer) {
  const Result<Prelude> prelude = RecordReader(log.source()).read_prelude(place.offset);
  if (!prelude.ok()) return prelude.error();
  std::vector<std::byte> stored(prelude->stored_bytes);
  if (Status ok = log.source().read(place.offset + kPreludeBytes, stored); !ok.ok()) return ok;
  const Result<const StepRecord*> last = log.read_hashes(place.end_step() - 1);
  if (!last.ok()) return last.error();
  return writer.copy_chunk(*prelude, stored, (*last)->state_hash);
}

Status copy_log(LogReader& log, const std::string& reason, RecordWriter& writer) {
  Result<const Keyframe*> start = log.keyframe_at_or_before(log.first_state());
  if (!start.ok()) return start.error();
  LogHeader header = log.header();
  header.declared.cut_short = reason;
  if (Status ok = writer.write_header(header, (*start)->state); !ok.ok()) return ok;
  const std::vector<ChunkPlace> chunks = log.chunks();
  for (const ChunkPlace& place : chunks) {
    if (Status ok = copy_chunk(log, place, writer); !ok.ok()) return ok;
  }
  return writer.finish();
}

Result<std::uint64_t> rewrite(const std::string& path, const std::string& reason, const LogSummary& written) {
  Result<LogReader> log = LogReader::open(path);
  if (!log.ok()) return log.error();
  const Result<Hash128> chain = log->chain_at(log->last_step());
  if (!chain.ok()) return chain.error();
  if (log->file_bytes() != written.bytes || *chain != written.chain) return bad_input(path + ": is another log by now");
  Result<files::OutputFile> file = files::OutputFile::create(path);
  if (!file.ok()) return file.error();
  std::uint64_t bytes = 0;
  {
    Result<std::unique_ptr<ByteSink>> sink = open_part_sink(file->part(), path);
    if (!sink.ok()) return sink.error();
    RecordWriter writer(*std::move(sink));
    if (Status ok = copy_log(*log, reason, writer); !ok.ok()) return ok.error();
    bytes = writer.bytes();
  }
  if (Status ok = file->commit(); !ok.ok()) return ok.error();
  return bytes;
}

}  // namespace

std::string place_of_log(const std::string& path) {
  std::error_code no_folder;
  const std::filesystem::path place = std::filesystem::absolute(path, no_folder);
  return no_folder ? path : place.string();
}

Status keep_end_reason(const std::string& path, const std::string& reason, LogSummary& summary) {
  std::error_code no_file;
  if (reason.empty() || path.empty() || std::filesystem::is_other(path, no_file)) return {};
  const Result<std::uint64_t> bytes = rewrite(path, reason, summary);
  if (!bytes.ok()) return cannot_finish("the log is complete, but cannot keep why it ends: " + bytes.error().message);
  summary.bytes = *bytes;
  return {};
}

}  // namespace tumble::replay
