// Records an ODE world: all of the glue. Call begin_step() before dSpaceCollide(), contacts() in the near callback for
// the contacts of a pair, end_step() after the world's step.
#pragma once
#include <ode/ode.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "tumble_recorder.h"

class OdeRecorder {
 public:
  TumbleRec* rec = nullptr;
  OdeRecorder(dWorldID world, TumbleRecDef def) {
    dVector3 gravity;
    dWorldGetGravity(world, gravity);
    def.engine = "ODE", def.precision_bits = sizeof(dReal) == sizeof(float) ? 24 : 53;
    copy(gravity, 3, def.gravity), rec = tumble_rec_create(&def);
  }
  ~OdeRecorder() { tumble_rec_close(rec); }

  void add_box(dBodyID body, dGeomID box, const char* name, double friction) {
    TumbleRecBody out = {};
    dVector3 size;
    dMass mass;
    dGeomBoxGetLengths(box, size), dBodyGetMass(body, &mass);
    bodies_.push_back(body), ids_[body] = bodies_.size();
    out.id = bodies_.size(), out.name = name, out.mass = mass.mass, out.friction = friction;
    out.is_static = dBodyIsKinematic(body), out.state = state_of(body);
    copy(size, 3, out.size), tumble_rec_body(rec, &out);
  }

  void begin_step(double dt) { tumble_rec_step_begin(rec, dt); }
  void contacts(dGeomID geom_a, dGeomID geom_b, const dContact* found, int count) {
    const std::uint64_t a = id_of(dGeomGetBody(geom_a)), b = id_of(dGeomGetBody(geom_b));
    if (count == 0 || (a == 0 && b == 0)) return;  // of two that the recorder was not told of
    const double sign = a == 0 ? 1 : -1;           // ODE's normal points into geom 1
    std::vector<TumbleRecPoint> points(static_cast<std::size_t>(count));
    TumbleRecContact out = {a == 0 ? b : a, a == 0 ? a : b, 0, {0, 0, 0}, points.data(), 0};
    for (int k = 0; k < count; ++k) {
      for (int i = 0; i < 3; ++i) out.normal[i] = sign * found[k].geom.normal[i];
      copy(found[k].geom.pos, 3, points[out.point_count].position);
      points[out.point_count++].depth = found[k].geom.depth;  // impulses are known later: dJointSetFeedback()
    }
    tumble_rec_contact(rec, &out);
  }
  void end_step() {
    for (const dBodyID body : bodies_) {
      const TumbleRecState state = state_of(body);
      tumble_rec_state(rec, id_of(body), &state);
    }
    tumble_rec_step_end(rec);
  }
  std::uint64_t id_of(dBodyID body) const {  // 0: the ground, and bodies that were not added
    const auto known = ids_.find(body);
    return known == ids_.end() ? 0 : known->second;
  }

 private:
  static void copy(const dReal* from, int count, double* to) { std::copy_n(from, count, to); }
  static TumbleRecState state_of(dBodyID body) {
    TumbleRecState state = {};
    copy(dBodyGetPosition(body), 3, state.position), copy(dBodyGetQuaternion(body), 4, state.orientation);
    copy(dBodyGetLinearVel(body), 3, state.velocity), copy(dBodyGetAngularVel(body), 3, state.spin);
    state.asleep = dBodyIsEnabled(body) == 0;
    return state;
  }
  std::vector<dBodyID> bodies_;
  std::map<dBodyID, std::uint64_t> ids_;
};
