// Names in lists for people.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "src/base/text.h"

namespace tumble {
namespace {

TEST(NaturalOrder, RunsOfDigitsCountAsNumbers) {
  const std::vector<std::string> wanted = {"",
                                           "a",
                                           "a2",
                                           "a010",
                                           "a10",
                                           "a10b",
                                           "a11",
                                           "ab",
                                           "qpos[2].x",
                                           "qpos[2].y",
                                           "qpos[10].x",
                                           "x1y2",
                                           "x1y10",
                                           "x18446744073709551616",
                                           "x18446744073709551617",
                                           "é"};
  std::vector<std::string> names = wanted;
  std::ranges::reverse(names);
  std::ranges::sort(names, natural_less);
  EXPECT_EQ(names, wanted);
}

TEST(NaturalOrder, IsStrictAndTotal) {
  const std::vector<std::string> names = {"",    "0",  "00",  "1",   "01",   "a",  "a0",
                                          "a00", "a1", "a01", "a1b", "a01b", "aa", "["};
  for (const std::string& a : names) {
    EXPECT_FALSE(natural_less(a, a)) << a;
    for (const std::string& b : names) {
      EXPECT_EQ(natural_less(a, b) != natural_less(b, a), a != b) << a << ' ' << b;
      for (const std::string& c : names) {
        const bool in_row = natural_less(a, b) && natural_less(b, c);
        EXPECT_TRUE(!in_row || natural_less(a, c)) << a << ' ' << b << ' ' << c;
      }
    }
  }
}

TEST(NaturalOrder, GivesThePlacesOfAList) {
  struct Entry {
    std::string name;
  };
  const std::vector<Entry> list = {{"b10"}, {"b9"}, {"a"}};
  EXPECT_EQ(natural_order(list, &Entry::name), (std::vector<std::size_t>{2, 1, 0}));
}

}  // namespace
}  // namespace tumble
