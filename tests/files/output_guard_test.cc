// Files are known by their identity: no name leads an output over a kept file.
#include "src/files/output_guard.h"

#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

namespace fs = std::filesystem;

class Guards : public TemporaryPlace {
 protected:
  void expect_refused(const Status& status, const std::string& part) const {
    ASSERT_FALSE(status.ok()) << part;
    EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(status.error().message.find(part), std::string::npos) << status.error().message;
  }
  OutputGuard guard_;
};

TEST_F(Guards, AKeptFileIsFoundUnderEveryName) {
  write("a/log", "content");
  fs::create_hard_link(path("a/log"), path("hard"));
  fs::create_symlink("a/log", path("soft"));
  fs::create_directory_symlink("a", path("b"));
  guard_.keep(path("a/log"), "the log");
  for (const char* name : {"a/log", "a/../a/log", "b/log", "hard", "soft"}) {
    expect_refused(guard_.claim("-o", path(name)), "is the log itself");
  }
  EXPECT_TRUE(guard_.claim("-o", path("a/other")).ok());
  EXPECT_TRUE(guard_.claim("--plot", path("none/such")).ok()) << "whoever writes it says so";
}

TEST_F(Guards, TwoOutputsHaveTwoFiles) {
  fs::create_symlink("one", path("two"));
  EXPECT_TRUE(guard_.claim("--series", path("one")).ok());
  expect_refused(guard_.claim("--plot", path("./one")), "is the file of --series too");
  expect_refused(guard_.claim("--plot", path("two")), "is the file of --series too");
  EXPECT_TRUE(guard_.claim("--a", "/dev/null").ok());
  EXPECT_TRUE(guard_.claim("--b", "/dev/null").ok());
}

TEST_F(Guards, AKeptFolderTakesNothingNew) {
  write("suite/cases/one/scene.toml", "");
  guard_.keep_folder(path("suite/cases"), "the suite's cases");
  for (const char* name : {"suite/cases/x", "suite/cases/one/scene.toml", "suite/cases/new/x", "suite/cases/one/a/b"}) {
    expect_refused(guard_.claim("--junit", path(name)), "the suite's cases");
  }
  EXPECT_TRUE(guard_.claim("--junit", path("suite/x")).ok());
  expect_refused(guard_.claim_folder("--report", path("suite")), "the suite's cases");
  expect_refused(guard_.claim_folder("--report", path("suite/cases/one")), "the suite's cases");
  fs::create_directories(path("r"));
  fs::create_directory_symlink(path("suite/cases/one"), path("r/one"));
  expect_refused(guard_.claim_folder("--report", path("r")), "the suite's cases");
  EXPECT_TRUE(guard_.claim_folder("--report", path("report/cases")).ok());
}

TEST_F(Guards, AGoldenIsKnownWithoutASuite) {
  for (const char* name : {"one/scene.toml", "one/metrics.toml", "one/expected.tumble", "one/frame_0001.png"}) {
    write(name, "content");
  }
  fs::create_symlink("one/frame_0001.png", path("picture.png"));
  for (const char* name : {"one/metrics.toml", "one/expected.tumble", "one/frame_0001.png", "picture.png"}) {
    expect_refused(guard_.claim("-o", path(name)), "a file of a golden case");
  }
  EXPECT_TRUE(guard_.claim("-o", path("one/another.csv")).ok());
}

}  // namespace
}  // namespace tumble::files
