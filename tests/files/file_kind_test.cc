// An output takes the place of a file of its own kind, told by the first bytes.
#include "src/files/file_kind.h"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

using FileKinds = TemporaryPlace;
using namespace std::string_literals;

const std::vector<std::pair<std::string, std::string>> kBegins = {
    {".csv", "step,id"},
    {".glb", "glTF\x02\0"s},
    {".mcap", "\x89MCAP0\r\n"},
    {".npz", "PK\x03\x04\x14"},
    {".mp4", "\0\0\0\x18"s + "ftypisom"},
    {".webm", "\x1a\x45\xdf\xa3\x01"},
    {".png", "\x89PNG\r\n\x1a\n"},
    {".html", std::string(kPageBegins) + " content="},
};

TEST_F(FileKinds, EachEndingTakesItsOwnKind) {
  for (const auto& [ending, content] : kBegins) {
    write("x" + ending, content);
    EXPECT_TRUE(replaces_its_kind("-o", path("x" + ending)).ok()) << ending;
    for (const auto& [other, unused] : kBegins) {
      const bool is_text = other == ".csv" && ending == ".html";  // a page is text
      if (other == ending || is_text) continue;
      write("y" + other, content);
      const Status status = replaces_its_kind("-o", path("y" + other));
      const bool is_binary = content.find('\0') != std::string::npos || ending == ".png";
      if (other == ".csv" && !is_binary) continue;
      ASSERT_FALSE(status.ok()) << ending << " under the name " << other;
      EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
      EXPECT_NE(status.error().message.find("-o: " + path("y" + other) + ": exists and is no "), std::string::npos)
          << status.error().message;
    }
  }
}

TEST_F(FileKinds, TextsAreToldByTheirFirstCharacter) {
  for (const auto& [name, content, fits] : std::vector<std::tuple<std::string, std::string, bool>>{
           {"a.json", " {\"x\": 1}", true},
           {"b.json", "[1]", true},
           {"c.json", "x = 1", false},
           {"a.svg", "<svg/>", true},
           {"b.svg", "\n<?xml", true},
           {"c.svg", "words", false},
           {"a.xml", "<testsuites/>", true},
           {"b.xml", "{}", false},
           {"a.CSV", "a\0b"s, false},
           {"a.html", "<!doctype html><p>mine", false},
           {"a.txt", "words", true},
           {"a.png", "", true},
       }) {
    write(name, content);
    EXPECT_EQ(replaces_its_kind("--plot", path(name)).ok(), fits) << name;
  }
  EXPECT_TRUE(replaces_its_kind("-o", path("none.png")).ok());
  EXPECT_TRUE(replaces_its_kind("-o", "/dev/null").ok());
}

}  // namespace
}  // namespace tumble::files
