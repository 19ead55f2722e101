// recorder_bench BODIES STEPS FILE [states] [N]: what the recorder costs Bullet. Three equal worlds of falling cubes
// take their steps in turn; the second is recorded to FILE with all states, and contacts unless told `states`, N steps
// a write (0: through the tail). Prints CPU time (user and system) a step, and over all steps the median and quartiles
// of recorded / plain and, as the measure's own error, of the third world / plain. Run by hand; docs/performance.md has
// results.
#include <tumble_bullet.h>  // of examples/engines, which are outside the rooms

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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

namespace {

/// Of the steps' ratios to those of the plain world.
void print(const char* what, const std::vector<double>& seconds, const std::vector<double>& plain) {
  std::vector<double> ratios;
  double sum = 0, plain_sum = 0;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    ratios.push_back(seconds[k] / plain[k]);
    sum += seconds[k], plain_sum += plain[k];
  }
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](double part) { return ratios[static_cast<std::size_t>(part * double(ratios.size() - 1))]; };
  std::printf("%-8s %8.1f us a step; over plain: median %.4f (quartiles %.4f, %.4f), of the sums %.4f\n", what,
              1e6 * sum / double(plain.size()), at(0.5), at(0.25), at(0.75), sum / plain_sum);
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 3 ? std::atoi(argv[1]) : 0, steps = argc > 3 ? std::atoi(argv[2]) : 0;
  if (count < 1 || steps < 1) return std::fprintf(stderr, "usage: recorder_bench BODIES STEPS FILE [states] [N]\n"), 2;
  World plain(count), recorded(count), control(count);
  const bool only_states = argc > 4 && std::strcmp(argv[4], "states") == 0;
  TumbleRecDef def = {};
  def.steps_a_write = argc > 4 + only_states ? static_cast<uint32_t>(std::atoi(argv[4 + only_states])) : 0;
  def.path = argv[3];
  def.ground = 1;
  BulletRecorder recorder(recorded.world, def);
  for (const auto& body : recorded.bodies) recorder.add(*body, nullptr);
  recorder.contacts = !only_states;
  std::vector<double> seconds[3];
  for (int k = 0; k < 3 * steps; ++k) {
    const int which = (k + k / 3) % 3;  // each goes first in turn
    const double begun = cpu_seconds();
    if (which == 1) {
      recorder.step(btScalar(1) / 60);
    } else {
      (which == 0 ? plain : control).world.stepSimulation(btScalar(1) / 60, 0);
    }
    seconds[which].push_back(cpu_seconds() - begun);
  }
  const TumbleRecStatus status = tumble_rec_finish(recorder.rec);
  if (status != TUMBLE_REC_OK) return std::fprintf(stderr, "%s\n", tumble_rec_message(recorder.rec)), 4;
  std::printf("%d bodies, %d steps, %s, %u steps a write\n", count, steps,
              only_states ? "states" : "states and contacts", def.steps_a_write);
  print("plain", seconds[0], seconds[0]);
  print("recorded", seconds[1], seconds[0]);
  print("control", seconds[2], seconds[0]);
  return 0;
}
