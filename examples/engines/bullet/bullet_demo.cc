// Ten cubes in Bullet, recorded. ../demo.h has the arguments.
#include <memory>
#include <vector>

#include "../demo.h"
#include "tumble_bullet.h"

int main(int count, char** words) {
  Demo demo(count, words);
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
  for (int k = 0; k < demo.steps; ++k) recorder.step(btScalar(1) / 60);
  const int status = Demo::end(recorder.rec);
  for (auto& body : bodies) world.removeRigidBody(body.get());
  world.removeRigidBody(&ground);
  return status;
}
