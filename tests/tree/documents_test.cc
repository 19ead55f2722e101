// Names, lists and documents agree with the code, and texts stay free of what does not belong in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/source_tree.h"

namespace tumble::test {
namespace {

namespace fs = std::filesystem;

const SourceFile* find(const std::string& path) {
  const auto found = std::ranges::find(source_tree(), path, &SourceFile::path);
  return found == source_tree().end() ? nullptr : &*found;
}

// The first column of the phase table of src/step/step.cc.
std::vector<std::string> phase_names() {
  std::vector<std::string> names;
  const SourceFile* step = find("src/step/step.cc");
  if (step == nullptr) return names;
  const std::regex row("^ *\\{\"([a-z_]+)\", ");
  for (const std::string& line : step->lines) {
    std::smatch match;
    if (std::regex_search(line, match, row)) names.push_back(match[1]);
  }
  return names;
}

TEST(Documents, EveryPhaseHasItsFileAndItsHeading) {
  const std::vector<std::string> phases = phase_names();
  ASSERT_GE(phases.size(), 5U) << "no phase table found in src/step/step.cc";
  const SourceFile* document = find("docs/step.md");
  ASSERT_NE(document, nullptr) << "docs/step.md is missing";
  for (const std::string& phase : phases) {
    const bool has_file = std::ranges::any_of(source_tree(), [&](const SourceFile& file) {
      return file.is_under("src/") && file.ends_with("/" + phase + ".cc");
    });
    EXPECT_TRUE(has_file) << "phase " << phase << " has no file src/*/" << phase << ".cc";
    const std::regex heading("^##+ .*\\b" + phase + "\\b");
    EXPECT_TRUE(
        std::ranges::any_of(document->lines, [&](const std::string& line) { return std::regex_search(line, heading); }))
        << "docs/step.md has no heading for phase " << phase;
  }
}

// The first group of a pattern in a file; empty where it is not found.
std::string number_in(const std::string& path, const std::string& pattern) {
  const SourceFile* file = find(path);
  const std::string text = file == nullptr ? "" : file->text();
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "";
}

TEST(Documents, VersionsAreThoseOfTheCode) {
  const std::string thesis = number_in("src/world/world_state.cc", "case Method::kThesis:\\s+return (\\d+);");
  const std::string layered = number_in("src/world/world_state.cc", "case Method::kLayered:\\s+return (\\d+);");
  const std::string hashes = number_in("src/step/step.h", "kVersion = (\\d+);");
  const std::string major = number_in("replay/format/prelude.h", "kFormatMajor = (\\d+);");
  const std::string minor = number_in("replay/format/prelude.h", "kFormatMinor = (\\d+);");
  for (const std::string& number : {thesis, layered, hashes, major, minor}) ASSERT_NE(number, "") << "not in the code";
  const auto expect = [](const std::string& path, const std::string& words) {
    ASSERT_NE(find(path), nullptr) << path << " is missing";
    EXPECT_NE(find(path)->text().find(words), std::string::npos) << path << " does not say " << words;
  };
  expect("docs/versions.md", "| method `thesis`, `layered` | " + thesis + ", " + layered + " |");
  expect("docs/versions.md", "| phase hashes | " + hashes + " |");
  expect("docs/versions.md", "| log format | " + major + "." + minor + ";");
  expect("docs/log_format.md", "this build writes " + hashes + ", `sim::PhaseHashes::kVersion`");
  expect("docs/log_format.md", "\n| " + hashes + " | ");
}

TEST(Documents, RelativeLinksLeadSomewhere) {
  const std::regex link("\\]\\(([^)#: ]+)(#[^)]*)?\\)");
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with(".md")) continue;
    const std::string text = file.text();
    for (std::sregex_iterator it(text.begin(), text.end(), link); it != std::sregex_iterator(); ++it) {
      const fs::path target = (fs::path(TUMBLE_SOURCE_DIR) / file.path).parent_path() / (*it)[1].str();
      EXPECT_TRUE(fs::exists(target)) << file.path << ": dead link to " << (*it)[1];
    }
  }
}

TEST(Documents, EveryDocumentIsReachableFromTheReadme) {
  std::string text;
  for (const char* path : {"README.md", "docs/README.md"}) {
    const SourceFile* list = find(path);
    ASSERT_NE(list, nullptr) << path << " is missing";
    text += list->text();
  }
  ASSERT_NE(find("README.md")->text().find("(docs/README.md)"), std::string::npos);
  for (const SourceFile& file : source_tree()) {
    if (!file.is_under("docs/") || !file.ends_with(".md")) continue;
    const std::string name = fs::path(file.path).filename().string();
    EXPECT_NE(text.find(name), std::string::npos)
        << file.path << " is linked from neither README.md nor docs/README.md";
  }
}

// Written in halves, so that this file does not find itself.
TEST(Documents, NoMachinePathsHostsOrLeftovers) {
  const std::vector<std::string> banned = {
      std::string("/wor") + "k/",       std::string("/ho") + "me/",   std::string("/tm") + "p/",
      std::string("TO") + "DO",         std::string("FIX") + "ME",    std::string("deb.debi") + "an",
      std::string("registry.") + "npm", std::string("pypi.") + "org", std::string("proxy.gol") + "ang",
      std::string("<<<<") + "<<< ",
  };
  for (const SourceFile& file : source_tree()) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string& word : banned) {
        EXPECT_EQ(file.lines[i].find(word), std::string::npos) << file.path << ':' << i + 1 << ": " << word;
      }
    }
  }
}

TEST(Documents, TextHasNoTabsTrailingBlanksOrCarriageReturns) {
  for (const SourceFile& file : source_tree()) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      const bool clean = line.find_first_of("\t\r") == std::string::npos && !line.ends_with(' ');
      EXPECT_TRUE(clean) << file.path << ':' << i + 1;
    }
  }
}

TEST(Documents, ShellScriptsParseAndStopAtTheFirstError) {
  std::size_t seen = 0;
  for (const SourceFile& file : source_tree()) {
    const bool is_script = !file.lines.empty() && file.lines.front().starts_with("#!");
    EXPECT_TRUE(is_script || !file.ends_with(".sh")) << file.path << " has no #! line";
    if (!is_script) continue;
    ++seen;
    const bool is_bash = file.lines.front() == "#!/usr/bin/env bash";
    EXPECT_TRUE(is_bash || file.lines.front() == "#!/bin/sh") << file.path << ": found " << file.lines.front();
    EXPECT_TRUE(file.executable) << file.path << " is not executable";
    const char* strict = is_bash ? "set -euo pipefail" : "set -eu";
    EXPECT_NE(std::ranges::find(file.lines, strict), file.lines.end()) << file.path << " does not say " << strict;
    const std::string command = std::string("bash -n '") + TUMBLE_SOURCE_DIR + "/" + file.path + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << file.path << " does not parse";
  }
  EXPECT_GE(seen, 3U);
}

}  // namespace
}  // namespace tumble::test
