// Folders that go with the process: what a signal's handler removes, and what it leaves.
#include "src/files/short_lived_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/files/gate.h"
#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

namespace fs = std::filesystem;

class ShortLivedFolder : public TemporaryPlace {
 protected:
  [[nodiscard]] fs::path made() const {
    fs::path folder = make_short_lived_folder(path(""), "made");
    EXPECT_FALSE(folder.empty());
    return folder;
  }
};

void fill(const fs::path& folder) {
  fs::create_directories(folder / "a" / "b");
  for (int k = 0; k < 300; ++k) std::ofstream(folder / "a" / ("file_" + std::to_string(k))) << k;
  std::ofstream(folder / "a" / "b" / ".hidden") << 1;
}

struct Ended {
  pid_t process = 0;
  int status = -1;
};

/// Runs `work` in a process of its own, to its end.
template <class Work>
Ended in_child(Work work) {
  Ended ended;
  ended.process = ::fork();
  EXPECT_GE(ended.process, 0);
  if (ended.process == 0) {
    work();
    ::_exit(0);
  }
  EXPECT_EQ(::waitpid(ended.process, &ended.status, 0), ended.process);
  return ended;
}

/// Runs `work` in a process that then ends as after a signal.
template <class Work>
void ended_after(Work work) {
  const Ended ended = in_child([&] {
    work();
    remove_short_lived_folders();
  });
  EXPECT_EQ(ended.status, 0);
}

TEST_F(ShortLivedFolder, IsRemovedWithAllThatIsInItAndNothingElse) {
  const fs::path kept = path("kept");
  fill(kept);
  ended_after([&] {
    const fs::path gone = made();
    fill(gone);
    fs::create_directory_symlink(kept, gone / "link");
  });
  EXPECT_EQ(count(), 1U);
  EXPECT_TRUE(fs::exists(kept / "a" / "b" / ".hidden")) << "a link is no folder";
}

TEST_F(ShortLivedFolder, OneThatIsForgottenStays) {
  ended_after([&] {
    const fs::path folder = made();
    fill(folder);
    forget_short_lived_folder(folder.string());
  });
  EXPECT_EQ(count(), 1U);
}

TEST_F(ShortLivedFolder, AChildRemovesNoneOfItsParent) {
  const fs::path folder = made();
  fill(folder);
  ended_after([] {});
  EXPECT_TRUE(fs::exists(folder / "a"));
  forget_short_lived_folder(folder.string());
}

/// Runs `work` in a process that then ends as one does that was killed: nothing is removed.
template <class Work>
pid_t killed_after(Work work) {
  const Ended ended = in_child([&] {
    work();
    ::raise(SIGKILL);
  });
  EXPECT_TRUE(WIFSIGNALED(ended.status));
  return ended.process;
}

TEST_F(ShortLivedFolder, WhatAKilledProcessLeftGoesWithTheNextFolder) {
  const pid_t killed = killed_after([&] { fill(made()); });
  ASSERT_EQ(count(), 1U);
  const std::string maker = "made-" + std::to_string(killed);
  fill(path("kept"));
  fs::create_directory_symlink(path("kept"), path(maker + "-linked"));
  write(maker + "-a_file", "");
  for (const std::string& name : {maker + "-abcde", maker + "-abcdefg", maker, std::string("made--abcdef"),
                                  "other-" + std::to_string(killed) + "-abcdef"}) {
    fs::create_directory(path(name));
  }
  const fs::path mine = made();
  EXPECT_EQ(count(), 9U) << "the folder alone goes";
  EXPECT_TRUE(fs::exists(path("kept") + "/a/b/.hidden"));
  EXPECT_TRUE(mine.filename().string().starts_with("made-" + std::to_string(::getpid()) + '-')) << mine;
  forget_short_lived_folder(mine.string());
}

TEST_F(ShortLivedFolder, ThatOfAProcessThatRunsStays) {
  Gate gate, has_made;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    fill(made());
    has_made.open();
    gate.wait();
    ::_exit(0);
  }
  has_made.wait();
  const fs::path mine = made();
  EXPECT_EQ(count(), 2U);
  gate.open();
  EXPECT_EQ(::waitpid(child, nullptr, 0), child);
  const fs::path next = made();
  EXPECT_EQ(count(), 2U) << "then it goes";
  for (const fs::path& one : {mine, next}) forget_short_lived_folder(one.string());
}

TEST_F(ShortLivedFolder, ThatOfAKilledProcessStaysWhileAChildOfItWorks) {
  Gate gate;
  killed_after([&] {
    fill(made());
    if (::fork() != 0) return;
    gate.wait();
    ::_exit(0);
  });
  const fs::path left = fs::directory_iterator(folder_)->path();
  const fs::path mine = made();
  EXPECT_EQ(count(), 2U);
  gate.open();
  const int lock = ::open(left.c_str(), O_RDONLY | O_DIRECTORY);
  EXPECT_EQ(::flock(lock, LOCK_EX), 0) << "when the child has ended";
  ::close(lock);
  const fs::path next = made();
  EXPECT_EQ(count(), 2U) << "then it goes";
  for (const fs::path& one : {mine, next}) forget_short_lived_folder(one.string());
}

}  // namespace
}  // namespace tumble::files
