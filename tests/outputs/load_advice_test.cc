// `record` names a body that lies on a much lighter one where its method does not bear that, and no other pair.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string box(double edge, const std::string& place, const std::string& mass) {
  const std::string size = std::to_string(edge);
  return "[[box]]\nsize = [" + size + ", " + size + ", " + size + "]\nposition = " + place + "\nmass = " + mass + "\n";
}

std::string warnings_of(const std::string& world, const std::string& boxes) {
  const Workshop shop;
  shop.write("w.toml", "[world]\nsteps = 2\n" + world + "\n" + boxes);
  const Outcome outcome = shop.run({"record", "w.toml", "--quiet"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  return outcome.err;
}

// Nothing but other masses helps: neither dt nor substeps, which the warning of a coarse step advises.
TEST(LoadAdvice, AHeavyBoxOnATinyMuchLighterOneIsNamedWhateverDt) {
  const auto warned = [](const std::string& place, const std::string& mass) {
    return warnings_of("dt = 0.001", box(0.001, "[0, 0, 1.0005]", "0.001") + box(1, place, mass));
  };
  const std::string on_it = "[0, 0, 1.501]";
  const std::string text = warned(on_it, "1e6");
  EXPECT_TRUE(
      holds(text, "body 2 is 1e+09 times as heavy as body 1, on which it lies at the start: beyond 1e+07 times"))
      << text;
  EXPECT_EQ(warned(on_it, "1e3"), "");
  EXPECT_EQ(warned(on_it, "1e6\nstatic = true"), "");
  EXPECT_EQ(warned("[0, 0, 1.506]", "1e6"), "") << "5 mm above";
  EXPECT_EQ(warned("[0, 0, 0.5]", "1e6"), "") << "the light one lies on the heavy one";
  EXPECT_EQ(warned("[0.5005, 0, 1.2]", "1e6"), "") << "they stand side by side";
}

// Boxes of a metre bear any mass in method layered; in method thesis they bear what its substeps let them.
TEST(LoadAdvice, AHeavyBoxOnALighterOneIsNamedWhereItsMethodDoesNotBearIt) {
  const auto warned = [](const std::string& light, const std::string& heavy, const std::string& world) {
    return warnings_of(world, box(1, "[0, 0, 0.5]", light) + box(1, "[0, 0, 1.5]", heavy));
  };
  const std::string thesis = "method = \"thesis\"\n";
  EXPECT_EQ(warned("1e-6", "1e6", "method = \"layered\""), "");
  const std::string text = warned("1", "100", thesis);
  for (const char* part : {"body 2 is 100 times as heavy as body 1, on which it lies at the start: beyond 50 times",
                           "pressed flat in method thesis with 8 substeps", "take substeps = 16, method layered, or"}) {
    EXPECT_TRUE(holds(text, part)) << text;
  }
  EXPECT_EQ(warned("1", "100", thesis + "substeps = 16"), "") << "what the warning advises";
  EXPECT_EQ(warned("1", "40", thesis), "");
  EXPECT_EQ(warned("100", "1", thesis), "") << "the light one lies on the heavy one";
  EXPECT_TRUE(holds(warned("1", "1e6", thesis), "take method layered, or bring the masses closer"));
}

}  // namespace
}  // namespace tumble::test
