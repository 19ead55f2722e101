// Any text as a scene; what is one is also resolved to a world.
#include <string_view>

#include "tests/fuzz/target.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kBodiesMax = 20'000;  // a generator makes many of few bytes; the rest is more of the same
  const tumble::Result<tumble::sim::SceneDef> scene =
      tumble::scenes::parse_scene({reinterpret_cast<const char*>(data), size}, "fuzzed.toml");
  if (scene.ok() && scene->boxes.size() <= kBodiesMax) (void)tumble::sim::create_world(*scene).ok();
  return 0;
}
