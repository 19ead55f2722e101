// Records a Bullet world: all of the glue. Call step() where the engine called world.stepSimulation().
#pragma once
#include <btBulletDynamicsCommon.h>

#include "tumble_recorder.h"
class BulletRecorder {
 public:
  TumbleRec* rec = nullptr;
  bool contacts = true;
  BulletRecorder(btDiscreteDynamicsWorld& world, TumbleRecDef def) : world_(world) {
    def.engine = "Bullet", def.precision_bits = sizeof(btScalar) == sizeof(float) ? 24 : 53;
    copy(world.getGravity(), def.gravity), rec = tumble_rec_create(&def);
  }
  ~BulletRecorder() { tumble_rec_close(rec); }
  void add(btRigidBody& body, const char* name) {  // before or after world.addRigidBody()
    TumbleRecBody out = {};
    btVector3 low, high;
    body.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
    copy(high - low, out.size);
    body.setUserIndex3(++last_id_), out.id = id_of(&body), out.name = name;  // 0: the ground
    out.is_static = body.isStaticObject(), out.mass = out.is_static ? 0 : 1 / body.getInvMass();
    out.friction = body.getFriction(), out.restitution = body.getRestitution(), out.state = state_of(body);
    tumble_rec_body(rec, &out);
  }
  void step(btScalar dt) {
    tumble_rec_step_begin(rec, dt);
    world_.stepSimulation(dt, 0);
    const btCollisionObjectArray& all = world_.getCollisionObjectArray();
    for (int i = 0; i < all.size(); ++i) {
      const btRigidBody* body = btRigidBody::upcast(all[i]);
      if (body == nullptr || body->isStaticObject() || body->getUserIndex3() <= 0) continue;
      const TumbleRecState state = state_of(*body);
      tumble_rec_state(rec, id_of(body), &state);
    }
    btDispatcher& pairs = *world_.getDispatcher();
    for (int i = 0; contacts && i < pairs.getNumManifolds(); ++i) tell(*pairs.getManifoldByIndexInternal(i));
    tumble_rec_step_end(rec);
  }

 private:
  static void copy(const btVector3& v, double* out) { out[0] = v.x(), out[1] = v.y(), out[2] = v.z(); }
  static uint64_t id_of(const btCollisionObject* o) {
    return o->getUserIndex3() > 0 ? uint64_t(o->getUserIndex3()) : 0;
  }
  static TumbleRecState state_of(const btRigidBody& body) {
    const btQuaternion q = body.getWorldTransform().getRotation();
    TumbleRecState state = {{0, 0, 0}, {q.w(), q.x(), q.y(), q.z()}, {0, 0, 0}, {0, 0, 0}, !body.isActive()};
    copy(body.getWorldTransform().getOrigin(), state.position), copy(body.getLinearVelocity(), state.velocity);
    copy(body.getAngularVelocity(), state.spin);
    return state;
  }
  void tell(const btPersistentManifold& m) {
    if (m.getNumContacts() == 0) return;  // before its bodies are looked at, which are in no cache
    const uint64_t a = id_of(m.getBody0()), b = id_of(m.getBody1());
    if (a == 0 && b == 0) return;           // of two that the recorder was not told of
    const btScalar sign = a == 0 ? 1 : -1;  // Bullet's normal points from body 1 to body 0
    TumbleRecPoint points[4];
    TumbleRecContact contact = {a == 0 ? b : a, a == 0 ? a : b, 0, {0, 0, 0}, points, 0};
    for (int k = 0; k < m.getNumContacts() && k < 4; ++k) {
      const btManifoldPoint& p = m.getContactPoint(k);
      copy(sign * p.m_normalWorldOnB, contact.normal), copy(p.getPositionWorldOnB(), points[k].position);
      points[contact.point_count++].depth = -p.getDistance(), points[k].impulse = p.getAppliedImpulse();
    }
    tumble_rec_contact(rec, &contact);
  }
  btDiscreteDynamicsWorld& world_;
  int last_id_ = 0;
};
