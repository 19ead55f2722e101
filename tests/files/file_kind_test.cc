// An output takes the place of a file of its own kind, told by the first bytes.
#include "src/files/file_kind.h"

#include <string>
#include <utility>
#include <vector>

#include "tests/files/temporary_place.h"

namespace tumble::files {
namespace {

using FileKinds = TemporaryPlace;
using namespace std::string_literals;

const std::vector<std::pair<FileKind, std::string>> kBegins = {
    {FileKind::kTable, "step,id"},
    {FileKind::kGltf, "glTF\x02\0"s},
    {FileKind::kPage, std::string(kPageBegins) + " content="},
    {FileKind::kJson, " {\"x\": 1}"},
    {FileKind::kMcap, "\x89MCAP0\r\n"},
    {FileKind::kMp4, "\0\0\0\x18"s + "ftypisom"},
    {FileKind::kArrays, "PK\x03\x04\x14"},
    {FileKind::kPng, "\x89PNG\r\n\x1a\n"},
    {FileKind::kProbes, "TMBLPRB1"},
    {FileKind::kSvg, "<?xml version=\"1.0\"?>\n<svg width="},
    {FileKind::kWebm, "\x1a\x45\xdf\xa3\x01"},
    {FileKind::kJunit, "<?xml version=\"1.0\"?>\n<testsuites>"},
};

// Whatever the name of the file is.
TEST_F(FileKinds, EachKindTakesThePlaceOfItselfAlone) {
  for (const std::string name : {"x", "x.txt", "x.csv", "x.json", "x.xml"}) {
    for (const auto& [kind, content] : kBegins) {
      write(name, content);
      for (const auto& [other, unused] : kBegins) {
        const Status status = replaces_its_kind("-o", path(name), other);
        EXPECT_EQ(status.ok(), other == kind) << name << ": " << content << " by " << unused;
        if (status.ok()) continue;
        EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(status.error().message.find("-o: " + path(name) + ": exists and is no "), std::string::npos)
            << status.error().message;
      }
    }
  }
}

TEST_F(FileKinds, NoneTakesThePlaceOfAnotherFile) {
  const std::vector<std::string> others = {"words",
                                           "int main() { return 0; }",
                                           "\x89tumble\r\n\x1a\n",
                                           "\x89tumblestream\r\n\x1a",
                                           "\x7f"s + "ELF\2\1\1\0"s,
                                           "<!doctype html><p>mine",
                                           "x = 1",
                                           "# a title\nwords",
                                           "step,\0"s};
  for (const std::string& content : others) {
    write("mine", content);
    for (const auto& [kind, unused] : kBegins) {
      EXPECT_FALSE(replaces_its_kind("--plot", path("mine"), kind).ok()) << content << " by " << unused;
    }
  }
}

TEST_F(FileKinds, ATableMayBeginWithSettings) {
  write("t", "# up: y\n# kinds: f64\nstep,time,id\n");
  EXPECT_TRUE(replaces_its_kind("-o", path("t"), FileKind::kTable).ok());
}

TEST_F(FileKinds, TheNameOfAnOutputMayChooseItsKind) {
  for (const auto& [name, kind] : std::vector<std::pair<std::string, FileKind>>{{"a.csv", FileKind::kTable},
                                                                                {"a.b.CSV", FileKind::kTable},
                                                                                {"x/.png", FileKind::kPng},
                                                                                {"a.webm", FileKind::kWebm},
                                                                                {"a.npz", FileKind::kArrays}}) {
    EXPECT_EQ(kind_by_name(name), kind) << name;
  }
}

TEST_F(FileKinds, WhatIsNotThereOrEmptyIsNoLoss) {
  write("empty", "");
  for (const auto& [kind, unused] : kBegins) {
    for (const std::string& place : {path("empty"), path("none"), std::string("/dev/null")}) {
      EXPECT_TRUE(replaces_its_kind("-o", place, kind).ok()) << place;
    }
  }
}

}  // namespace
}  // namespace tumble::files
