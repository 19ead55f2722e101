// Our engine behind the interface of the others. Bodies get their ids in the order of adding, so that a shuffled order
// is a shuffled world.
#include <utility>
#include <vector>

#include "bench/peers/engine.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::peers {
namespace {

class TumbleEngine : public Engine {
 public:
  explicit TumbleEngine(const sim::SceneDef& scene) : start_(scene) { start_.boxes.clear(); }

  Status add(const sim::BoxDef& box) override {
    sim::BoxDef renamed = box;
    renamed.id = ++count_;
    if (world_) return sim::apply(*world_, sim::Throw{renamed});
    start_.boxes.push_back(renamed);
    return {};
  }

  Status ready() override {
    Result<sim::World> world = sim::create_world(start_);
    if (!world.ok()) return world.error();
    world_ = *std::move(world);
    return {};
  }

  Status set_gravity(const sim::Vec3& gravity) override {
    if (world_) return sim::apply(*world_, sim::SetGravity{gravity});
    start_.world.gravity = gravity;
    return {};
  }

  Status step(double dt_s) override {
    if (dt_s != world_->state().def.dt) {
      if (Status ok = sim::apply(*world_, sim::SetDt{dt_s}); !ok.ok()) return ok;
    }
    const Result<sim::StepCounters> done = sim::step(*world_);
    if (!done.ok()) return done.error();
    return {};
  }

  [[nodiscard]] BodyState read(std::size_t row) const override {
    const sim::Bodies& bodies = world_->bodies();  // in the order of their ids, which is that of adding
    return {bodies.position[row], bodies.orientation[row], bodies.velocity[row], bodies.spin[row],
            bodies.frozen[row] != 0};
  }

 private:
  sim::SceneDef start_;
  sim::BodyId count_ = 0;
  std::optional<sim::World> world_;
};

}  // namespace

replay::EngineName engine_name() { return {"Tumble", replay::header_for({}).tool_version, replay::kBinary64Bits}; }

std::unique_ptr<Engine> make_engine(const sim::SceneDef& scene) { return std::make_unique<TumbleEngine>(scene); }

}  // namespace tumble::peers
