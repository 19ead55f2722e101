// A log's file, when the system below it fails: every write, sync, read, rename. No crash, an error that says what and
// where, and what was complete stays.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "replay/log/verify.h"
#include "replay/recover/recover.h"
#include "src/files/output_file.h"
#include "tests/support/faulty_files.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {
namespace {

using test::FaultyFiles;
using test::FileFaults;

/// A folder with a log in it, removed at the end.
class LogFaults : public testing::Test {
 protected:
  LogFaults() {
    std::string pattern = testing::TempDir() + "tumble-faults-XXXXXX";
    EXPECT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    path_ = folder_ + "/log.tumble";
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// Records 24 steps, a chunk every 6, until an error. acknowledged: chunks that flush() said were in the file.
  Status record(const FileFaults& faults, std::size_t* acknowledged = nullptr) {
    std::filesystem::remove(path_);
    const FaultyFiles faulty(faults);
    auto recorder = Recorder::start(path_, scene_with_inputs(24), {});
    if (!recorder.ok()) return recorder.error();
    for (int k = 1; k <= 24; ++k) {
      if (Status ok = (*recorder)->step(); !ok.ok()) return ok;
      if (k % 6 != 0) continue;
      if (Status ok = (*recorder)->flush(); !ok.ok()) return ok;
      if (acknowledged != nullptr) ++*acknowledged;
    }
    const Result<LogSummary> summary = (*recorder)->finish();
    writes_ = FaultyFiles::writes();
    return summary.ok() ? Status() : Status(summary.error());
  }

  [[nodiscard]] std::string content() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  /// The log that is there has at least the chunks that were promised, and no damage.
  void expect_chunks(std::size_t promised) const {
    Result<LogReader> log = LogReader::open(path_);
    if (!log.ok()) {
      EXPECT_EQ(promised, 0U) << log.error().message;
      return;
    }
    EXPECT_GE(log->chunks().size(), promised);
    EXPECT_FALSE(log->condition().finished);
    EXPECT_TRUE(verify(*log).condition.damages.empty());
  }

  std::string folder_;
  std::string path_;
  int writes_ = 0;
};

void expect_message(const Status& status, ErrorKind kind, const std::vector<std::string>& parts) {
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, kind) << status.error().message;
  for (const std::string& part : parts) {
    EXPECT_NE(status.error().message.find(part), std::string::npos) << status.error().message;
  }
}

TEST_F(LogFaults, AFullDiskAtAnyWriteKeepsWhatWasComplete) {
  ASSERT_TRUE(record({}).ok());
  const int writes = writes_;
  ASSERT_GE(writes, 13);  // a prelude and a payload for each record, and the footer
  for (int at = 0; at < writes; ++at) {
    for (const int error : {ENOSPC, EDQUOT, EIO}) {
      for (const int truncate_error : {0, EIO}) {
        SCOPED_TRACE("write " + std::to_string(at));
        FileFaults faults;
        faults.write_error = error;
        faults.write_fails_at = at;
        faults.truncate_error = truncate_error;
        std::size_t acknowledged = 0;
        const Status status = record(faults, &acknowledged);
        expect_message(status, ErrorKind::kCannotFinish, {path_, "at byte", strerror(error)});
        expect_chunks(acknowledged);
      }
    }
  }
}

TEST_F(LogFaults, ShortWritesAndSignalsChangeNoByte) {
  ASSERT_TRUE(record({}).ok());
  const std::string whole = content();
  FileFaults faults;
  faults.write_max = 5;
  faults.interrupt_every = 3;
  ASSERT_TRUE(record(faults).ok());
  EXPECT_TRUE(content() == whole);
  const FaultyFiles faulty(faults);
  Result<LogReader> log = LogReader::open(path_);
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_TRUE(verify(*log).condition.whole());
  EXPECT_GT(FaultyFiles::interruptions(), 100);
}

TEST_F(LogFaults, AnInterruptedSyncIsDoneAgain) {
  FileFaults faults;
  faults.interrupt_every = 2;  // of two calls one is a write, so each sync meets it sooner or later
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(record(faults).ok());
}

TEST_F(LogFaults, ALogThatDidNotReachTheDiskIsNotCalledFinished) {
  for (const int at : {0, 1}) {
    FileFaults faults;
    faults.sync_error = EIO;
    faults.sync_fails_at = at;
    std::size_t acknowledged = 0;
    const Status status = record(faults, &acknowledged);
    expect_message(status, ErrorKind::kCannotFinish, {path_, "footer", "Input/output error"});
    EXPECT_EQ(acknowledged, 4U);
  }
}

TEST_F(LogFaults, WhereNothingMayBeWrittenItSaysWhy) {
  const std::vector<std::pair<int, ErrorKind>> cases = {{EROFS, ErrorKind::kCannotFinish},
                                                        {ENOSPC, ErrorKind::kCannotFinish},
                                                        {EMFILE, ErrorKind::kCannotFinish},
                                                        {EACCES, ErrorKind::kBadInput},
                                                        {ENOENT, ErrorKind::kBadInput}};
  for (const auto& [error, kind] : cases) {
    FileFaults faults;
    faults.open_error = error;
    expect_message(record(faults), kind, {path_, "cannot be written", strerror(error)});
    EXPECT_FALSE(std::filesystem::exists(path_));
  }
}

TEST_F(LogFaults, TheLimitsOfTheSystemAreNoBadInput) {
  for (const int error : {ENFILE, ENOMEM, EMFILE, EROFS}) {
    FileFaults faults;
    faults.open_error = error;
    expect_message(record(faults), ErrorKind::kCannotFinish, {path_, strerror(error)});
    const FaultyFiles faulty(faults);
    expect_message(files::write_whole_file(path_, "x"), ErrorKind::kCannotFinish, {path_, strerror(error)});
  }
}

TEST_F(LogFaults, AnOutputThatDidNotReachTheDiskReplacesNothing) {
  ASSERT_TRUE(record({}).ok());
  const std::string old = content();
  FileFaults faults;
  faults.sync_error = EIO;
  faults.sync_fails_at = 0;
  {
    const FaultyFiles faulty(faults);
    expect_message(files::write_whole_file(path_, "new"), ErrorKind::kCannotFinish, {path_, "Input/output error"});
  }
  EXPECT_TRUE(content() == old);
  for (const int error : {EINVAL, EROFS}) {  // no file on a disk
    faults.sync_error = error;
    const FaultyFiles faulty(faults);
    EXPECT_TRUE(files::write_whole_file(path_, "new").ok());
  }
}

TEST_F(LogFaults, AnEmptyNameIsSaidToBeOne) {
  const auto log = LogReader::open("");
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().message, "found an empty name, wanted the file of a log");
}

TEST_F(LogFaults, AReadThatFailsNamesFileAndByte) {
  ASSERT_TRUE(record({}).ok());
  int reads = 0;
  {
    const FaultyFiles counted{{}};
    Result<LogReader> log = LogReader::open(path_);
    (void)verify(*log).condition.whole();
    reads = FaultyFiles::reads();
  }
  ASSERT_GT(reads, 10);
  for (int at = 0; at < reads; ++at) {
    SCOPED_TRACE("read " + std::to_string(at));
    FileFaults faults;
    faults.read_error = EIO;
    faults.read_fails_at = at;
    const FaultyFiles faulty(faults);
    Result<LogReader> log = LogReader::open(path_);
    if (!log.ok()) {
      expect_message(log.error(), ErrorKind::kCannotFinish, {path_, "cannot read at byte", "Input/output error"});
      continue;
    }
    EXPECT_FALSE(verify(*log).condition.whole()) << "what could not be read was called whole";
  }
}

TEST_F(LogFaults, AFileThatShrinksWhileItIsReadIsDamaged) {
  ASSERT_TRUE(record({}).ok());
  Result<LogReader> log = LogReader::open(path_);
  ASSERT_TRUE(log.ok());
  std::filesystem::resize_file(path_, log->chunks()[2].offset + 10);
  EXPECT_TRUE(log->read_step(12).ok());
  const Result<const StepRecord*> step = log->read_step(13);
  expect_message(step.ok() ? Status() : Status(step.error()), ErrorKind::kDamaged, {path_, "the file ends at byte"});
}

TEST_F(LogFaults, AFileRemovedWhileItIsOpenIsReadToItsEnd) {
  ASSERT_TRUE(record({}).ok());
  Result<LogReader> log = LogReader::open(path_);
  ASSERT_TRUE(log.ok());
  std::filesystem::remove(path_);
  EXPECT_TRUE(verify(*log).condition.whole());
}

TEST_F(LogFaults, WhoReadsALogThatIsRecordedAgainKeepsIt) {
  ASSERT_TRUE(record({}).ok());
  Result<LogReader> log = LogReader::open(path_);
  ASSERT_TRUE(log.ok());
  {
    auto again = Recorder::start(path_, small_scene(3), {});
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_FALSE(open_file_sink(path_).ok()) << "the new file is locked";
    ASSERT_TRUE((*again)->run().ok() && (*again)->finish().ok());
  }
  EXPECT_TRUE(verify(*log).condition.whole());
  EXPECT_EQ(log->step_count(), 24U);
  EXPECT_EQ(LogReader::open(path_)->step_count(), 3U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "nothing else stays";
}

TEST_F(LogFaults, RecoveryOnAFullDiskLeavesTheDamagedLogAlone) {
  ASSERT_TRUE(record({}).ok());
  const std::string whole = content();
  const Result<std::unique_ptr<ByteSource>> source = open_file_source(path_);
  for (int at = 0; at < writes_; ++at) {
    FileFaults faults;
    faults.write_error = ENOSPC;
    faults.write_fails_at = at;
    const FaultyFiles faulty(faults);
    const std::string saved = folder_ + "/saved.tumble";
    const Result<RecoverReport> report = recover_log(**source, *open_file_sink(saved));
    expect_message(report.ok() ? Status() : Status(report.error()), ErrorKind::kCannotFinish, {saved, "No space left"});
  }
  EXPECT_TRUE(content() == whole);
}

TEST_F(LogFaults, ARenameThatFailsNamesBothFiles) {
  ASSERT_TRUE(record({}).ok());
  FileFaults faults;
  faults.rename_error = EXDEV;
  const FaultyFiles faulty(faults);
  expect_message(rename_file(path_, path_ + ".new"), ErrorKind::kCannotFinish, {path_, path_ + ".new", "cross-device"});
  EXPECT_TRUE(std::filesystem::exists(path_));
}

}  // namespace
}  // namespace tumble::replay
