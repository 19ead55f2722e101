// `tumble dump` and `tumble info` as docs/commands.md describes them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

// Every number that dump prints is the one in the log, to the bit.
TEST(Program, DumpedNumbersReadBackToTheSameBits) {
  const Workshop shop;
  shop.record_small("s");
  Result<replay::LogReader> log = replay::LogReader::open(shop.path("s.tumble"));
  ASSERT_TRUE(log.ok());
  const auto record = log->read_step(37);
  ASSERT_TRUE(record.ok());
  const replay::BodyStates& states = (*record)->states;
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };

  const ordered_json json = parsed(shop.run({"dump", "s.tumble", "--step", "37", "--json"}));
  EXPECT_EQ(json["step"], 37);
  ASSERT_EQ(json["bodies"].size(), states.size());
  std::istringstream csv(shop.run({"dump", "s.tumble", "--step", "37", "--csv"}).out);
  std::string line;
  std::getline(csv, line);
  EXPECT_TRUE(line.starts_with("step,id,position.x,")) << line;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::vector<double> wanted = {states.position.x[i],    states.position.y[i],    states.position.z[i],
                                        states.orientation.w[i], states.orientation.x[i], states.orientation.y[i],
                                        states.orientation.z[i], states.velocity.x[i],    states.velocity.y[i],
                                        states.velocity.z[i],    states.spin.x[i],        states.spin.y[i],
                                        states.spin.z[i]};
    std::getline(csv, line);
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    std::getline(cells, cell, ',');
    EXPECT_EQ(cell, std::to_string(states.id[i]));
    std::vector<double> numbers;
    for (const char* key : {"position", "orientation", "velocity", "spin"}) {
      for (const auto& number : json["bodies"][i][key]) numbers.push_back(number.get<double>());
    }
    ASSERT_EQ(numbers.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_EQ(bits(numbers[k]), bits(wanted[k]));
      std::getline(cells, cell, ',');
      EXPECT_EQ(bits(std::stod(cell)), bits(wanted[k])) << cell;
    }
  }
}

TEST(Program, DumpFollowsOneBodyThroughItsSteps) {
  const Workshop shop;
  shop.record_small("s");
  const std::string csv = shop.run({"dump", "s.tumble", "--steps", "3:6", "--body", "3", "--csv"}).out;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << "a header, and steps 5 and 6: thrown in before step 5\n"
                                                         << csv;
  const ordered_json list = parsed(shop.run({"dump", "s.tumble", "--steps", "0:2", "--json"}));
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[2]["step"], 2);
  EXPECT_EQ(list[0]["bodies"].size(), 2U);
}

TEST(Program, InfoTellsWhatALogHolds) {
  const Workshop shop;
  shop.record_small("s", {"--set", "world.substeps=4"});
  const Outcome outcome = shop.run({"info", "s.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  const ordered_json json = parsed(outcome);
  EXPECT_EQ(json["method"], "thesis");
  EXPECT_EQ(json["scene"]["title"], "three boxes");
  EXPECT_EQ(json["set"][0], "world.substeps=4");
  EXPECT_EQ(json["bodies"], 3);
  EXPECT_EQ(json["bodies_at_start"], 2);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_EQ(json["inputs"], ordered_json::parse(R"({"throw":1})"));
  EXPECT_EQ(json["bytes"], shop.read("s.tumble").size());
  EXPECT_EQ(json["moving_body_steps"], 2 * 40 + 36);
  EXPECT_EQ(json["whole"], true);
  EXPECT_EQ(json["final_hash"], parsed(shop.run({"measure", "s.tumble", "--json"}))["final_hash"]);
}

// A table of more rows than are kept is printed as it is read, and looks like a short one.
TEST(Program, ALongDumpIsAlignedFromItsFirstLine) {
  const Workshop shop;
  shop.record_small("s", {"--steps", "9000"});
  const Outcome all = shop.run({"dump", "s.tumble", "--steps", "0:9000"});
  ASSERT_EQ(all.exit, 0) << all.err;
  std::istringstream lines(all.out);
  std::string header, line;
  std::getline(lines, header);
  EXPECT_TRUE(header.starts_with("step  body")) << header;
  const std::size_t end = header.find("qz") + 2;
  std::size_t rows = 0;
  while (std::getline(lines, line) && !line.starts_with("Rounded")) {
    ++rows;
    ASSERT_EQ(line.substr(0, end).find_last_not_of(' ') + 1, end) << line;
    ASSERT_TRUE(line.size() == end || line.substr(end) == "  frozen") << line;
  }
  EXPECT_EQ(rows, 2U * 5 + 3U * 8996) << "the third body comes before step 5";
  EXPECT_TRUE(line.starts_with("Rounded; --csv and --json print every bit.")) << line;
  const std::string last = shop.run({"dump", "s.tumble", "--steps", "8000:9000"}).out;
  const auto rows_of = [](const std::string& text) {  // without blanks, for fewer rows have narrower columns
    std::string behind = text.substr(std::min(text.find("\n8000 "), text.size()));
    std::erase(behind, ' ');
    return behind;
  };
  EXPECT_TRUE(rows_of(all.out) == rows_of(last));
}

TEST(LongTable, KeepsFewRowsAndPrintsMoreAsTheyComeAgain) {
  for (const std::size_t rows : {std::size_t{3}, tools::LongTable::kKeptMax, tools::LongTable::kKeptMax + 1}) {
    const auto row = [&](std::size_t i) {
      return std::vector<std::string>{std::to_string(i), i + 1 == rows ? "widest" : "w", "end"};
    };
    tools::Table kept({">row", "width", "end"});
    tools::LongTable table({">row", "width", "end"});
    testing::internal::CaptureStdout();
    for (std::size_t i = 0; i < rows; ++i) table.add(row(i));
    if (!table.print()) {
      EXPECT_GT(rows, tools::LongTable::kKeptMax);
      for (std::size_t i = 0; i < rows; ++i) table.add(row(i));
    }
    std::cout.flush();
    const std::string printed = testing::internal::GetCapturedStdout();
    for (std::size_t i = 0; i < rows; ++i) kept.add(row(i));
    testing::internal::CaptureStdout();
    kept.print();
    std::cout.flush();
    EXPECT_TRUE(printed == testing::internal::GetCapturedStdout()) << rows << " rows";
  }
}

}  // namespace
}  // namespace tumble::test
