#include <array>
#include <string>
#include <utility>

#include "golden/canaries/known_answers.h"
#include "src/scenes/generators.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

// The least and the greatest value that a key takes, and values beyond; "" where there is none.
struct Limits {
  const char* scene;  // $ is the value
  const char* too_small;
  const char* least;
  const char* greatest;
  const char* too_great;
};
constexpr std::array kLimits = {
    Limits{"[[box]]\nsize = [1, 1, $]\nposition = [0, 0, 3000]\n", "0.00009", "0.0001", "4096", "4097"},
    Limits{"[[box]]\nmass = $\n", "0.9e-9", "1e-9", "1e12", "1.1e12"},
    Limits{"[[box]]\nsize = [100, 100, 100]\ndensity = $\n", "0.9e-6", "1e-6", "1e6", "1.1e6"},
    Limits{"[[box]]\nsize = [0.1, 0.1, 0.1]\ndensity = $\n", "0", "1e-6", "1e9", "1.1e9"},
    Limits{"[[box]]\nposition = [0, $, 1]\n", "-32768.1", "-32768", "32768", "32768.1"},
    Limits{"[[box]]\nvelocity = [0, 0, $]\n", "-8193", "-8192", "8192", "8193"},
    Limits{"[[box]]\nspin = [$, 0, 0]\n", "-8193", "-8192", "8192", "8193"},
    Limits{"[[box]]\norientation = [1, 0, $, 0]\n", "-1000001", "-1000000", "1000000", "1000001"},
    Limits{"[[box]]\norientation = [$, 0, 0, 0]\n", "0.99e-6", "1e-6", "1", "1000001"},
    Limits{"[[box]]\naxis = [1, 0, $]\ndegrees = 1\n", "-1000001", "-1000000", "1000000", "1000001"},
    Limits{"[[box]]\naxis = [0, 0, $]\ndegrees = 1\n", "0.99e-6", "1e-6", "1", "1000001"},
    Limits{"[[box]]\naxis = [1, 0, 0]\ndegrees = $\n", "-36001", "-36000", "36000", "36001"},
    Limits{"[[box]]\nid = $\n", "0", "1", "9007199254740991", "9223372036854775808"},
    Limits{"[[box]]\n[material]\nfriction = $\n", "-0.1", "0", "100", "100.1"},
    Limits{"[[box]]\n[material]\nfriction_dynamic = $\n", "-0.1", "0", "100", "100.1"},
    Limits{"[[box]]\nmaterial = { restitution = $ }\n", "-0.1", "0", "1", "1.01"},
    Limits{"[[box]]\n[world]\nsteps = 1\ndt = $\n", "0.9e-7", "1e-7", "1", "1.01"},
    Limits{"[[box]]\n[world]\ndt = 0.1\nseconds = $\n", "0.04", "0.05", "1e7", "10000001"},
    Limits{"[[box]]\n[world]\nsteps = $\n", "0", "1", "100000000", "100000001"},
    Limits{"[[box]]\n[world]\nsubsteps = $\n", "0", "1", "1024", "1025"},
    Limits{"[[box]]\n[world]\nsplit_collisions = $\n", "-1", "0", "1000000000", "1000000001"},
    Limits{"[[box]]\n[world]\ngravity = [0, 0, $]\n", "-10001", "-10000", "10000", "10001"},
    Limits{"[[box]]\n[world]\nfreeze_energy = $\n", "-1", "0", "1e6", "1.1e6"},
    Limits{"[[box]]\n[world]\nfreeze_time = $\n", "-1", "0", "1e6", "1.1e6"},
    Limits{"[[box]]\n[world]\nslip_speed = $\n", "-1", "0", "8192", "8193"},
    Limits{"[[box]]\n[world]\nair_drag = $\n", "-1", "0", "1000", "1001"},
    Limits{"[[box]]\n[camera]\nposition = [0, $, 9]\n", "-1000001", "-1000000", "1000000", "1000001"},
    Limits{"[[box]]\n[camera]\nfov = $\n", "0.9", "1", "170", "171"},
    Limits{"[[box]]\n[camera]\nfocus = $\n", "0.9e-3", "1e-3", "1e6", "1.1e6"},
    Limits{"[[box]]\n[camera]\nblur = $\n", "-1", "0", "100", "101"},
    Limits{"[[grid]]\nrows = $\ncols = 1\n", "0", "1", "9", "4000001"},
    Limits{"[[grid]]\ntilt = $\n", "-1", "0", "90", "91"},
    Limits{"[[grid]]\npitch = $\n", "-1", "0", "1600", "32769"},
    Limits{"[[grid]]\nbase = $\n", "-32769", "-32000", "32000", "32769"},
    Limits{"[[tower]]\ncount = 2\ntaper = $\n", "0.009", "0.01", "100", "101"},
    Limits{"[[tower]]\njitter = { position = $ }\n", "-1", "0", "32000", "32769"},
    Limits{"[[tower]]\njitter = { degrees = $ }\n", "-1", "0", "180", "181"},
    Limits{"[[tower]]\njitter = { seed = $ }\n", "-1", "0", "9223372036854775807", "9223372036854775808"},
    Limits{"[[pyramid]]\nbase = $\n", "0", "1", "9", "2828"},
    Limits{"[[wall]]\nbricks = $\ncourses = 2000\n", "0", "1", "2", "2001"},
    Limits{"[[pile]]\ncount = [$, 2000, 2]\npitch = 0\n", "0", "1", "2", "1001"},
    Limits{"[[box]]\n[world]\nsteps = 9\n[[input]]\nkind = \"wake\"\nid = 1\nstep = $\n", "0", "1", "9", "10"},
    Limits{"[[box]]\n[world]\nsteps = 9\ndt = 1\n[[input]]\nkind = \"wake\"\nid = 1\ntime = $\n", "-1", "0", "8.4",
           "8.6"},
    Limits{"[[box]]\n[[input]]\nkind = \"push\"\nid = 1\nstep = 1\nimpulse = [0, 0, $]\n", "-1.1e12", "-1e12", "1e12",
           "1.1e12"},
    Limits{"[[box]]\n[[input]]\nkind = \"set_dt\"\nstep = 1\ndt = $\n", "0.9e-7", "1e-7", "1", "1.01"},
};

std::string with(std::string text, const char* value) { return text.replace(text.find('$'), 1, value); }

// The first limit that does not hold; "as known" if all do.
std::string broken_limit() {
  for (const Limits& limits : kLimits) {
    for (const auto& [value, taken] : {std::pair{limits.too_small, false}, std::pair{limits.least, true},
                                       std::pair{limits.greatest, true}, std::pair{limits.too_great, false}}) {
      const Result<sim::SceneDef> scene = scenes::parse_scene(with(limits.scene, value), "known.toml");
      if (scene.ok() == taken) continue;
      return with(limits.scene, value) + (scene.ok() ? "is taken" : "is refused: " + scene.error().message);
    }
  }
  return "as known";
}

// The first count of bodies that is not the known one; shapes at the limit and one beyond it.
std::string most_bodies() {
  using scenes::GridShape, scenes::PileShape, scenes::PyramidShape, scenes::TowerShape, scenes::WallShape;
  const auto told = [](const scenes::Shape& shape) {
    return std::to_string(scenes::body_count(shape).value_or(0)) + " ";
  };
  const std::string counts = told(GridShape{2000, 2000}) + told(GridShape{2000, 2001}) + told(TowerShape{4'000'000}) +
                             told(PyramidShape{2827}) + told(PyramidShape{2828}) + told(WallShape{2000, 2000}) +
                             told(WallShape{2001, 2000}) + told(PileShape{100, 200, 200}) +
                             told(PileShape{4'000'000, 4'000'000, 4'000'000}) + told(PileShape{2001, 2000, 1});
  const bool known = counts == "4000000 0 4000000 3997378 0 4000000 0 4000000 0 0 ";
  return known ? "as known" : counts;
}

}  // namespace

void run_known_limits(CanaryRoll& roll) {
  roll.known("every key of a scene has its limits", broken_limit);
  roll.known("generators make up to four million bodies", most_bodies);
}

}  // namespace tumble::golden
