// Records a Box3D world: all of the glue. Call step() where the engine called b3World_Step().
#pragma once
#include <vector>

#include "box3d/box3d.h"
#include "tumble_recorder.h"

class Box3dRecorder {
 public:
  TumbleRec* rec = nullptr;
  Box3dRecorder(b3WorldId world, TumbleRecDef def) : world_(world) {
    def.engine = "Box3D", def.precision_bits = 24;
    copy(b3World_GetGravity(world), def.gravity), rec = tumble_rec_create(&def);
  }
  ~Box3dRecorder() { tumble_rec_close(rec); }
  // Every body that moves; contacts with any other are contacts with the ground.
  void add(b3BodyId body, const char* name, b3Vec3 size, double friction) {
    bodies_.push_back(body);
    b3Body_SetUserData(body, reinterpret_cast<void*>(bodies_.size()));  // its id; 0: the ground
    TumbleRecBody out = {};
    out.id = bodies_.size(), out.name = name, out.mass = b3Body_GetMass(body), out.friction = friction;
    out.state = state_of(body), copy(size, out.size), tumble_rec_body(rec, &out);
  }
  void step(float dt, int substeps) {
    tumble_rec_step_begin(rec, dt);
    b3World_Step(world_, dt, substeps);
    for (const b3BodyId body : bodies_) {
      const TumbleRecState state = state_of(body);
      tumble_rec_state(rec, id_of(body), &state);
      tell_contacts(body);
    }
    tumble_rec_step_end(rec);
  }

 private:
  static void copy(b3Vec3 v, double* out) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }
  static uint64_t id_of(b3BodyId body) { return reinterpret_cast<uintptr_t>(b3Body_GetUserData(body)); }
  static TumbleRecState state_of(b3BodyId body) {
    const b3Pos at = b3Body_GetWorldCenter(body);
    const b3Quat q = b3Body_GetRotation(body);
    TumbleRecState state = {{at.x, at.y, at.z}, {q.s, q.v.x, q.v.y, q.v.z}, {0, 0, 0}, {0, 0, 0}, !b3Body_IsAwake(body)};
    copy(b3Body_GetLinearVelocity(body), state.velocity), copy(b3Body_GetAngularVelocity(body), state.spin);
    return state;
  }
  void tell_contacts(b3BodyId body) {  // those in which this body is shape A's, or the other one is the ground
    std::vector<b3ContactData> all(static_cast<size_t>(b3Body_GetContactCapacity(body)));
    all.resize(static_cast<size_t>(b3Body_GetContactData(body, all.data(), static_cast<int>(all.size()))));
    for (const b3ContactData& contact : all) {
      const uint64_t a = id_of(b3Shape_GetBody(contact.shapeIdA)), b = id_of(b3Shape_GetBody(contact.shapeIdB));
      for (int m = 0; (a == id_of(body) || a == 0) && m < contact.manifoldCount; ++m) {
        tell(contact.manifolds[m], a == 0 ? b : a, a == 0 ? 0 : b, a == 0 ? -1.0f : 1.0f, uint32_t(m));
      }
    }
  }
  void tell(const b3Manifold& from, uint64_t a, uint64_t b, float sign, uint32_t part) {
    TumbleRecPoint points[B3_MAX_MANIFOLD_POINTS] = {};
    TumbleRecContact out = {a, b, part, {0, 0, 0}, points, uint32_t(from.pointCount)};
    copy({sign * from.normal.x, sign * from.normal.y, sign * from.normal.z}, out.normal);
    const b3Pos at = b3Body_GetWorldCenter(bodies_[a - 1]);
    for (int k = 0; k < from.pointCount; ++k) {
      const b3Vec3 arm = sign < 0 ? from.points[k].anchorB : from.points[k].anchorA;
      copy({float(at.x) + arm.x, float(at.y) + arm.y, float(at.z) + arm.z}, points[k].position);
      points[k].depth = -from.points[k].separation, points[k].impulse = from.points[k].totalNormalImpulse;
    }
    tumble_rec_contact(rec, &out);
  }
  b3WorldId world_;
  std::vector<b3BodyId> bodies_;
};
