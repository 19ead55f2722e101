// Records a Jolt world: all of the glue. Call step() where the engine called PhysicsSystem::Update().
#pragma once
#include <Jolt/Jolt.h>
#include <Jolt/Physics/Body/BodyLock.h>
#include <Jolt/Physics/PhysicsSystem.h>

#include <vector>

#include "tumble_recorder.h"

class JoltRecorder {
 public:
  TumbleRec* rec = nullptr;
  JoltRecorder(JPH::PhysicsSystem& system, TumbleRecDef def) : system_(system) {
    def.engine = "Jolt", def.precision_bits = sizeof(JPH::Real) == sizeof(float) ? 24 : 53;
    copy(system.GetGravity(), def.gravity), rec = tumble_rec_create(&def);
  }
  ~JoltRecorder() { tumble_rec_close(rec); }

  void add(JPH::BodyID id, const char* name) {
    const JPH::BodyLockRead lock(system_.GetBodyLockInterface(), id);
    const JPH::Body& body = lock.GetBody();
    TumbleRecBody out = {};
    out.id = id_of(id), out.name = name, out.is_static = body.IsStatic();
    copy(body.GetShape()->GetLocalBounds().GetSize(), out.size);
    out.mass = !body.IsDynamic() ? 0 : 1 / body.GetMotionProperties()->GetInverseMass();
    out.friction = body.GetFriction(), out.restitution = body.GetRestitution(), out.state = state_of(body);
    bodies_.push_back(id), tumble_rec_body(rec, &out);
  }
  void remove(JPH::BodyID id) { std::erase(bodies_, id), tumble_rec_remove(rec, id_of(id)); }

  JPH::EPhysicsUpdateError step(float dt, int substeps, JPH::TempAllocator* memory, JPH::JobSystem* jobs) {
    tumble_rec_step_begin(rec, dt);
    const JPH::EPhysicsUpdateError error = system_.Update(dt, substeps, memory, jobs);
    for (const JPH::BodyID id : bodies_) {
      const JPH::BodyLockRead lock(system_.GetBodyLockInterface(), id);
      if (lock.GetBody().IsStatic()) continue;
      const TumbleRecState state = state_of(lock.GetBody());
      tumble_rec_state(rec, id_of(id), &state);
    }
    tumble_rec_step_end(rec);
    return error;
  }

 private:
  template <class V>  // Vec3, or RVec3 of doubles
  static void copy(const V& v, double* out) { out[0] = v.GetX(), out[1] = v.GetY(), out[2] = v.GetZ(); }
  static uint64_t id_of(JPH::BodyID id) { return uint64_t(id.GetIndexAndSequenceNumber()) + 1; }
  static TumbleRecState state_of(const JPH::Body& body) {
    const JPH::Quat q = body.GetRotation();
    TumbleRecState state = {{0, 0, 0}, {q.GetW(), q.GetX(), q.GetY(), q.GetZ()}, {0, 0, 0}, {0, 0, 0}, !body.IsActive()};
    copy(body.GetCenterOfMassPosition(), state.position), copy(body.GetLinearVelocity(), state.velocity);
    copy(body.GetAngularVelocity(), state.spin);
    return state;
  }
  JPH::PhysicsSystem& system_;
  std::vector<JPH::BodyID> bodies_;
};
