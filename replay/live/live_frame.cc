#include "replay/live/live_frame.h"

namespace tumble::replay {

// Bodies and looks both ascend by id. Every body of the world has a look; one without would be drawn as a crate.
void fill_bodies(LiveFrame& frame, const sim::World& world, const std::map<sim::BodyId, sim::Texture>& looks) {
  const sim::Bodies& bodies = world.bodies();
  frame.snapshot.boxes.resize(bodies.size());
  frame.is_moving.resize(bodies.size());
  frame.mass = bodies.mass;
  frame.snapshot.markers.clear();
  frame.moving = 0;
  auto look = looks.begin();
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
    render::BoxLook& box = frame.snapshot.boxes[i];
    while (look != looks.end() && look->first < bodies.id[i]) ++look;
    box.id = bodies.id[i];
    box.centre = bodies.position[i];
    box.orientation = bodies.orientation[i];
    box.half_extent = bodies.half_extent[i];
    box.velocity = bodies.velocity[i];
    box.spin = bodies.spin[i];
    box.texture = look != looks.end() && look->first == box.id ? look->second : sim::Texture::kCrate;
    frame.is_moving[i] = bodies.moves(i) ? 1 : 0;
    frame.moving += frame.is_moving[i];
  }
}

}  // namespace tumble::replay
