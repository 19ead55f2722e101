// Round trips of every golden case, at its full length.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/export/same_states.h"

namespace tumble::test {
namespace {

TEST(EveryCase, ComesBackToTheBitThroughEveryTable) {
  for (const auto& folder : std::filesystem::directory_iterator(TUMBLE_SOURCE_DIR "/golden/cases")) {
    const std::string name = folder.path().filename().string();
    if (!exists(folder.path() / "scene.toml")) continue;  // another engine's session
    const Workshop shop;
    ASSERT_EQ(shop.run({"record", name, "-o", "a.tumble"}).exit, 0) << name;
    SCOPED_TRACE(name);
    for (const char* ending : {".csv", ".npz"}) expect_round_trip(shop, "a.tumble", ending);
  }
}

}  // namespace
}  // namespace tumble::test
