// ODE as its manual sets it up: a hash space, quick step with 20 iterations, bodies that are disabled at rest.
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <vector>

#include "bench/peers/engine.h"

namespace tumble::peers {
namespace {

constexpr int kContactsMax = 8;        // of a pair
constexpr double kBounceSpeed = 0.05;  // m/s; below it nothing bounces

class OdeEngine : public Engine {
 public:
  explicit OdeEngine(const sim::SceneDef& scene) : ground_(scene.world.ground_material) {
    dInitODE();
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    const sim::Vec3& g = scene.world.gravity;
    dWorldSetGravity(world_, g.x(), g.y(), g.z());
    dWorldSetAutoDisableFlag(world_, scene.world.freezing ? 1 : 0);
    if (scene.world.ground) dGeomSetData(dCreatePlane(space_, 0, 0, 1, 0), &ground_);
  }

  ~OdeEngine() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  OdeEngine(const OdeEngine&) = delete;
  OdeEngine& operator=(const OdeEngine&) = delete;

  Status add(const sim::BoxDef& box) override {
    const sim::Vec3& size = box.size;
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    dMassSetBoxTotal(&mass, box.mass, size.x(), size.y(), size.z());
    dBodySetMass(body, &mass);
    dBodySetPosition(body, box.position.x(), box.position.y(), box.position.z());
    const dQuaternion q = {box.orientation.w, box.orientation.x, box.orientation.y, box.orientation.z};
    dBodySetQuaternion(body, q);
    dBodySetLinearVel(body, box.velocity.x(), box.velocity.y(), box.velocity.z());
    dBodySetAngularVel(body, box.spin.x(), box.spin.y(), box.spin.z());
    const dGeomID geom = dCreateBox(space_, size.x(), size.y(), size.z());
    dGeomSetBody(geom, body);
    dGeomSetData(geom, &materials_.emplace_back(box.material));
    if (box.is_static) dBodySetKinematic(body);
    if (box.frozen) dBodyDisable(body);
    bodies_.push_back(body);
    return {};
  }

  Status set_gravity(const sim::Vec3& gravity) override {
    dWorldSetGravity(world_, gravity.x(), gravity.y(), gravity.z());
    for (const dBodyID body : bodies_) dBodyEnable(body);
    return {};
  }

  Status step(double dt_s) override {
    dSpaceCollide(space_, this, collide);
    if (dWorldQuickStep(world_, dt_s) == 0) return cannot_finish("out of memory");
    dJointGroupEmpty(contacts_);
    return {};
  }

  [[nodiscard]] BodyState read(std::size_t row) const override {
    const dBodyID body = bodies_[row];
    const dReal* q = dBodyGetQuaternion(body);
    return {from_ode(dBodyGetPosition(body)),
            {q[0], q[1], q[2], q[3]},
            from_ode(dBodyGetLinearVel(body)),
            from_ode(dBodyGetAngularVel(body)),
            dBodyIsEnabled(body) == 0};
  }

 private:
  static sim::Vec3 from_ode(const dReal* v) { return {v[0], v[1], v[2]}; }

  static bool moves(dBodyID body) {
    return body != nullptr && dBodyIsEnabled(body) != 0 && dBodyIsKinematic(body) == 0;
  }

  static void collide(void* data, dGeomID a, dGeomID b) {
    auto* self = static_cast<OdeEngine*>(data);
    const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (!moves(body_a) && !moves(body_b)) return;
    const auto* material_a = static_cast<const sim::Material*>(dGeomGetData(a));
    const auto* material_b = static_cast<const sim::Material*>(dGeomGetData(b));
    std::array<dContact, kContactsMax> contacts{};
    const int count = dCollide(a, b, kContactsMax, &contacts[0].geom, sizeof(dContact));
    for (int k = 0; k < count; ++k) {
      dSurfaceParameters& surface = contacts[static_cast<std::size_t>(k)].surface;
      surface.mode = dContactBounce | dContactApprox1;
      surface.mu = std::sqrt(material_a->friction * material_b->friction);
      surface.bounce = std::max(material_a->restitution, material_b->restitution);
      surface.bounce_vel = kBounceSpeed;
      dJointAttach(dJointCreateContact(self->world_, self->contacts_, &contacts[static_cast<std::size_t>(k)]), body_a,
                   body_b);
    }
  }

  sim::Material ground_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> bodies_;
  std::deque<sim::Material> materials_;  // which geoms point to
};

}  // namespace

replay::EngineName engine_name() {
  const bool is_double = sizeof(dReal) == sizeof(double);
  return {"ODE", PEER_VERSION, is_double ? replay::kBinary64Bits : replay::kBinary32Bits};
}

std::unique_ptr<Engine> make_engine(const sim::SceneDef& scene) { return std::make_unique<OdeEngine>(scene); }

}  // namespace tumble::peers
