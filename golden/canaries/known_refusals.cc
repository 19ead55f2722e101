#include <array>
#include <string>

#include "golden/canaries/known_answers.h"
#include "tumble/replay/session.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

struct Slip {
  const char* name;
  const char* scene;    // null: a line of many dots
  const char* message;  // begins so; what a library says of TOML may follow
};

std::string many_dots() {
  std::string line = "[a.";
  for (int k = 0; k < 256; ++k) line += "b.";
  return line + "c]\n";
}

constexpr std::array kSlips = {
    Slip{"a key that there is not is named", "[world]\nstepps = 2\n[[box]]\n",
         "slip.toml:2:1: [world] key \"stepps\": found an unknown key, wanted method, dt, steps, seconds, substeps, "
         "split_collisions, gravity, ground, freezing, freeze_energy, freeze_time, slip_speed or air_drag; did you "
         "mean \"steps\"?"},
    Slip{"a number out of range is named", "[[box]]\nmass = -1\n",
         "slip.toml:2:8: [[box]] key \"mass\": found -1, wanted a mass from 1e-09 to 1e+12 kg"},
    Slip{"a text in the place of a number is named", "[[box]]\nmass = \"heavy\"\n",
         "slip.toml:2:8: [[box]] key \"mass\": found \"heavy\", wanted a mass from 1e-09 to 1e+12 kg"},
    Slip{"a size of two numbers is named", "[[box]]\nsize = [1, 2]\n",
         "slip.toml:2:8: [[box]] key \"size\": found [1, 2], wanted three edge lengths from 0.0001 to 4096 m"},
    Slip{"a word that is nearly right is named", "[world]\nmethod = \"layerd\"\n[[box]]\n",
         "slip.toml:2:10: [world] key \"method\": found \"layerd\", wanted thesis or layered; did you mean "
         "\"layered\"?"},
    Slip{"text that is no TOML is named", "[[box]\n", "slip.toml:1:7: found text that is not TOML, wanted TOML 1.0"},
    Slip{"a line of dots is named", nullptr, "slip.toml:1:1: found a line of more than 256 dots, wanted fewer of them"},
    Slip{"a character that turns the writing is not shown", "[[box]]\n\"a\\u202eb\" = 1\n",
         "slip.toml:2:1: [[box]] key \"a?b\": found an unknown key, wanted size, mass, density, material, frozen, "
         "id, static, position, axis, degrees, orientation, velocity or spin"},
    Slip{"a scene without a body is named", "[world]\nsteps = 2\n",
         "slip.toml:1:1: found no body, wanted at least one [[box]], generator or [[input]] that throws a box"},
    Slip{"a camera at its target is named", "[[box]]\n[camera]\nposition = [0, 0, 2]\ntarget = [0, 0, 2]\n",
         "slip.toml:4:10: [camera] key \"target\": found [0, 0, 2], wanted another point than position, or there is "
         "no direction to look in"},
    Slip{"a generated body too far away is named", "[[wall]]\nposition = [30000, 500, 2]\ncourses = 2\nbricks = 4000\n",
         "slip.toml:1:1: [[wall]] row 0, column 3371: position found [32769.93, 500, 2.5], wanted three coordinates "
         "from -32768 to 32768 m"},
    Slip{"too many bodies are named", "[[pyramid]]\nbase = 4000000\n",
         "slip.toml:2:8: [[pyramid]] key \"base\": found 4000000, wanted counts that make at most 4000000 bodies"},
    Slip{"an id given twice is named", "[[box]]\nid = 3\n[[box]]\nid = 3\n",
         "slip.toml:4:6: [[box]] key \"id\": found id 3, wanted ids that no other body has (taken by [[box]] key "
         "\"id\" at slip.toml:2:6)"},
    Slip{"an input after the last step is named",
         "[world]\nsteps = 5\n[[box]]\n[[input]]\nkind = \"wake\"\nstep = 6\nid = 1\n",
         "slip.toml:6:8: [[input]] key \"step\": found 6, wanted a step from 1 to the last one, 5"},
    Slip{"an input after the last second is named",
         "[world]\nsteps = 5\ndt = 0.1\n[[box]]\n[[input]]\nkind = \"wake\"\ntime = 0.5\nid = 1\n",
         "slip.toml:7:8: [[input]] key \"time\": found 0.5, wanted a time before the end (it means step 6, the last "
         "one is 5)"},
    Slip{"an input for a body that is gone is named",
         "[[box]]\n[[box]]\nposition = [3, 0, 1]\n[[input]]\nkind = \"remove\"\nstep = 1\nid = 1\n[[input]]\nkind = "
         "\"wake\"\nstep = 2\nid = 1\n",
         "slip.toml:11:6: [[input]] key \"id\": found 1, wanted a body that exists (removed before step 1)"},
    Slip{"steps and seconds are refused together", "[world]\nsteps = 2\nseconds = 1\n[[box]]\n",
         "slip.toml:2:9: [world] key \"steps\": found 2, wanted either steps or seconds; remove one"},
    Slip{"a name of other characters is named", "name = \"a b\"\n[[box]]\n",
         "slip.toml:1:8: key \"name\": found \"a b\", wanted a name of letters, digits, \"_\", \"-\" and \".\" that "
         "begins with a letter, a digit or \"_\""},
    Slip{"mass and density are refused together", "[[box]]\nmass = 1\ndensity = 2\n",
         "slip.toml:3:11: [[box]] key \"density\": found 2, wanted either mass or density; remove one"},
    Slip{"an axis without degrees is named", "[[box]]\naxis = [1, 0, 0]\n",
         "slip.toml:1:1: [[box]] key \"degrees\": found none, wanted both axis and degrees"},
    Slip{"degrees without an axis are named", "[[box]]\ndegrees = 4\n",
         "slip.toml:1:1: [[box]] key \"axis\": found none, wanted both axis and degrees"},
    Slip{"two orientations are refused", "[[box]]\norientation = [1, 0, 0, 0]\naxis = [1, 0, 0]\ndegrees = 1\n",
         "slip.toml:2:15: [[box]] key \"orientation\": found [1, 0, 0, 0], wanted either orientation or axis with "
         "degrees; remove one"},
    Slip{"a static body that moves is refused", "[[box]]\nstatic = true\nvelocity = [1, 0, 0]\n",
         "slip.toml:3:12: [[box]] key \"velocity\": found [1, 0, 0], wanted zero or nothing: a static box does not "
         "move"},
    Slip{"a frozen body that turns is refused", "[[box]]\nfrozen = true\nspin = [1, 0, 0]\n",
         "slip.toml:3:8: [[box]] key \"spin\": found [1, 0, 0], wanted zero or nothing: a frozen box starts at rest"},
    Slip{"a static body that is frozen is refused", "[[box]]\nstatic = true\nfrozen = true\n",
         "slip.toml:3:10: [[box]] key \"frozen\": found true, wanted false or nothing: a static box does not move "
         "anyway"},
    Slip{"a flag that is none is named", "[[box]]\nfrozen = 1\n",
         "slip.toml:2:10: [[box]] key \"frozen\": found 1, wanted true or false"},
    Slip{"a title of two lines is refused", "title = \"a\\nb\"\n[[box]]\n",
         "slip.toml:1:9: key \"title\": found \"a?b\", wanted a text of one line and at most 200 bytes"},
    Slip{"a key in the place of a table is named", "world = 1\n[[box]]\n",
         "slip.toml:1:9: key \"world\": found 1, wanted a table that begins with [world]"},
    Slip{"a table in the place of tables is named", "[box]\n",
         "slip.toml:1:1: key \"box\": found a table, wanted tables that begin with [[box]]"},
    Slip{"a material that is no table is named", "[[box]]\nmaterial = 1\n",
         "slip.toml:2:12: [[box]] key \"material\": found 1, wanted a table in braces"},
    Slip{"a date in the place of a number is named", "[[box]]\nmass = 2026-11-25\n",
         "slip.toml:2:8: [[box]] key \"mass\": found a date or time, wanted a mass from 1e-09 to 1e+12 kg"},
    Slip{"long lists are cut short", "[[box]]\nsize = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]\n",
         "slip.toml:2:8: [[box]] key \"size\": found [1, 2, 3, 4, 5, 6, 7, 8, … 10 values], wanted three edge "
         "lengths from 0.0001 to 4096 m"},
    Slip{"an input without a kind is named", "[[box]]\n[[input]]\nstep = 1\n",
         "slip.toml:2:1: [[input]] key \"kind\": found none, wanted throw, push, remove, wake, set_velocity, "
         "set_gravity or set_dt"},
    Slip{"an input without a time is named", "[[box]]\n[[input]]\nkind = \"wake\"\nid = 1\n",
         "slip.toml:2:1: [[input]] key \"step\": found none, wanted a step or a time"},
    Slip{"an input of two times is refused", "[[box]]\n[[input]]\nkind = \"wake\"\nid = 1\nstep = 1\ntime = 0\n",
         "slip.toml:6:8: [[input]] key \"time\": found 0, wanted either step or time; remove one"},
    Slip{"an input without its body is named", "[[box]]\n[[input]]\nkind = \"remove\"\nstep = 1\n",
         "slip.toml:2:1: [[input]] key \"id\": found none, wanted the id of the body it is meant for"},
    Slip{"an input for a body that never was is named", "[[box]]\n[[input]]\nkind = \"remove\"\nstep = 1\nid = 7\n",
         "slip.toml:5:6: [[input]] key \"id\": found 7, wanted the id of a body that exists by then"},
    Slip{"an input for a static body is named",
         "[[box]]\nstatic = true\n[[input]]\nkind = \"wake\"\nstep = 1\nid = 1\n",
         "slip.toml:6:6: [[input]] key \"id\": found 1, wanted a body that can move; this one is static"},
    Slip{"ids beyond all are refused", "[[tower]]\nfirst_id = 9007199254740991\ncount = 2\n",
         "slip.toml:2:12: [[tower]] key \"first_id\": found 9007199254740991 for 2 bodies, wanted ids up to "
         "9007199254740991"},
    Slip{"many bodies together are refused",
         "[[pile]]\ncount = [100, 100, 300]\npitch = 0.1\n[[pile]]\ncount = [100, 100, 300]\n",
         "slip.toml:4:1: [[pile]]: found more than 4000000 bodies, wanted fewer of them up to here"},
    Slip{"a body that leaves the world ends the session",
         "[world]\nsteps = 9\n[[box]]\nposition = [32767.5, 0, 5]\nvelocity = [100, 0, 0]\n",
         "step 1, phase finish_motion: body 1: found position (32769.1667, 0, 4.9986375) m, wanted finite and within "
         "±32768 m; it left the world: start nearer to the origin, stop it, or remove it before"},
    Slip{"a body that becomes too fast between others ends the session",
         "[world]\nsteps = 2\nmethod = \"layered\"\nsubsteps = 1\ndt = 0.01\n[material]\nfriction = 0\nrestitution = "
         "1\n[[box]]\nmass = 7.6e-9\nsize = [0.00024, 0.00012, 0.00012]\nposition = [0, 0, 1.69]\norientation = [0.01, "
         "0.27, 0.23, 0.58]\n[[box]]\nmass = 8e7\nsize = [1, 1.63, 1]\nposition = [0.5093, 0.3838, 1.18]\nvelocity = "
         "[4.6, 9.8, 5.8]\nspin = [-3853, 3080, 7304]\n",
         "step 1, phase finish_motion: body 1: found spin ("},
    Slip{"a body that another turns beyond the grids ends the session",
         "[world]\nsteps = 2\nmethod = \"layered\"\nsubsteps = 2\ndt = 0.01\n[material]\nfriction = 0\nrestitution = "
         "1\n[[box]]\nmass = 7.6e-9\nsize = [0.0004, 0.00012, 0.00012]\nposition = [0, 0, 1.69]\norientation = [0.01, "
         "0.27, 0.23, 0.58]\n[[box]]\nmass = 8e7\nsize = [1, 1.63, 1]\nposition = [0.489, 0.438, 1.18]\nvelocity = "
         "[4.6, 9.8, 5.8]\nspin = [6787, 5122, 2782]\n",
         "step 1, phase integrate_positions: body 1 (7.6e-09 kg) on body 2 (8e+07 kg): found spin ("},
    Slip{"a body that the ground turns beyond the grids ends the session",
         "[world]\nsteps = 2\nmethod = \"layered\"\nsubsteps = 1\ndt = 0.01\n[material]\nfriction = 5\n[[box]]\nmass = "
         "1e-3\nsize = [0.01, 0.0001, 0.0001]\nposition = [0, 0, 0.002]\norientation = [1, 0.1, 0.2, "
         "0.3]\nvelocity = [0, 0, -8000]\n",
         "step 1, phase integrate_positions: body 1 (0.001 kg) on the ground: found spin ("},
    Slip{"a body that four others hit at one time ends the session",
         "[world]\nmethod = \"thesis\"\nsteps = 1\ndt = 1e-7\nground = false\ngravity = [0, 0, 0]\n[material]\n"
         "restitution = 0\n[[box]]\nposition = [0, 0, 0]\n[[box]]\nmass = 1e7\nposition = [0.999, 0, 0]\nvelocity = "
         "[-7000, 0, 0]\n[[box]]\nmass = 1e7\nposition = [-0.999, 0, 0]\nvelocity = [7000, 0, 0]\n[[box]]\nmass = "
         "1e7\nposition = [0, 0.999, 0]\nvelocity = [0, -7000, 0]\n[[box]]\nmass = 1e7\nposition = [0, -0.999, "
         "0]\nvelocity = [0, 7000, 0]\n",
         "step 1, phase compute_impulses: body 1: found gains of 27999.9972 m/s or rad/s together in one substep, "
         "wanted at most 24576, where their sum is exact; use smaller speeds, a smaller dt or less extreme masses"},
    Slip{"a body that slides out of the world ends the session",
         "[world]\nsteps = 9\nmethod = \"layered\"\n[material]\nfriction = 0\n[[box]]\nposition = [32767.5, 0, "
         "0.5]\nvelocity = [100, 0, 0]\n",
         "step 1, phase integrate_positions: body 1 (1 kg) on the ground: found position (32768."},
    Slip{"a body that becomes too fast ends the session",
         "[world]\nsteps = 2\ndt = 0.5\nground = false\ngravity = [0, 0, -9000]\n[[box]]\nvelocity = [0, 0, -8000]\n",
         "step 1, phase finish_motion: body 1: found velocity (0, 0, -12500) m/s, wanted finite and within ±8192 "
         "m/s; use smaller speeds, a smaller dt or less extreme masses"},
};

// What the program says of the scene.
std::string slip_text(const std::string& text) {
  const Result<sim::SceneDef> scene = scenes::parse_scene(text, "slip.toml");
  if (!scene.ok()) return scene.error().message;
  Result<replay::Session> session = replay::Session::start(*scene);
  if (!session.ok()) return session.error().message;
  for (std::uint64_t k = 0; k < scene->steps; ++k) {
    const auto taken = session->step();
    if (!taken.ok()) return taken.error().message;
  }
  return "nothing";
}

}  // namespace

void run_known_refusals(CanaryRoll& roll) {
  for (const Slip& slip : kSlips) {
    roll.known(slip.name, [&slip]() -> std::string {
      const std::string message = slip_text(slip.scene != nullptr ? slip.scene : many_dots());
      return message.starts_with(slip.message) ? "as known" : message;
    });
  }
}

}  // namespace tumble::golden
