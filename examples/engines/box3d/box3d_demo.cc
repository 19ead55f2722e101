// Ten cubes in Box3D, recorded. ../demo.h has the arguments.
#include "../demo.h"
#include "box3d/collision.h"
#include "tumble_box3d.h"

int main(int count, char** words) {
  Demo demo(count, words);
  b3WorldDef world_def = b3DefaultWorldDef();
  world_def.gravity = {0, 0, -9.81f};
  const b3WorldId world = b3CreateWorld(&world_def);
  Box3dRecorder recorder(world, demo.def);
  b3ShapeDef shape = b3DefaultShapeDef();
  shape.density = 1;
  b3BodyDef def = b3DefaultBodyDef();
  def.position = {0, 0, -1};
  const b3BoxHull floor = b3MakeBoxHull(50, 50, 1), cube = b3MakeCubeHull(0.5f);
  shape.baseMaterial.friction = static_cast<float>(demo.friction);  // not in the log: what diff finds is its effect
  b3CreateHullShape(b3CreateBody(world, &def), &shape, &floor.base);
  shape.baseMaterial.friction = 0.5f;
  def.type = b3_dynamicBody;
  for (int k = 0; k < 10; ++k) {
    double at[3], tilt = 0;
    demo_cube(k, at, &tilt);
    def.position = {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
    def.rotation = b3MakeQuatFromAxisAngle({1, 0, 0}, static_cast<float>(tilt));
    const b3BodyId body = b3CreateBody(world, &def);
    b3CreateHullShape(body, &shape, &cube.base);
    char name[16];
    std::snprintf(name, sizeof name, "cube %d", k);
    recorder.add(body, name, {1, 1, 1}, 0.5);
  }
  for (int k = 0; k < demo.steps; ++k) recorder.step(1.0f / 60, 4);
  const int status = Demo::end(recorder.rec);
  b3DestroyWorld(world);
  return status;
}
