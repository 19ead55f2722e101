// --set: one scene for each kind of error, with the message a person gets.
#include "tests/support/bad_scene.h"

namespace tumble::test {
namespace {

class OverrideErrors : public testing::TestWithParam<BadScene> {};

TEST_P(OverrideErrors, SayWhereWhatAndWhatElse) { expect_its_message(GetParam()); }

const BadScene kBad[] = {
    {"OverrideWithoutEquals",
     "[[box]]\n",
     "--set world.dt: found no \"=\", wanted key=value, such as world.dt=0.01",
     {"world.dt"}},
    {"OverrideOfAStrangeKey",
     "[[box]]\n",
     "--set world..dt=1: found a strange key, wanted words with dots between, such as grid.2.rows",
     {"world..dt=1"}},
    {"OverrideWithoutValue",
     "[[box]]\n",
     "--set world.dt=: found a value that is not TOML, wanted one such as 7, 0.5, [1, 2, 3] or a word",
     {"world.dt="}},
    {"OverrideNotToml",
     "[[box]]\n",
     "--set world.dt=[1,: found a value that is not TOML, wanted one such as 7, 0.5, [1, 2, 3] or a word",
     {"world.dt=[1,"}},
    {"OverrideUnknownKey",
     "[[box]]\n",
     "--set world.methd=thesis: [world] key \"methd\": found an unknown key, wanted method, dt, steps, seconds, "
     "substeps, split_collisions, gravity, ground, freezing, freeze_energy, freeze_time, slip_speed or air_drag; did "
     "you mean \"method\"?",
     {"world.methd=thesis"}},
    {"OverrideUnknownTable",
     "[[box]]\n",
     "--set wrld.dt=1: key \"wrld\": found an unknown key, wanted name, title, category, material, world, camera, "
     "light, box, grid, tower, pyramid, wall, pile or input; did you mean \"world\"?",
     {"wrld.dt=1"}},
    {"OverrideBadValue",
     "[[grid]]\n[[grid]]\n",
     "--set grid.2.rows=-7: [[grid]] key \"rows\": found -7, wanted a whole number from 1 to 4000000",
     {"grid.2.rows=-7"}},
    {"OverrideBadMaterial",
     "[[box]]\n",
     "--set box.material.friction=-3: [[box]] key \"material.friction\": found -3, wanted a coefficient from 0 to 100",
     {"box.material.friction=-3"}},
    {"OverrideOfAMissingGenerator",
     "[[box]]\n",
     "--set grid.rows=7: found no [[grid]] in the scene, wanted one to set a key in",
     {"grid.rows=7"}},
    {"OverrideOfTheThirdOfTwo",
     "[[grid]]\n[[grid]]\n",
     "--set grid.3.rows=7: found number 3, wanted 1 to 2: the scene has that many [[grid]]",
     {"grid.3.rows=7"}},
    {"OverrideNumberWithoutKey",
     "[[grid]]\n",
     "--set grid.1=7: found a table, wanted a key of [[grid]] after its number",
     {"grid.1=7"}},
    {"OverrideIntoANumber",
     "[[box]]\nmass = 1\n",
     "--set box.mass.x=7: found no table \"mass\", wanted one to set a key in",
     {"box.mass.x=7"}},
    {"OverrideBothOfAPair",
     "[[box]]\n",
     "--set world.steps=7: [world] key \"steps\": found 7, wanted either steps or seconds; remove one",
     {"world.steps=7", "world.seconds=1"}},
    {"OverrideIdTwice",
     "[[box]]\nid = 3\n[[box]]\nid = 4\n",
     "--set box.2.id=3: [[box]] key \"id\": found id 3, wanted ids that no other body has (taken by [[box]] key \"id\" "
     "at bad.toml:2:6)",
     {"box.2.id=3"}},
};

INSTANTIATE_TEST_SUITE_P(Scenes, OverrideErrors, testing::ValuesIn(kBad), name_of);

}  // namespace
}  // namespace tumble::test
