// Bullet as its documentation sets it up: a discrete world, a dynamic AABB tree, sequential impulses, sleeping on.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <vector>

#include "bench/peers/engine.h"

namespace tumble::peers {
namespace {

btVector3 to_bullet(const sim::Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

sim::Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

btScalar friction_of(const btCollisionObject* a, const btCollisionObject* b) {
  return std::sqrt(a->getFriction() * b->getFriction());
}

btScalar restitution_of(const btCollisionObject* a, const btCollisionObject* b) {
  return std::max(a->getRestitution(), b->getRestitution());
}

class BulletEngine : public Engine {
 public:
  explicit BulletEngine(const sim::SceneDef& scene) : dispatcher_(&configuration_) {
    gCalculateCombinedFrictionCallback = friction_of;
    gCalculateCombinedRestitutionCallback = restitution_of;
    world_.setGravity(to_bullet(scene.world.gravity));
    if (!scene.world.ground) return;
    shapes_.push_back(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), 0));
    add_body(0, btTransform::getIdentity(), scene.world.ground_material);
  }

  ~BulletEngine() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  BulletEngine(const BulletEngine&) = delete;
  BulletEngine& operator=(const BulletEngine&) = delete;

  Status add(const sim::BoxDef& box) override {
    shapes_.push_back(std::make_unique<btBoxShape>(to_bullet(box.size) / 2));
    btTransform place;
    const sim::Quat& q = box.orientation;
    place.setRotation({static_cast<btScalar>(q.x), static_cast<btScalar>(q.y), static_cast<btScalar>(q.z),
                       static_cast<btScalar>(q.w)});
    place.setOrigin(to_bullet(box.position));
    btRigidBody& body = add_body(box.is_static ? 0 : box.mass, place, box.material);
    body.setLinearVelocity(to_bullet(box.velocity));
    body.setAngularVelocity(to_bullet(box.spin));
    if (box.frozen) body.setActivationState(ISLAND_SLEEPING);
    boxes_.push_back(&body);
    return {};
  }

  Status set_gravity(const sim::Vec3& gravity) override {
    world_.setGravity(to_bullet(gravity));
    for (btRigidBody* body : boxes_) body->activate();
    return {};
  }

  Status step(double dt_s) override {
    world_.stepSimulation(static_cast<btScalar>(dt_s), 0);
    return {};
  }

  [[nodiscard]] BodyState read(std::size_t row) const override {
    const btRigidBody& body = *boxes_[row];
    const btQuaternion q = body.getWorldTransform().getRotation();
    return {from_bullet(body.getWorldTransform().getOrigin()),
            {q.w(), q.x(), q.y(), q.z()},
            from_bullet(body.getLinearVelocity()),
            from_bullet(body.getAngularVelocity()),
            !body.isStaticObject() && body.getActivationState() == ISLAND_SLEEPING};
  }

 private:
  btRigidBody& add_body(double mass, const btTransform& place, const sim::Material& material) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shapes_.back()->calculateLocalInertia(static_cast<btScalar>(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, shapes_.back().get(), inertia);
    info.m_startWorldTransform = place;
    info.m_friction = static_cast<btScalar>(material.friction);
    info.m_restitution = static_cast<btScalar>(material.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  // the ground's, if there is one, then the boxes'
  std::vector<btRigidBody*> boxes_;
};

}  // namespace

replay::EngineName engine_name() {
  const std::string version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
  return {"Bullet", version, sizeof(btScalar) == sizeof(float) ? replay::kBinary32Bits : replay::kBinary64Bits};
}

std::unique_ptr<Engine> make_engine(const sim::SceneDef& scene) { return std::make_unique<BulletEngine>(scene); }

}  // namespace tumble::peers
