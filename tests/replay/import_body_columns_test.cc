// Columns of a table whose value is read once, or not at all: each cell is read as what it is all the same, so that two
// tables that differ in such a cell never become equal logs.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "replay/import/csv/import_csv.h"
#include "replay/log/byte_memory.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

const std::string kState =
    "position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
    "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z";
const std::string kRest = ",0,0,1,1,0,0,0,0,0,0,0,0,0\n";

/// "no error", or the error.
std::string result_of(const std::string& text) {
  const MemoryFile file = std::make_shared<std::vector<std::byte>>();
  const auto sink = [&]() -> Result<std::unique_ptr<ByteSink>> {
    return std::unique_ptr<ByteSink>(std::make_unique<MemoryByteSink>(file, "t.tumble"));
  };
  const Result<LogSummary> summary = import_csv(text, "t.csv", sink);
  return summary.ok() ? "no error" : summary.error().message;
}

/// A table of one body. cells: of the columns `names`, one text a step.
std::string table(const std::string& names, const std::vector<std::string>& cells, const std::string& header = "") {
  std::string text = header + "# dt: 0.01\nstep,id," + names + "," + kState + "\n";
  for (std::size_t k = 0; k < cells.size(); ++k) text += std::to_string(k) + ",4," + cells[k] + kRest;
  return text;
}

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(ImportBodyColumns, ALaterRowRepeatsTheFirst) {
  const std::vector<std::pair<std::string, std::string>> columns = {
      {"mass", "2"}, {"static", "0"}, {"friction", "0.5"}, {"restitution", "0.25"}, {"row", "3"}, {"column", "2"}};
  for (const auto& [name, value] : columns) {
    EXPECT_EQ(result_of(table(name, {value, value, value})), "no error") << name;
    EXPECT_EQ(result_of(table(name, {value, value + " ", "+" + value})), "no error") << name << ": equal values";
    for (const std::string wrong : {"abc", "", "nan(0x3ff0000000000000)", "1x"}) {
      const std::string error = result_of(table(name, {value, value, wrong}));
      const std::string wanted =
          std::string("t.csv:5:5: ").append(name).append(": found \"").append(wrong) + "\", wanted ";
      EXPECT_TRUE(says(error, wanted)) << error;
    }
    for (const std::string wrong : {"nan", "-5", "1", "inf"}) {
      const std::string error = result_of(table(name, {value, wrong, value}));
      EXPECT_TRUE(says(error, "t.csv:4:5: " + name + ": found ")) << error;
    }
  }
  const std::string error = result_of(table("mass", {"2", "2.0", "7"}));
  EXPECT_EQ(error,
            "t.csv:5:5: mass: found 7, wanted 2 as in line 3: a body keeps the value that it first appears with");
  for (const char* header : {"", "# precision: float32\n"}) {
    const std::string sizes = "size.x,size.y,size.z";
    EXPECT_EQ(result_of(table(sizes, {"1,2,0.1", "1.0,2e0,0.10"}, header)), "no error");
    EXPECT_TRUE(says(result_of(table(sizes, {"1,2,0.1", "1,nan,0.1"}, header)), "size.y: found nan, wanted 2 as in"));
    EXPECT_TRUE(says(result_of(table(sizes, {"1,2,0.1", "1,2,0.2"}, header)), "size.z: found 0.2, wanted 0.1 as in"));
  }
}

/// A table of one body with a column time. cells: "step,time" of each row.
std::string timed(const std::vector<std::string>& cells, const std::string& header) {
  std::string text = header + "step,time,id," + kState + "\n";
  for (const std::string& cell : cells) text.append(cell).append(",4").append(kRest);
  return text;
}

TEST(ImportBodyColumns, ATimeThatContradictsDtIsAnError) {
  const std::string dt = "# dt: 0.01\n";
  const std::vector<std::vector<std::string>> wrong = {
      {"0,0", "1,0.5", "2,1"},     {"0,0", "1,1", "2,2"},           {"0,0.02", "1,0.01", "2,0"},
      {"0,0", "1,0.01", "2,0.03"}, {"0,0", "1,nan", "2,0.02"},      {"0,nan"},
      {"0,0", "1,0.01", "2,0.01"}, {"0,0", "1,0.0101", "2,0.0202"}, {"0,0", "1,abc"},
      {"0,0.0", "1,0.1", "2,0.2"}, {"0,5", "2,5.01", "4,5.02"},     {"0,0.00", "1,0.02", "2,0.04", "3,0.06"}};
  for (const std::vector<std::string>& cells : wrong) {
    const std::string error = result_of(timed(cells, dt));
    EXPECT_TRUE(says(error, ": time: found ")) << cells.back() << ": " << error;
  }
  EXPECT_EQ(
      result_of(timed({"0,0", "1,0.5"}, dt)),
      "t.csv:4:3: time: found 0.5 after 0, wanted 0.01, because dt is 0.01 s; mend one of them, or give no dt: the "
      "differences of time are the dt then");
  const std::vector<std::vector<std::string>> right = {
      {"0,0", "1,0.01", "2,0.02", "3,0.03"},
      {"0,5", "1,5.01", "2,5.02"},
      {"0,5", "10,5.1", "20,5.2"},
      {"0,0.0", "1,0.0", "2,0.0", "3,0.0", "4,0.0", "5,0.1", "6,0.1"},
      {"0,99.99", "1,100", "2,100.01"},
      {"0,1e-2", "1,2e-2", "2,3.0000000000000001e-2"},
      {"0,0.0099999997764825821", "1,0.019999999552965164", "2,0.029999999329447746"}};
  for (const std::vector<std::string>& cells : right) {
    EXPECT_EQ(result_of(timed(cells, dt)), "no error") << cells.back();
  }
  std::vector<std::string> floats, rounded, six;  // as an engine adds them up, and as printf cuts them
  float time = 0;
  for (int k = 0; k < 20000; ++k, time += 0.01F) {
    const std::string step = std::to_string(k) + ",";
    floats.push_back(step + significant(static_cast<double>(time), 9));
    rounded.push_back(step + fixed(k * 0.01, 1));
    six.push_back(step + significant(k * 0.01, 6));
  }
  for (const auto* cells : {&floats, &rounded, &six}) EXPECT_EQ(result_of(timed(*cells, dt)), "no error");
  EXPECT_TRUE(says(result_of("# dt: 0.01\ntime,id," + kState + "\n0,4" + kRest + "0.5,4" + kRest),
                   "t.csv:4:1: time: found 0.5 after 0, wanted 0.01"));
}

TEST(ImportBodyColumns, AStepHasOneTime) {
  std::string text = "step,time,id," + kState + "\n0,0.5,4" + kRest + "0,0.6,5" + kRest;
  EXPECT_EQ(result_of(text), "t.csv:3:3: time: found 0.6, wanted 0.5 as in line 2, where this step begins");
}

TEST(ImportBodyColumns, AKeyBelowTheNamesIsAnError) {
  const std::string good = table("mass", {"1", "1"});
  const std::size_t behind_names = good.find("\n0,") + 1;
  for (const std::string key : {"up: y", "dt: 5", "camera.fov: 9", "mass: 3", "length:cm"}) {
    for (const std::size_t at : {behind_names, good.find("\n1,") + 1, good.size()}) {
      const std::string error = result_of(std::string(good).insert(at, "# " + key + "\n"));
      EXPECT_TRUE(says(error, ":1: found the key \"" + key.substr(0, key.find(':')) + "\" below the names of the col"))
          << error;
    }
  }
  for (const char* remark : {"# frame 3: slow\n", "# up\n", "#\n", "# the dt: see above\n"}) {
    EXPECT_EQ(result_of(std::string(good).insert(behind_names, remark)), "no error") << remark;
  }
}

TEST(ImportBodyColumns, ANumberInBracketsHasTheBitsOfItsWord) {
  const std::string before = "# dt: 0.1\nstep,id," + kState + "\n0,4";
  for (const char* wrong : {"nan(0x3ff0000000000000)", "nan(0x7ff0000000000000)", "inf(0x7ff8000000000000)", "nan(x)",
                            "nan()", "nan(0x7ff8)", "-nan(0x7ff8000000000000)", "nan(snan)"}) {
    EXPECT_FALSE(parse_exact(wrong)) << wrong;
    const std::string rest = std::string(",") + wrong + kRest.substr(2);
    const std::string error = result_of(before + rest);
    EXPECT_TRUE(says(error, "t.csv:3:5: position.x: found \"" + std::string(wrong))) << error;
  }
  EXPECT_TRUE(parse_exact("-nan(ind)")) << "as Windows prints the NaN of 0 / 0";
}

}  // namespace
}  // namespace tumble::replay
