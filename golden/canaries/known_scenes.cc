#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "golden/canaries/known_answers.h"
#include "golden/suite/scene_hash.h"
#include "src/base/text.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

std::string place_text(const sim::Vec3& v) { return exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z()); }

// Names, camera and light of a scene that says nothing of them.
constexpr std::string_view kUsual =
    "known, known, session, camera 12 -16 8 to 0 0 2 fov 40 focus 20.8806130178211 blur 1, light 10 -10 25 to 0 0 0";

std::string view_of(const sim::SceneDef& scene) {
  const sim::Camera& camera = scene.camera;
  return scene.name + ", " + scene.title + ", " + scene.category + ", camera " + place_text(camera.position) + " to " +
         place_text(camera.target) + " fov " + exact(camera.fov) + " focus " + exact(camera.focus) + " blur " +
         exact(camera.blur) + ", light " + place_text(scene.light.position) + " to " + place_text(scene.light.target);
}

// Sessions and metrics depend on the hash alone, pictures on the rest.
std::string scene_text(const sim::SceneDef& scene) {
  std::string text = to_string(scene_hash(scene)).substr(0, 16) + ", " + count_text(scene.boxes.size(), "body") + ", " +
                     count_text(scene.inputs.size(), "input");
  if (const std::string view = view_of(scene); view != kUsual) text += ", " + view;
  std::string textures;
  for (const sim::BoxDef& box : scene.boxes) textures += std::to_string(static_cast<int>(box.material.texture));
  if (textures.find_first_not_of('0') != std::string::npos) text += ", textures " + textures;
  return text;
}

std::string read_scene(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Result<sim::SceneDef> scene = scenes::parse_scene(text, "a/known.toml", overrides);
  return scene.ok() ? scene_text(*scene) : scene.error().message;
}

constexpr const char* kEveryKey = R"(name = "every.key-1"
title = "every key"
category = "impact"
[world]
method = "layered"
dt = 0.01
seconds = 0.5
substeps = 3
gravity = [0.5, 0.25, -9]
ground = false
split_collisions = 2
freezing = false
freeze_energy = 0.01
freeze_time = 0.25
slip_speed = 0.02
air_drag = 0.125
[material]
friction = 0.5
friction_dynamic = 0.25
restitution = 0.75
texture = "brick"
[[box]]
id = 7
size = [1, 2, 3]
density = 500
position = [1, 2, 30]
axis = [1, 2, 2]
degrees = 50
velocity = [1, -2, 3]
spin = [-1, 2, -3]
material = { friction = 0.125, restitution = 0, texture = "wood" }
[[box]]
mass = 2.5
orientation = [3, 0, 4, 0]
position = [9, 0, 3]
static = true
[[box]]
frozen = true
position = [-9, 0, 3]
[[input]]
kind = "throw"
time = 0.1
id = 40
position = [20, 0, 5]
[[input]]
kind = "push"
step = 20
id = 7
impulse = [1, 2, 3]
[[input]]
kind = "push"
step = 20
id = 7
impulse = [1, 2, 3]
at = [1, 2, 30.5]
[[input]]
kind = "set_velocity"
step = 21
id = 7
velocity = [1, 0, 0]
spin = [0, 1, 0]
[[input]]
kind = "set_gravity"
step = 22
gravity = [0, 1, 0]
[[input]]
kind = "set_dt"
step = 23
dt = 0.02
[[input]]
kind = "wake"
step = 24
id = 40
[[input]]
kind = "remove"
step = 25
id = 40
[camera]
position = [1, -20, 9]
target = [2, 1, 3]
fov = 50
focus = 12
blur = 2
[light]
position = [3, -4, 30]
target = [1, 2, 3]
)";

// Scenes and what is read from them: a table of each kind with no key and with every key.
struct KnownScene {
  const char* name;
  const char* scene;
  const char* wanted;
};
constexpr std::array kKnown = {
    KnownScene{
        "every key of a scene means what it meant", kEveryKey,
        "c797b84fed88fd4d, 3 bodies, 8 inputs, every.key-1, every key, impact, camera 1 -20 9 to 2 1 3 fov 50 focus "
        "12 blur 2, light 3 -4 30 to 1 2 3, textures 112"},
    KnownScene{"keys that a scene leaves out mean what they meant", "[[box]]\n", "a57d13e3a8dd46f9, 1 body, 0 inputs"},
    KnownScene{"inputs mean what they meant without the keys that they may leave out",
               R"([[box]]
[[input]]
kind = "throw"
step = 1
[[input]]
kind = "push"
step = 2
id = 1
impulse = [1, 2, 3]
[[input]]
kind = "set_velocity"
step = 3
id = 1
velocity = [1, 2, 3]
)",
               "874131dcc04c3e64, 1 body, 3 inputs"},
    KnownScene{"a grid stands where it stood", "[[grid]]\n", "26785302db96d6e9, 400 bodies, 0 inputs"},
    KnownScene{
        "a grid of given keys stands where it stood",
        "[[grid]]\nrows = 2\ncols = 3\npitch = 2\ntilt = 30\nbase = 1\nsize = [1, 0.5, 2]\nmass = 3\nfirst_id = 9\n"
        "jitter = { position = 0.25, degrees = 10, seed = 5 }\nmaterial = { texture = \"white\" }\n",
        "54bb1c2e05218da8, 6 bodies, 0 inputs, textures 444444"},
    KnownScene{"a tower stands where it stood", "[[tower]]\n", "e196e9e1d5cc4bcc, 10 bodies, 0 inputs"},
    KnownScene{
        "a tower of given keys stands where it stood",
        "[[tower]]\ncount = 3\ntaper = 0.5\nposition = [1, 2, 3]\nsize = [1, 2, 0.5]\ndensity = 100\nfrozen = true\n",
        "ee0393f987e36cd1, 3 bodies, 0 inputs"},
    KnownScene{"a pyramid stands where it stood", "[[pyramid]]\n", "3a0c0ee351f34135, 210 bodies, 0 inputs"},
    KnownScene{"a pyramid of given keys stands where it stood",
               "[[pyramid]]\nbase = 3\nspacing = 2\nposition = [1, 2, 3]\nsize = [1, 2, 0.5]\n",
               "624c562724023230, 6 bodies, 0 inputs"},
    KnownScene{"a wall stands where it stood", "[[wall]]\n", "d74d9d27e2fac83d, 221 bodies, 0 inputs"},
    KnownScene{
        "a wall of given keys stands where it stood",
        "[[wall]]\ncourses = 3\nbricks = 2\nspacing = 3\nshift = 0.25\nposition = [1, 2, 3]\nsize = [1, 2, 0.5]\n",
        "68e9168f78004d72, 6 bodies, 0 inputs"},
    KnownScene{"a pile stands where it stood", "[[pile]]\n", "3b01ebc0e67e6d9b, 512 bodies, 0 inputs"},
    KnownScene{"a pile of given keys stands where it stood",
               "[[pile]]\ncount = [2, 3, 4]\npitch = 2\nposition = [1, 2, 3]\nsize = [1, 2, 0.5]\n",
               "f04ba2cbdf6b5aad, 24 bodies, 0 inputs"},
    KnownScene{
        "boxes without an id take those that are free",
        "[[box]]\nposition = [1, 0, 1]\n[[box]]\nid = 1\nposition = [2, 0, 1]\n[[box]]\nid = 3\nposition = [3, 0, 1]\n"
        "[[tower]]\ncount = 2\n[[input]]\nkind = \"throw\"\nstep = 2\n[[tower]]\ncount = 2\nfirst_id = 20\n",
        "04c0e2ba24bde55c, 7 bodies, 1 input"},
};

// What --set makes of a scene, and what a wrong one is told.
struct Override {
  const char* set;
  const char* wanted;
};
constexpr const char* kOverridden =
    "[world]\nsteps = 9\n[[box]]\nmass = 2\n[[box]]\nposition = [5, 0, 1]\n[[grid]]\nrows = 2\ncols = 2\n";
constexpr std::array kOverrides = {
    Override{"world.seconds=0.5", "5098df90d28400f4, 6 bodies, 0 inputs"},
    Override{"box.2.density=100", "3ca0b0dace9b0307, 6 bodies, 0 inputs"},
    Override{"grid.cols=3", "5dd12f82950f32e8, 8 bodies, 0 inputs"},
    Override{"camera.fov=70",
             "9ed2a045b33d6788, 6 bodies, 0 inputs, known, known, session, camera 12 -16 8 to 0 0 2 fov 70 focus "
             "20.8806130178211 blur 1, light 10 -10 25 to 0 0 0"},
    Override{"world.method=thesis", "93759470b1b3f8af, 6 bodies, 0 inputs"},
    Override{"box.3.mass=1", "--set box.3.mass=1: found number 3, wanted 1 to 2: the scene has that many [[box]]"},
    Override{"box.mass", "--set box.mass: found no \"=\", wanted key=value, such as world.dt=0.01"},
    Override{"b ox.mass=1",
             "--set b ox.mass=1: found a strange key, wanted words with dots between, such as grid.2.rows"},
    Override{"a.b.c.d.e.f.g=1",
             "--set a.b.c.d.e.f.g=1: found a strange key, wanted words with dots between, such as grid.2.rows"},
    Override{"box.1=1", "--set box.1=1: found a table, wanted a key of [[box]] after its number"},
    Override{"pile.pitch=1", "--set pile.pitch=1: found no [[pile]] in the scene, wanted one to set a key in"},
    Override{"world.steps=[",
             "--set world.steps=[: found a value that is not TOML, wanted one such as 7, 0.5, [1, 2, 3] or a word"},
};

}  // namespace

void run_known_scenes(CanaryRoll& roll) {
  for (const KnownScene& one : kKnown) {
    roll.known(
        one.name, [&one] { return read_scene(one.scene); }, one.wanted);
  }
  for (const Override& one : kOverrides) {
    roll.known(
        std::string("a scene with --set ") + one.set, [&one] { return read_scene(kOverridden, {one.set}); },
        one.wanted);
  }
}

}  // namespace tumble::golden
