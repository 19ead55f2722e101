// Boxes, generators and their ids: one scene for each kind of error, with the message a person gets.
#include "tests/support/bad_scene.h"

namespace tumble::test {
namespace {

class BoxErrors : public testing::TestWithParam<BadScene> {};

TEST_P(BoxErrors, SayWhereWhatAndWhatElse) { expect_its_message(GetParam()); }

const BadScene kBad[] = {
    {"SizeNegative", "[[box]]\nid=1\nsize = [1.0, -2.0, 1.0]\n",
     "bad.toml:3:8: [[box]] key \"size\": found [1.0, -2.0, 1.0], wanted three edge lengths from 0.0001 to 4096 m"},
    {"SizeZero", "[[box]]\nsize = [1, 0, 1]\n",
     "bad.toml:2:8: [[box]] key \"size\": found [1, 0, 1], wanted three edge lengths from 0.0001 to 4096 m"},
    {"SizeOfTwo", "[[box]]\nsize = [1, 2]\n",
     "bad.toml:2:8: [[box]] key \"size\": found [1, 2], wanted three edge lengths from 0.0001 to 4096 m"},
    {"SizeIsNumber", "[[box]]\nsize = 1\n",
     "bad.toml:2:8: [[box]] key \"size\": found 1, wanted three edge lengths from 0.0001 to 4096 m"},
    {"SizeOfTexts", "[[box]]\nsize = [\"1\", \"1\", \"1\"]\n",
     "bad.toml:2:8: [[box]] key \"size\": found [\"1\", \"1\", \"1\"], wanted three edge lengths from 0.0001 to 4096 "
     "m"},
    {"SizeNested", "[[box]]\nsize = [[1], 1, 1]\n",
     "bad.toml:2:8: [[box]] key \"size\": found [[…], 1, 1], wanted three edge lengths from 0.0001 to 4096 m"},
    {"MassZero", "[[box]]\nmass = 0\n",
     "bad.toml:2:8: [[box]] key \"mass\": found 0, wanted a mass from 1e-09 to 1e+12 kg"},
    {"MassNegative", "[[box]]\nmass = -1.5\n",
     "bad.toml:2:8: [[box]] key \"mass\": found -1.5, wanted a mass from 1e-09 to 1e+12 kg"},
    {"MassNotANumber", "[[box]]\nmass = nan\n",
     "bad.toml:2:8: [[box]] key \"mass\": found nan, wanted a mass from 1e-09 to 1e+12 kg"},
    {"MassInfinite", "[[box]]\nmass = inf\n",
     "bad.toml:2:8: [[box]] key \"mass\": found inf, wanted a mass from 1e-09 to 1e+12 kg"},
    {"MassIsText", "[[box]]\nmass = \"heavy\"\n",
     "bad.toml:2:8: [[box]] key \"mass\": found \"heavy\", wanted a mass from 1e-09 to 1e+12 kg"},
    {"MassIsDate", "[[box]]\nmass = 2007-08-01\n",
     "bad.toml:2:8: [[box]] key \"mass\": found a date or time, wanted a mass from 1e-09 to 1e+12 kg"},
    {"MassAndDensity", "[[box]]\nmass = 1\ndensity = 2\n",
     "bad.toml:3:11: [[box]] key \"density\": found 2, wanted either mass or density; remove one"},
    {"DensityZero", "[[box]]\ndensity = 0\n",
     "bad.toml:2:11: [[box]] key \"density\": found 0, wanted a density from 1e-06 to 1e+09 kg/m³"},
    {"DensityTooHeavy", "[[box]]\nsize = [4000, 4000, 4000]\ndensity = 1000\n",
     "bad.toml:3:11: [[box]] key \"density\": found 1000, wanted a mass from 1e-09 to 1e+12 kg (density times volume "
     "gives 6.4e+13 kg)"},
    {"PositionNotANumber", "[[box]]\nposition = [0, nan, 0]\n",
     "bad.toml:2:12: [[box]] key \"position\": found [0, nan, 0], wanted three coordinates from -32768 to 32768 m"},
    {"PositionFar", "[[box]]\nposition = [0, 0, 40000]\n",
     "bad.toml:2:12: [[box]] key \"position\": found [0, 0, 40000], wanted three coordinates from -32768 to 32768 m"},
    {"VelocityTooFast", "[[box]]\nvelocity = [9000, 0, 0]\n",
     "bad.toml:2:12: [[box]] key \"velocity\": found [9000, 0, 0], wanted three components from -8192 to 8192 m/s"},
    {"SpinTooFast", "[[box]]\nspin = [0, -1e9, 0]\n",
     "bad.toml:2:8: [[box]] key \"spin\": found [0, -1e+09, 0], wanted three components from -8192 to 8192 rad/s"},
    {"OrientationZero", "[[box]]\norientation = [0, 0, 0, 0]\n",
     "bad.toml:2:15: [[box]] key \"orientation\": found [0, 0, 0, 0], wanted a quaternion w, x, y, z that is not zero"},
    {"OrientationOfThree", "[[box]]\norientation = [1, 0, 0]\n",
     "bad.toml:2:15: [[box]] key \"orientation\": found [1, 0, 0], wanted four components w, x, y, z from -1000000 to "
     "1000000"},
    {"OrientationAndAxis", "[[box]]\norientation = [1, 0, 0, 0]\naxis = [1, 0, 0]\ndegrees = 4\n",
     "bad.toml:2:15: [[box]] key \"orientation\": found [1, 0, 0, 0], wanted either orientation or axis with degrees; "
     "remove one"},
    {"AxisWithoutDegrees", "[[box]]\naxis = [1, 0, 0]\n",
     "bad.toml:1:1: [[box]] key \"degrees\": found none, wanted both axis and degrees"},
    {"DegreesWithoutAxis", "[[box]]\ndegrees = 30\n",
     "bad.toml:1:1: [[box]] key \"axis\": found none, wanted both axis and degrees"},
    {"AxisZero", "[[box]]\naxis = [0, 0, 0]\ndegrees = 30\n",
     "bad.toml:2:8: [[box]] key \"axis\": found [0, 0, 0], wanted a direction, not all zero"},
    {"DegreesInfinite", "[[box]]\naxis = [0, 0, 1]\ndegrees = inf\n",
     "bad.toml:3:11: [[box]] key \"degrees\": found inf, wanted an angle from -36000 to 36000 degrees"},
    {"StaticMoves", "[[box]]\nstatic = true\nvelocity = [1, 0, 0]\n",
     "bad.toml:3:12: [[box]] key \"velocity\": found [1, 0, 0], wanted zero or nothing: a static box does not move"},
    {"StaticSpins", "[[box]]\nstatic = true\nspin = [1, 0, 0]\n",
     "bad.toml:3:8: [[box]] key \"spin\": found [1, 0, 0], wanted zero or nothing: a static box does not move"},
    {"FrozenMoves", "[[box]]\nfrozen = true\nvelocity = [1, 0, 0]\n",
     "bad.toml:3:12: [[box]] key \"velocity\": found [1, 0, 0], wanted zero or nothing: a frozen box starts at rest"},
    {"StaticFrozen", "[[box]]\nfrozen = true\nstatic = true\n",
     "bad.toml:2:10: [[box]] key \"frozen\": found true, wanted false or nothing: a static box does not move anyway"},
    {"FrozenIsNumber", "[[box]]\nfrozen = 1\n", "bad.toml:2:10: [[box]] key \"frozen\": found 1, wanted true or false"},
    {"MaterialIsText", "[[box]]\nmaterial = \"wood\"\n",
     "bad.toml:2:12: [[box]] key \"material\": found \"wood\", wanted a table in braces"},
    {"FrictionNegative", "[[box]]\n[material]\nfriction = -0.1\n",
     "bad.toml:3:12: [material] key \"friction\": found -0.1, wanted a coefficient from 0 to 100"},
    {"FrictionOfABox", "[[box]]\nmaterial = { friction_dynamic = nan }\n",
     "bad.toml:2:33: [[box]] key \"material.friction_dynamic\": found nan, wanted a coefficient from 0 to 100"},
    {"RestitutionAboveOne", "[[box]]\n[material]\nrestitution = 1.5\n",
     "bad.toml:3:15: [material] key \"restitution\": found 1.5, wanted a coefficient from 0 to 1"},
    {"IdZero", "[[box]]\nid = 0\n",
     "bad.toml:2:6: [[box]] key \"id\": found 0, wanted a whole number from 1 to 9007199254740991"},
    {"IdNegative", "[[box]]\nid = -4\n",
     "bad.toml:2:6: [[box]] key \"id\": found -4, wanted a whole number from 1 to 9007199254740991"},
    {"IdTooLarge", "[[box]]\nid = 9007199254740992\n",
     "bad.toml:2:6: [[box]] key \"id\": found 9007199254740992, wanted a whole number from 1 to 9007199254740991"},
    {"IdFractional", "[[box]]\nid = 1.0\n",
     "bad.toml:2:6: [[box]] key \"id\": found 1.0, wanted a whole number from 1 to 9007199254740991"},
    {"IdTwice", "[[box]]\nid = 7\n[[box]]\nid = 7\n",
     "bad.toml:4:6: [[box]] key \"id\": found id 7, wanted ids that no other body has (taken by [[box]] key \"id\" at "
     "bad.toml:2:6)"},
    {"IdInAGeneratorsRange", "[[box]]\nid = 12\n[[tower]]\ncount = 10\nfirst_id = 10\n",
     "bad.toml:5:12: [[tower]] key \"first_id\": found id 12, wanted ids that no other body has (taken by [[box]] key "
     "\"id\" at bad.toml:2:6)"},
    {"RangesOverlap", "[[tower]]\ncount = 10\nfirst_id = 10\n[[grid]]\nrows = 2\ncols = 2\nfirst_id = 7\n",
     "bad.toml:3:12: [[tower]] key \"first_id\": found id 10, wanted ids that no other body has (taken by [[grid]] key "
     "\"first_id\" at bad.toml:7:12)"},
    {"RangeLeavesTheIds", "[[tower]]\ncount = 10\nfirst_id = 9007199254740990\n",
     "bad.toml:3:12: [[tower]] key \"first_id\": found 9007199254740990 for 10 bodies, wanted ids up to "
     "9007199254740991"},
    {"IdOfAThrowTaken", "[[box]]\nid = 7\n[[input]]\nstep = 1\nkind = \"throw\"\nid = 7\n",
     "bad.toml:6:6: [[input]] key \"id\": found id 7, wanted ids that no other body has (taken by [[box]] key \"id\" "
     "at bad.toml:2:6)"},
    {"RowsZero", "[[grid]]\nrows = 0\n",
     "bad.toml:2:8: [[grid]] key \"rows\": found 0, wanted a whole number from 1 to 4000000"},
    {"RowsAbsurd", "[[grid]]\nrows = 5000000\n",
     "bad.toml:2:8: [[grid]] key \"rows\": found 5000000, wanted a whole number from 1 to 4000000"},
    {"GridTooLarge", "[[grid]]\nrows = 4000\ncols = 4000\n",
     "bad.toml:2:8: [[grid]] key \"rows\": found 4000, wanted counts that make at most 4000000 bodies"},
    {"PileTooLarge", "[[pile]]\ncount = [2000, 2000, 2000]\n",
     "bad.toml:2:9: [[pile]] key \"count\": found [2000, 2000, 2000], wanted counts that make at most 4000000 bodies"},
    {"PileCountOfTwo", "[[pile]]\ncount = [8, 8]\n",
     "bad.toml:2:9: [[pile]] key \"count\": found [8, 8], wanted three whole numbers from 1 to 4000000"},
    {"ManyTablesTooLarge", "[[tower]]\ncount = 3000000\n[[tower]]\ncount = 3000000\n",
     "bad.toml:3:1: [[tower]]: found more than 4000000 bodies, wanted fewer of them up to here"},
    {"TiltBackwards", "[[grid]]\ntilt = -45\n",
     "bad.toml:2:8: [[grid]] key \"tilt\": found -45, wanted an angle from 0 to 90 degrees"},
    {"PitchNegative", "[[pile]]\npitch = -1\n",
     "bad.toml:2:9: [[pile]] key \"pitch\": found -1, wanted a distance from 0 to 32768 m"},
    {"TaperZero", "[[tower]]\ntaper = 0\n",
     "bad.toml:2:9: [[tower]] key \"taper\": found 0, wanted a ratio from 0.01 to 100"},
    {"TaperToNothing", "[[tower]]\ncount = 400\ntaper = 0.9\n",
     "bad.toml:1:1: [[tower]] row 66, column 0: mass found 8.709974208216542e-10, wanted a mass from 1e-09 to 1e+12 "
     "kg"},
    {"TowerTooHigh", "[[tower]]\ncount = 40000\n",
     "bad.toml:1:1: [[tower]] row 32768, column 0: position found [0, 0, 32768.5], wanted three coordinates from "
     "-32768 to 32768 m"},
    {"JitterIsNumber", "[[tower]]\njitter = 0.1\n",
     "bad.toml:2:10: [[tower]] key \"jitter\": found 0.1, wanted a table in braces"},
    {"JitterNegative", "[[tower]]\njitter = { position = -0.1 }\n",
     "bad.toml:2:23: [[tower]] key \"jitter.position\": found -0.1, wanted a distance from 0 to 32768 m"},
    {"SeedNegative", "[[tower]]\njitter = { seed = -1 }\n",
     "bad.toml:2:19: [[tower]] key \"jitter.seed\": found -1, wanted a whole number from 0 to 9223372036854775807"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, BoxErrors, testing::ValuesIn(kBad), name_of);

}  // namespace
}  // namespace tumble::test
