// Ten cubes in Bullet, recorded, with probes for `tumble diff --zoom`. ../demo.h has the arguments.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "../demo.h"
#include "tumble_bullet.h"
#include "tumble_probe.h"

namespace {

// The contacts of a step as the solver left them.
void probe_contacts(btDispatcher& pairs) {
  const auto id_of = [](const btCollisionObject* o) { return static_cast<std::uint64_t>(std::max(0, o->getUserIndex3())); };
  for (int i = 0; i < pairs.getNumManifolds(); ++i) {
    const btPersistentManifold& m = *pairs.getManifoldByIndexInternal(i);
    const auto [low, high] = std::minmax({id_of(m.getBody0()), id_of(m.getBody1())});
    for (int k = 0; k < m.getNumContacts(); ++k) {
      const btManifoldPoint& point = m.getContactPoint(k);
      TUMBLE_PROBE_PAIR(&tumble_probes, "contact.distance", low, high, point.getDistance());
      TUMBLE_PROBE_PAIR(&tumble_probes, "contact.friction", low, high, point.m_combinedFriction);
      TUMBLE_PROBE_PAIR(&tumble_probes, "contact.impulse", low, high, point.getAppliedImpulse());
    }
  }
}

}  // namespace

int main(int count, char** words) {
  Demo demo(count, words);
  tumble_probes_from_environment(&tumble_probes);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
  world.setGravity({0, 0, btScalar(-9.81)});
  BulletRecorder recorder(world, demo.def);

  btStaticPlaneShape plane({0, 0, 1}, 0);
  btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  world.addRigidBody(&ground);
  btBoxShape box({btScalar(0.5), btScalar(0.5), btScalar(0.5)});
  btVector3 inertia;
  box.calculateLocalInertia(1, inertia);
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  for (int k = 0; k < 10; ++k) {
    double at[3], tilt = 0;
    demo_cube(k, at, &tilt);
    btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &box, inertia);
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin({btScalar(at[0]), btScalar(at[1]), btScalar(at[2])});
    info.m_startWorldTransform.setRotation(btQuaternion({1, 0, 0}, btScalar(tilt)));
    info.m_friction = btScalar(0.5);
    bodies.push_back(std::make_unique<btRigidBody>(info));
    char name[16];
    std::snprintf(name, sizeof name, "cube %d", k);
    recorder.add(*bodies.back(), name);
    world.addRigidBody(bodies.back().get());
  }
  ground.setFriction(btScalar(demo.friction));  // not in the log: what diff finds is its effect
  for (int k = 0; k < demo.steps; ++k) {
    tumble_probes_step(&tumble_probes, static_cast<std::uint64_t>(k) + 1);
    recorder.step(btScalar(1) / 60);
    probe_contacts(dispatcher);
  }
  tumble_probes_close(&tumble_probes);
  const int status = Demo::end(recorder.rec);
  for (auto& body : bodies) world.removeRigidBody(body.get());
  world.removeRigidBody(&ground);
  return status;
}
