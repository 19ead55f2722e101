// A file is replaced as a whole or not at all.
#include "src/files/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

namespace fs = std::filesystem;
using OutputFiles = TemporaryPlace;

TEST_F(OutputFiles, TheOldFileStaysUntilTheNewOneIsComplete) {
  write("x", "old");
  Result<OutputFile> file = OutputFile::create(path("x"));
  ASSERT_TRUE(file.ok()) << file.error().message;
  ASSERT_TRUE(file->write("new").ok());
  EXPECT_EQ(read("x"), "old");
  ASSERT_TRUE(file->commit().ok());
  EXPECT_EQ(read("x"), "new");
  EXPECT_EQ(count(), 1U) << "nothing else stays";
}

TEST_F(OutputFiles, WhatIsNotCommittedIsDiscarded) {
  write("x", "old");
  {
    Result<OutputFile> file = OutputFile::create(path("x"));
    ASSERT_TRUE(file.ok());
    ASSERT_TRUE(file->write(std::string(1 << 20, 'n')).ok());
    OutputFile moved = *std::move(file);
    EXPECT_EQ(count(), 2U);
  }
  EXPECT_EQ(read("x"), "old");
  EXPECT_EQ(count(), 1U);
}

TEST_F(OutputFiles, AFileOfAnotherNameIsNeverInTheWay) {
  write("x.part", "another's");
  write("x", "old");
  ASSERT_TRUE(write_whole_file(path("x"), "new").ok());
  EXPECT_EQ(read("x.part"), "another's");
}

TEST_F(OutputFiles, WhatAKilledWriterLeftIsRemovedByTheNext) {
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  const std::string left = "x.part-" + std::to_string(gone) + "-0";
  const std::string alive = "x.part-" + std::to_string(::getppid()) + "-0";
  const std::string locked = "x.part-" + std::to_string(gone) + "-1";
  for (const std::string& name : {left, alive, locked, "y.part-" + std::to_string(gone) + "-0", left + "a"}) {
    write(name, "part");
  }
  const int lock = ::open(path(locked).c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  ASSERT_TRUE(write_whole_file(path("x"), "new").ok());
  ::close(lock);
  EXPECT_FALSE(fs::exists(path(left)));
  EXPECT_EQ(count(), 5U) << "those of other outputs, of processes that live and of files that are locked stay";
}

TEST_F(OutputFiles, ALinkStaysALink) {
  write("x", "old");
  fs::create_symlink("x", path("link"));
  fs::create_symlink("later", path("to_nothing"));
  ASSERT_TRUE(write_whole_file(path("link"), "new").ok());
  ASSERT_TRUE(write_whole_file(path("to_nothing"), "new").ok());
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read("x"), "new");
  EXPECT_EQ(read("later"), "new");
}

TEST_F(OutputFiles, APipeThatNothingReadsIsRefusedAtOnce) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const Status written = write_whole_file(path("pipe"), "new");
  EXPECT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("a pipe that nothing reads"), std::string::npos) << written.error().message;
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(write_whole_file(path("pipe"), "new").ok());
  std::array<char, 8> got{};
  EXPECT_EQ(::read(reader, got.data(), got.size()), 3);
  ::close(reader);
}

TEST_F(OutputFiles, ModesStay) {
  write("x", "old");
  ASSERT_EQ(::chmod(path("x").c_str(), 0640), 0);
  ASSERT_TRUE(write_whole_file(path("x"), "new").ok());
  struct stat info = {};
  ASSERT_EQ(::stat(path("x").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0640U);
}

TEST_F(OutputFiles, OnlyRegularFilesAreReplaced) {
  fs::create_symlink("/dev/null", path("null"));
  ASSERT_TRUE(write_whole_file(path("null"), "gone").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  fs::create_symlink("/dev/full", path("full"));
  const Status full = write_whole_file(path("full"), "no room");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().kind, ErrorKind::kCannotFinish);
  EXPECT_NE(full.error().message.find("No space left"), std::string::npos) << full.error().message;
  const Status folder = write_whole_file(folder_.string(), "x");
  ASSERT_FALSE(folder.ok());
  EXPECT_EQ(folder.error().kind, ErrorKind::kBadInput);
  const Status nowhere = write_whole_file(path("none/x"), "x");
  ASSERT_FALSE(nowhere.ok());
  EXPECT_EQ(nowhere.error().kind, ErrorKind::kBadInput);
}

}  // namespace
}  // namespace tumble::files
