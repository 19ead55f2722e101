// Folders that go with the process: what a signal's handler removes, and what it leaves.
#include "src/files/short_lived_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

namespace fs = std::filesystem;

class ShortLivedFolder : public TemporaryPlace {
 protected:
  [[nodiscard]] fs::path made() const {
    std::string pattern = path("made-XXXXXX");
    EXPECT_TRUE(make_short_lived_folder(pattern));
    return pattern;
  }
};

void fill(const fs::path& folder) {
  fs::create_directories(folder / "a" / "b");
  for (int k = 0; k < 300; ++k) std::ofstream(folder / "a" / ("file_" + std::to_string(k))) << k;
  std::ofstream(folder / "a" / "b" / ".hidden") << 1;
}

TEST_F(ShortLivedFolder, IsRemovedWithAllThatIsInItAndNothingElse) {
  const fs::path kept = path("kept");
  fill(kept);
  const fs::path gone = made();
  fill(gone);
  fs::create_directory_symlink(kept, gone / "link");
  remove_short_lived_folders();
  forget_short_lived_folder(gone.string());
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_TRUE(fs::exists(kept / "a" / "b" / ".hidden")) << "a link is no folder";
}

TEST_F(ShortLivedFolder, OneThatIsForgottenStays) {
  const fs::path folder = made();
  fill(folder);
  forget_short_lived_folder(folder.string());
  remove_short_lived_folders();
  EXPECT_TRUE(fs::exists(folder / "a"));
}

TEST_F(ShortLivedFolder, AChildRemovesNoneOfItsParent) {
  const fs::path folder = made();
  fill(folder);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    remove_short_lived_folders();
    ::_exit(0);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(fs::exists(folder / "a"));
  forget_short_lived_folder(folder.string());
}

}  // namespace
}  // namespace tumble::files
