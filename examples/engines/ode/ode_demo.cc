// Ten cubes in ODE, recorded, with probes for `tumble diff --zoom`. ../demo.h has the arguments.
#include <algorithm>

#include "../demo.h"
#include "tumble_ode.h"
#include "tumble_probe.h"

namespace {

struct Scene {
  dWorldID world = nullptr;
  dJointGroupID joints = nullptr;
  double friction = 0.5;
  OdeRecorder* recorder = nullptr;
};

void collide(void* data, dGeomID a, dGeomID b) {
  auto& scene = *static_cast<Scene*>(data);
  dContact contacts[8] = {};
  const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
  const auto [low, high] =
      std::minmax({scene.recorder->id_of(dGeomGetBody(a)), scene.recorder->id_of(dGeomGetBody(b))});
  for (int k = 0; k < count; ++k) {
    contacts[k].surface.mode = dContactApprox1;
    TUMBLE_PROBE_PAIR(&tumble_probes, "contact.depth", low, high, contacts[k].geom.depth);
    contacts[k].surface.mu = scene.friction;
    TUMBLE_PROBE_PAIR(&tumble_probes, "contact.friction", low, high, contacts[k].surface.mu);
    dJointAttach(dJointCreateContact(scene.world, scene.joints, &contacts[k]), dGeomGetBody(a), dGeomGetBody(b));
  }
  scene.recorder->contacts(a, b, contacts, count);
}

}  // namespace

int main(int count, char** words) {
  Demo demo(count, words);
  tumble_probes_from_environment(&tumble_probes);
  dInitODE();
  const dSpaceID space = dHashSpaceCreate(nullptr);
  Scene scene = {dWorldCreate(), dJointGroupCreate(0), demo.friction, nullptr};
  dWorldSetGravity(scene.world, 0, 0, -9.81);
  dWorldSetAutoDisableFlag(scene.world, 1);
  dCreatePlane(space, 0, 0, 1, 0);
  OdeRecorder recorder(scene.world, demo.def);
  scene.recorder = &recorder;
  for (int k = 0; k < 10; ++k) {
    double at[3], tilt = 0;
    demo_cube(k, at, &tilt);
    const dBodyID body = dBodyCreate(scene.world);
    const dGeomID box = dCreateBox(space, 1, 1, 1);
    dMass mass;
    dMassSetBoxTotal(&mass, 1, 1, 1, 1);
    dBodySetMass(body, &mass);
    dMatrix3 turn;
    dRFromAxisAndAngle(turn, 1, 0, 0, tilt);
    dBodySetPosition(body, at[0], at[1], at[2]);
    dBodySetRotation(body, turn);
    dGeomSetBody(box, body);
    char name[16];
    std::snprintf(name, sizeof name, "cube %d", k);
    recorder.add_box(body, box, name, 0.5);
  }
  for (int k = 0; k < demo.steps; ++k) {
    tumble_probes_step(&tumble_probes, static_cast<std::uint64_t>(k) + 1);
    recorder.begin_step(1.0 / 60);
    dSpaceCollide(space, &scene, collide);
    dWorldQuickStep(scene.world, 1.0 / 60);
    dJointGroupEmpty(scene.joints);
    recorder.end_step();
  }
  tumble_probes_close(&tumble_probes);
  const int status = Demo::end(recorder.rec);
  dJointGroupDestroy(scene.joints), dSpaceDestroy(space), dWorldDestroy(scene.world), dCloseODE();
  return status;
}
