// Names and texts of a table that commas, blanks and line ends would part.
#include <gtest/gtest.h>

#include <utility>

#include "tests/replay/imported_table.h"

namespace tumble::replay {
namespace {

/// A table of one body and two steps with a channel of text.
std::string words(const std::string& settings, const std::string& name, const std::string& word) {
  std::string text = settings + "# dt: 0.01\nstep,id,name," + kPose + kMotion + ",channel." + name + '\n';
  for (const char* step : {"0", "1"}) text += std::string(step) + ",1,a%2cb,0,0,1,1,0,0,0,0,0,0,0,0,0," + word + '\n';
  return text;
}

TEST(Escapes, AreReadWhereTheTableHasThem) {
  const std::string line = "# escapes: percent\n";
  for (const auto& [word, text] : std::vector<std::pair<std::string, std::string>>{
           {"x%2cy", "x,y"}, {"%20x%0a", " x\n"}, {"50%25", "50%"}, {"%", ""}, {"%zz", "%zz"}}) {
    LogReader log = must_import(words(line, "w%2c1 (m%2fs)", word));
    ASSERT_EQ(log.header().declared.channels.size(), 1U);
    EXPECT_EQ(log.header().declared.channels[0].name, "w,1");
    EXPECT_EQ(log.header().declared.channels[0].unit, "m/s");
    EXPECT_EQ(log.bodies().name(1), "a,b");
    const auto& values = (*log.read_step(1))->extras.values(0);
    ASSERT_EQ(values.size(), 1U) << word;
    EXPECT_EQ(std::get<std::string>(values.value(0, ChannelKind::kText)), text);
  }
  LogReader plain = must_import(words("", "w", "x%2cy"));
  EXPECT_EQ(plain.bodies().name(1), "a%2cb");
  EXPECT_EQ(std::get<std::string>((*plain.read_step(1))->extras.values(0).value(0, ChannelKind::kText)), "x%2cy");
}

TEST(Escapes, OfAnotherKindAreErrors) {
  EXPECT_EQ(error_of(words("# escapes: quotes\n", "w", "x")), "t.csv:1:1: escapes: found \"quotes\", wanted percent");
  EXPECT_NE(error_of(words("# escapes: percent\n", "w", "x,y")).find("t.csv:4:1: found 18 cells"), std::string::npos);
  const std::string late = error_of(words("", "w", "x") + "# escapes: percent\n");
  EXPECT_NE(late.find("t.csv:5:1: "), std::string::npos) << late;
}

}  // namespace
}  // namespace tumble::replay
