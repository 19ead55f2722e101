// The glue for Bullet and ODE in engines that hold bodies which nobody told the recorder of.
#include <gtest/gtest.h>
#include <tumble_bullet.h>
#include <tumble_ode.h>

#include <memory>
#include <vector>

namespace tumble::test {
namespace {

int swallow(void* /*user*/, const void* /*bytes*/, std::size_t /*size*/) { return 0; }

TumbleRecDef to_nowhere() {
  TumbleRecDef def = {};
  def.write = swallow;
  return def;
}

TEST(Glue, BulletPassesOverContactsOfBodiesThatWereNotTold) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
  world.setGravity({0, 0, btScalar(-9.81)});
  btStaticPlaneShape plane({0, 0, 1}, 0);
  btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  world.addRigidBody(&ground);
  btBoxShape box({btScalar(0.5), btScalar(0.5), btScalar(0.5)});
  {
    BulletRecorder recorder(world, to_nowhere());
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    for (const int place : {0, 5}) {
      btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &box, {1, 1, 1});
      info.m_startWorldTransform.setIdentity();
      info.m_startWorldTransform.setOrigin({btScalar(place), 0, btScalar(0.49)});
      bodies.push_back(std::make_unique<btRigidBody>(info));
      world.addRigidBody(bodies.back().get());
    }
    recorder.add(*bodies.front(), "told");
    for (int k = 0; k < 5; ++k) recorder.step(btScalar(1) / 60);
    EXPECT_EQ(tumble_rec_finish(recorder.rec), TUMBLE_REC_OK) << tumble_rec_message(recorder.rec);
    EXPECT_EQ(tumble_rec_step(recorder.rec), 5U);
    for (const auto& body : bodies) world.removeRigidBody(body.get());
  }
  world.removeRigidBody(&ground);
}

TEST(Glue, OdePassesOverContactsOfBodiesThatWereNotTold) {
  dInitODE();
  dWorldID world = dWorldCreate();
  dGeomID one = dCreateSphere(nullptr, 1), other = dCreateSphere(nullptr, 1);
  {
    OdeRecorder recorder(world, to_nowhere());
    recorder.begin_step(0.01);
    const dContact touch = {};
    recorder.contacts(one, other, &touch, 1);
    recorder.end_step();
    EXPECT_EQ(tumble_rec_finish(recorder.rec), TUMBLE_REC_OK) << tumble_rec_message(recorder.rec);
  }
  dGeomDestroy(one);
  dGeomDestroy(other);
  dWorldDestroy(world);
  dCloseODE();
}

}  // namespace
}  // namespace tumble::test
