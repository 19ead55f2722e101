// recorder_bench BODIES STEPS FILE [states]: what the recorder costs Bullet. Two equal worlds of falling cubes take
// their steps in turn, one of them recorded to FILE with all states, and contacts unless told `states`; prints both CPU
// times and their ratio. Run by hand; docs/performance.md has results.
#include <tumble_bullet.h>  // of examples/engines, which are outside the rooms

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Cubes in layers of a square grid, aslant, so that all move and meet.
class World {
 public:
  explicit World(int count) : dispatcher_(&configuration_) {
    world.setGravity({0, 0, btScalar(-9.81)});
    world.addRigidBody(&ground_);
    btVector3 inertia;
    box_.calculateLocalInertia(1, inertia);
    const int side = std::max(1, static_cast<int>(std::sqrt(count / 4.0)));
    for (int k = 0; k < count; ++k) {
      btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &box_, inertia);
      const int layer = k / (side * side), row = k / side % side, column = k % side;
      info.m_startWorldTransform.setIdentity();
      info.m_startWorldTransform.setOrigin(
          {btScalar(1.2 * column + 0.1 * (layer % 3)), btScalar(1.2 * row), btScalar(0.7 + 1.1 * layer)});
      info.m_startWorldTransform.setRotation(btQuaternion({1, 0, 0}, btScalar(0.05 * (k % 7))));
      bodies.push_back(std::make_unique<btRigidBody>(info));
      bodies.back()->setActivationState(DISABLE_DEACTIVATION);  // bodies at rest cost the recorder less
      world.addRigidBody(bodies.back().get());
    }
  }
  ~World() {
    for (const auto& body : bodies) world.removeRigidBody(body.get());
    world.removeRigidBody(&ground_);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btBoxShape box_{{btScalar(0.5), btScalar(0.5), btScalar(0.5)}};
  btStaticPlaneShape plane_{{0, 0, 1}, 0};
  btRigidBody ground_{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane_)};

 public:
  btDiscreteDynamicsWorld world{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btRigidBody>> bodies;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "usage: recorder_bench BODIES STEPS FILE [states]\n"), 2;
  const int count = std::atoi(argv[1]), steps = std::atoi(argv[2]);
  World plain(count), recorded(count);
  TumbleRecDef def = {};
  def.path = argv[3];
  def.ground = 1;
  BulletRecorder recorder(recorded.world, def);
  for (const auto& body : recorded.bodies) recorder.add(*body, nullptr);
  recorder.contacts = argc == 4;
  double plain_s = 0, recorded_s = 0;
  const auto time = [](double& sum, const auto& step) {
    const double begun = cpu_seconds();
    step();
    sum += cpu_seconds() - begun;
  };
  for (int k = 0; k < steps; ++k) {  // first one, then the other goes first
    if (k % 2 == 0) time(plain_s, [&] { plain.world.stepSimulation(btScalar(1) / 60, 0); });
    time(recorded_s, [&] { recorder.step(btScalar(1) / 60); });
    if (k % 2 == 1) time(plain_s, [&] { plain.world.stepSimulation(btScalar(1) / 60, 0); });
  }
  const TumbleRecStatus status = tumble_rec_finish(recorder.rec);
  if (status != TUMBLE_REC_OK) return std::fprintf(stderr, "%s\n", tumble_rec_message(recorder.rec)), 4;
  std::printf("%d bodies, %d steps: %.3f s plain, %.3f s recorded, ratio %.4f\n", count, steps, plain_s, recorded_s,
              recorded_s / plain_s);
  return 0;
}
