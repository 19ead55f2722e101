// The file as a whole, [world], the view and inputs: one scene for each kind of error, with the message a person gets.
#include "tests/support/bad_scene.h"

namespace tumble::test {
namespace {

class WorldErrors : public testing::TestWithParam<BadScene> {};

TEST_P(WorldErrors, SayWhereWhatAndWhatElse) { expect_its_message(GetParam()); }

const BadScene kBad[] = {
    {"NotToml", "[[box]]\nsize = [1, 2\n",
     "bad.toml:2:14: found text that is not TOML, wanted TOML 1.0: Error while parsing array: encountered end-of-file"},
    {"KeyTwice", "[[box]]\nmass = 1\nmass = 2\n",
     "bad.toml:3:8: found text that is not TOML, wanted TOML 1.0: Error while parsing key-value pair: cannot redefine "
     "existing integer 'mass'"},
    {"InvalidUtf8", "name = \"\xff\"\n[[box]]\n",
     "bad.toml:1:8: found text that is not TOML, wanted TOML 1.0: Encountered invalid utf-8 sequence"},
    {"NoBody", "name = \"x\"\n",
     "bad.toml:1:1: found no body, wanted at least one [[box]], generator or [[input]] that throws a box"},
    {"UnknownTopKey", "nme = \"x\"\n[[box]]\n",
     "bad.toml:1:1: key \"nme\": found an unknown key, wanted name, title, category, material, world, camera, light, "
     "box, grid, tower, pyramid, wall, pile or input; did you mean \"name\"?"},
    {"UnknownTable", "[[box]]\n[worlds]\ndt = 1\n",
     "bad.toml:2:2: key \"worlds\": found an unknown key, wanted name, title, category, material, world, camera, "
     "light, box, grid, tower, pyramid, wall, pile or input; did you mean \"world\"?"},
    {"UnknownBoxKey", "[[box]]\n  sizee = [1, 1, 1]\n",
     "bad.toml:2:3: [[box]] key \"sizee\": found an unknown key, wanted size, mass, density, material, frozen, id, "
     "static, position, axis, degrees, orientation, velocity or spin; did you mean \"size\"?"},
    {"UnknownMaterialKey", "[[box]]\nmaterial = { fricton = 1 }\n",
     "bad.toml:2:14: [[box]] key \"material.fricton\": found an unknown key, wanted friction, friction_dynamic, "
     "restitution or texture; did you mean \"friction\"?"},
    {"UnknownJitterKey", "[[tower]]\njitter = { sed = 1 }\n",
     "bad.toml:2:12: [[tower]] key \"jitter.sed\": found an unknown key, wanted position, degrees or seed; did you "
     "mean \"seed\"?"},
    {"UnknownCameraKey", "[[box]]\n[camera]\nzoom = 1\n",
     "bad.toml:3:1: [camera] key \"zoom\": found an unknown key, wanted position, target, fov, focus or blur"},
    {"KeyOfAnotherInput", "[[box]]\n[[input]]\nstep = 1\nkind = \"wake\"\nid = 1\nimpulse = [1, 0, 0]\n",
     "bad.toml:6:1: [[input]] key \"impulse\": found an unknown key, wanted kind, time, step or id"},
    {"SingleBrackets", "[box]\nmass = 1\n",
     "bad.toml:1:1: key \"box\": found a table, wanted tables that begin with [[box]]"},
    {"DoubleBrackets", "[[box]]\n[[world]]\ndt = 1\n",
     "bad.toml:2:1: key \"world\": found an array of tables, wanted a table that begins with [world]"},
    {"TableIsNumber", "world = 3\n[[box]]\n",
     "bad.toml:1:9: key \"world\": found 3, wanted a table that begins with [world]"},
    {"NameWithSlash", "name = \"a/b\"\n[[box]]\n",
     "bad.toml:1:8: key \"name\": found \"a/b\", wanted a name of letters, digits, \"_\", \"-\" and \".\" that begins "
     "with a letter, a digit or \"_\""},
    {"TitleOfTwoLines", "title = \"a\\nb\"\n[[box]]\n",
     "bad.toml:1:9: key \"title\": found \"a?b\", wanted a text of one line and at most 200 bytes"},
    {"TitleIsNumber", "title = 7\n[[box]]\n",
     "bad.toml:1:9: key \"title\": found 7, wanted a text of one line and at most 200 bytes"},
    {"CategoryMisspelt", "category = \"stackin\"\n[[box]]\n",
     "bad.toml:1:12: key \"category\": found \"stackin\", wanted symmetry, energy, stacking, impact, freezing, "
     "rendering or session; did you mean \"stacking\"?"},
    {"MethodUnknown", "[[box]]\n[world]\nmethod = \"magic\"\n",
     "bad.toml:3:10: [world] key \"method\": found \"magic\", wanted thesis or layered"},
    {"MethodIsNumber", "[[box]]\n[world]\nmethod = 1\n",
     "bad.toml:3:10: [world] key \"method\": found 1, wanted thesis or layered"},
    {"TextureMisspelt", "[[box]]\n[material]\ntexture = \"bricks\"\n",
     "bad.toml:3:11: [material] key \"texture\": found \"bricks\", wanted crate, brick, wood, concrete or white; did "
     "you mean \"brick\"?"},
    {"DtZero", "[[box]]\n[world]\ndt = 0\n",
     "bad.toml:3:6: [world] key \"dt\": found 0, wanted a time from 1e-07 to 1 s"},
    {"DtTooLong", "[[box]]\n[world]\ndt = 2\n",
     "bad.toml:3:6: [world] key \"dt\": found 2, wanted a time from 1e-07 to 1 s"},
    {"StepsAndSeconds", "[[box]]\n[world]\nsteps = 10\nseconds = 1.0\n",
     "bad.toml:3:9: [world] key \"steps\": found 10, wanted either steps or seconds; remove one"},
    {"StepsZero", "[[box]]\n[world]\nsteps = 0\n",
     "bad.toml:3:9: [world] key \"steps\": found 0, wanted a whole number from 1 to 100000000"},
    {"SecondsTooShort", "[[box]]\n[world]\nseconds = 0.001\n",
     "bad.toml:3:11: [world] key \"seconds\": found 0.001, wanted times that make 1 to 100000000 steps (seconds / dt)"},
    {"SecondsTooLong", "[[box]]\n[world]\nseconds = 1e9\ndt = 1e-6\n",
     "bad.toml:3:11: [world] key \"seconds\": found 1e+09, wanted times that make 1 to 100000000 steps (seconds / dt)"},
    {"SubstepsZero", "[[box]]\n[world]\nsubsteps = 0\n",
     "bad.toml:3:12: [world] key \"substeps\": found 0, wanted a whole number from 1 to 1024"},
    {"SubstepsFractional", "[[box]]\n[world]\nsubsteps = 1.5\n",
     "bad.toml:3:12: [world] key \"substeps\": found 1.5, wanted a whole number from 1 to 1024"},
    {"GravityTooStrong", "[[box]]\n[world]\ngravity = [0, 0, -1e5]\n",
     "bad.toml:3:11: [world] key \"gravity\": found [0, 0, -100000.0], wanted three components from -10000 to 10000 "
     "m/s²"},
    {"GroundIsText", "[[box]]\n[world]\nground = \"yes\"\n",
     "bad.toml:3:10: [world] key \"ground\": found \"yes\", wanted true or false"},
    {"FreezeEnergyNegative", "[[box]]\n[world]\nfreeze_energy = -1\n",
     "bad.toml:3:17: [world] key \"freeze_energy\": found -1, wanted an energy from 0 to 1000000 J/kg"},
    {"AirDragNotANumber", "[[box]]\n[world]\nair_drag = nan\n",
     "bad.toml:3:12: [world] key \"air_drag\": found nan, wanted a rate from 0 to 1000 1/s"},
    {"CameraLooksNowhere", "[[box]]\n[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]\n",
     "bad.toml:4:10: [camera] key \"target\": found [1, 2, 3], wanted another point than position, or there is no "
     "direction to look in"},
    {"FovTooWide", "[[box]]\n[camera]\nfov = 180\n",
     "bad.toml:3:7: [camera] key \"fov\": found 180, wanted an angle from 1 to 170 degrees"},
    {"LightIsFar", "[[box]]\n[light]\nposition = [inf, 0, 0]\n",
     "bad.toml:3:12: [light] key \"position\": found [inf, 0, 0], wanted three coordinates from -1000000 to 1000000 m"},
    {"InputWithoutKind", "[[box]]\n[[input]]\nstep = 1\n",
     "bad.toml:2:1: [[input]] key \"kind\": found none, wanted throw, push, remove, wake, set_velocity, set_gravity or "
     "set_dt"},
    {"InputKindMisspelt", "[[box]]\n[[input]]\nstep = 1\nkind = \"pusch\"\nid = 1\n",
     "bad.toml:4:8: [[input]] key \"kind\": found \"pusch\", wanted throw, push, remove, wake, set_velocity, "
     "set_gravity or set_dt; did you mean \"push\"?"},
    {"InputWithoutStep", "[[box]]\n[[input]]\nkind = \"wake\"\nid = 1\n",
     "bad.toml:2:1: [[input]] key \"step\": found none, wanted a step or a time"},
    {"InputStepAndTime", "[[box]]\n[[input]]\nstep = 1\ntime = 0.5\nkind = \"wake\"\nid = 1\n",
     "bad.toml:4:8: [[input]] key \"time\": found 0.5, wanted either step or time; remove one"},
    {"InputAtStepZero", "[[box]]\n[[input]]\nstep = 0\nkind = \"wake\"\nid = 1\n",
     "bad.toml:3:8: [[input]] key \"step\": found 0, wanted a whole number from 1 to 100000000"},
    {"InputAfterTheEnd", "[[box]]\n[[input]]\nstep = 301\nkind = \"wake\"\nid = 1\n",
     "bad.toml:3:8: [[input]] key \"step\": found 301, wanted a step from 1 to the last one, 300"},
    {"InputTimeAfterTheEnd", "[[box]]\n[[input]]\ntime = 5.0\nkind = \"wake\"\nid = 1\n",
     "bad.toml:3:8: [[input]] key \"time\": found 5.0, wanted a time before the end (it means step 301, the last one "
     "is 300)"},
    {"InputTimeNegative", "[[box]]\n[[input]]\ntime = -1\nkind = \"wake\"\nid = 1\n",
     "bad.toml:3:8: [[input]] key \"time\": found -1, wanted a time from 0 to 1e+09 s"},
    {"InputWithoutId", "[[box]]\n[[input]]\nstep = 1\nkind = \"wake\"\n",
     "bad.toml:2:1: [[input]] key \"id\": found none, wanted the id of the body it is meant for"},
    {"PushWithoutImpulse", "[[box]]\n[[input]]\nstep = 1\nkind = \"push\"\nid = 1\n",
     "bad.toml:2:1: [[input]] key \"impulse\": found none, wanted three components in N·s"},
    {"ImpulseNotANumber", "[[box]]\n[[input]]\nstep = 1\nkind = \"push\"\nid = 1\nimpulse = [nan, 0, 0]\n",
     "bad.toml:6:11: [[input]] key \"impulse\": found [nan, 0, 0], wanted three components from -1e+12 to 1e+12 N·s"},
    {"SetVelocityWithoutVelocity", "[[box]]\n[[input]]\nstep = 1\nkind = \"set_velocity\"\nid = 1\n",
     "bad.toml:2:1: [[input]] key \"velocity\": found none, wanted three components in m/s"},
    {"SetGravityWithoutGravity", "[[box]]\n[[input]]\nstep = 1\nkind = \"set_gravity\"\n",
     "bad.toml:2:1: [[input]] key \"gravity\": found none, wanted three components in m/s²"},
    {"SetDtWithoutDt", "[[box]]\n[[input]]\nstep = 1\nkind = \"set_dt\"\n",
     "bad.toml:2:1: [[input]] key \"dt\": found none, wanted the length of the steps from here on, in s"},
    {"SetDtZero", "[[box]]\n[[input]]\nstep = 1\nkind = \"set_dt\"\ndt = 0\n",
     "bad.toml:5:6: [[input]] key \"dt\": found 0, wanted a time from 1e-07 to 1 s"},
    {"InputForNobody", "[[box]]\n[[input]]\nstep = 1\nkind = \"wake\"\nid = 2\n",
     "bad.toml:5:6: [[input]] key \"id\": found 2, wanted the id of a body that exists by then"},
    {"InputBeforeTheThrow",
     "[[box]]\n[[input]]\nstep = 9\nkind = \"throw\"\nid = 5\n[[input]]\nstep = 8\nkind = \"wake\"\nid = 5\n",
     "bad.toml:9:6: [[input]] key \"id\": found 5, wanted the id of a body that exists by then"},
    {"InputAfterTheRemoval",
     "[[box]]\n[[input]]\nstep = 8\nkind = \"remove\"\nid = 1\n[[input]]\nstep = 9\nkind = \"wake\"\nid = 1\n",
     "bad.toml:9:6: [[input]] key \"id\": found 1, wanted a body that exists (removed before step 8)"},
    {"IdOfARemovedBodyReused",
     "[[box]]\nid = 1\n[[input]]\nstep = 8\nkind = \"remove\"\nid = 1\n[[input]]\nstep = 9\nkind = \"throw\"\nid = 1\n",
     "bad.toml:10:6: [[input]] key \"id\": found id 1, wanted ids that no other body has (taken by [[box]] key \"id\" "
     "at bad.toml:2:6)"},
    {"PushOfAStaticBody", "[[box]]\nstatic = true\n[[input]]\nstep = 1\nkind = \"push\"\nid = 1\nimpulse = [1, 0, 0]\n",
     "bad.toml:6:6: [[input]] key \"id\": found 1, wanted a body that can move; this one is static"},
    {"ThrownBoxIsBad", "[[box]]\n[[input]]\nstep = 1\nkind = \"throw\"\nsize = [1, 1, 0]\n",
     "bad.toml:5:8: [[input]] key \"size\": found [1, 1, 0], wanted three edge lengths from 0.0001 to 4096 m"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, WorldErrors, testing::ValuesIn(kBad), name_of);

}  // namespace
}  // namespace tumble::test
