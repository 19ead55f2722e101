#include <array>
#include <string>

#include "golden/canaries/known_answers.h"
#include "tumble/replay/session.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

struct Slip {
  const char* name;
  std::string scene;
  const char* message;  // begins so; what a library says of TOML may follow
};

std::string many_dots() {
  std::string line = "[a.";
  for (int k = 0; k < 256; ++k) line += "b.";
  return line + "c]\n";
}

const auto& slips() {
  static const std::array kSlips = {
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
      Slip{"a line of dots is named", many_dots(),
           "slip.toml:1:1: found a line of more than 256 dots, wanted fewer of them"},
      Slip{"a character that turns the writing is not shown", "[[box]]\n\"a\\u202eb\" = 1\n",
           "slip.toml:2:1: [[box]] key \"a???b\": found an unknown key, wanted size, mass, density, material, frozen, "
           "id, static, position, axis, degrees, orientation, velocity or spin"},
      Slip{"a scene without a body is named", "[world]\nsteps = 2\n",
           "slip.toml:1:1: found no body, wanted at least one [[box]], generator or [[input]] that throws a box"},
      Slip{"a camera at its target is named", "[[box]]\n[camera]\nposition = [0, 0, 2]\ntarget = [0, 0, 2]\n",
           "slip.toml:4:10: [camera] key \"target\": found [0, 0, 2], wanted another point than position, or there is "
           "no direction to look in"},
      Slip{"a generated body too far away is named",
           "[[wall]]\nposition = [30000, 500, 2]\ncourses = 2\nbricks = 4000\n",
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
      Slip{"a body that becomes too fast ends the session",
           "[world]\nsteps = 2\ndt = 0.5\nground = false\ngravity = [0, 0, -9000]\n[[box]]\nvelocity = [0, 0, -8000]\n",
           "step 1, phase finish_motion: body 1: found velocity (0, 0, -12500) m/s, wanted finite and within ±8192 "
           "m/s; use smaller speeds, a smaller dt or less extreme masses"},
  };
  return kSlips;
}

// What the program says of the scene.
std::string told(const std::string& text) {
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

std::vector<CanaryResult> run_known_refusals() {
  std::vector<CanaryResult> results;
  for (const Slip& slip : slips()) {
    const std::string message = told(slip.scene);
    results.push_back({slip.name, message.starts_with(slip.message), message});
  }
  return results;
}

}  // namespace tumble::golden
