// Records a MuJoCo simulation: all of the glue. Call step() where the program called mj_step(). Joint positions and
// velocities, controls and activations are channels; every body is one of the log.
#pragma once
#include <mujoco/mujoco.h>

#include <algorithm>

#include "tumble_recorder.h"

class MujocoRecorder {
 public:
  TumbleRec* rec = nullptr;
  MujocoRecorder(const mjModel* m, mjData* d, TumbleRecDef def) : m_(m), d_(d) {
    def.engine = "MuJoCo", def.version = mj_versionString(), def.precision_bits = sizeof(mjtNum) == 4 ? 24 : 53;
    std::copy_n(m->opt.gravity, 3, def.gravity), rec = tumble_rec_create(&def), mj_forward(m, d);
    const char* const names[] = {"qpos", "qvel", "ctrl", "act"};
    for (int k = 0; k < 4; ++k) tumble_rec_channel(rec, names[k], TUMBLE_REC_WORLD, TUMBLE_REC_F64, &channels_[k]);
    for (int i = 1; i < m->nbody; ++i) add(i);  // body 0 is the world
  }
  ~MujocoRecorder() { tumble_rec_close(rec); }

  void step() {
    tumble_rec_step_begin(rec, m_->opt.timestep);
    mj_step(m_, d_), mj_kinematics(m_, d_), mj_comPos(m_, d_), mj_comVel(m_, d_);
    for (int i = 1; i < m_->nbody; ++i) {
      const TumbleRecState state = state_of(i);
      tumble_rec_state(rec, static_cast<uint64_t>(i), &state);
    }
    for (int i = 0; i < d_->ncon; ++i) tell(i);
    const mjtNum* const values[] = {d_->qpos, d_->qvel, d_->ctrl, d_->act};
    const int counts[] = {m_->nq, m_->nv, m_->nu, m_->na};
    for (int k = 0; k < 4; ++k) tumble_rec_value(rec, channels_[k], 0, 0, values[k], uint32_t(counts[k]));
    tumble_rec_step_end(rec);
  }

 private:
  void add(int i) {
    TumbleRecBody body = {};
    const int geom = m_->body_geomadr[i];  // its first; -1: none
    body.id = uint64_t(i), body.name = mj_id2name(m_, mjOBJ_BODY, i), body.mass = m_->body_mass[i];
    for (int k = 0; k < 3; ++k) body.size[k] = geom < 0 ? 0.01 : 2 * std::max(m_->geom_size[3 * geom + k], 1e-3);
    body.is_static = m_->body_dofnum[m_->body_rootid[i]] == 0, body.state = state_of(i);
    tumble_rec_body(rec, &body);
  }
  TumbleRecState state_of(int i) const {
    TumbleRecState state = {};
    mjtNum v[6];
    mj_objectVelocity(m_, d_, mjOBJ_BODY, i, v, 0);  // spin, then velocity
    std::copy_n(d_->xipos + 3 * i, 3, state.position), std::copy_n(d_->xquat + 4 * i, 4, state.orientation);
    std::copy_n(v, 3, state.spin), std::copy_n(v + 3, 3, state.velocity);
    return state;
  }
  void tell(int i) {
    const mjContact& c = d_->contact[i];
    const auto a = static_cast<uint64_t>(m_->geom_bodyid[c.geom1]), b = static_cast<uint64_t>(m_->geom_bodyid[c.geom2]);
    mjtNum force[6];
    mj_contactForce(m_, d_, i, force);
    TumbleRecPoint point = {{c.pos[0], c.pos[1], c.pos[2]}, -c.dist, force[0] * m_->opt.timestep};
    const double sign = a == 0 ? -1 : 1;  // MuJoCo's normal points from geom 1 to geom 2
    TumbleRecContact contact = {a == 0 ? b : a, a == 0 ? a : b, static_cast<uint32_t>(i), {0, 0, 0}, &point, 1};
    for (int k = 0; k < 3; ++k) contact.normal[k] = sign * c.frame[k];
    tumble_rec_contact(rec, &contact);
  }
  const mjModel* m_;
  mjData* d_;
  uint32_t channels_[4] = {};
};
