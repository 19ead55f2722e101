#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "replay/recorder/tumble_recorder.h"
#include "tests/support/program.h"

/// An engine whose y points up and that computes in floats, recorded by the recorder.
namespace tumble::test {

inline bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

/// One body that falls, 20 steps of 0.01 s, in the engine's axes.
struct FloatEngine {
  const char* name = "yup";
  float gravity = -9.81F;       // by which it falls, along y
  double told_gravity = -9.81;  // and what it says
  double told_dt = 0.01;
  double velocity_factor = 1;
  double contact_y = 30;  // of the contact; NaN: none
  double depth = 0.5;
  double normal_length = 1;
  double metres = 1;
  int left_handed = 0;
  char up = 'y';
  float spin = 0;  // rad/s about x
  double spin_factor = 1;
  bool scalar_last = false;
  bool sphere = false;
  float start = 10;  // of y
};

inline void record(const Workshop& shop, const std::string& name, const FloatEngine& e) {
  const std::string path = shop.path(name + ".tumblestream");
  TumbleRecDef def = {};
  def.engine = e.name;
  def.path = path.c_str();
  def.precision_bits = 24;
  def.up = e.up;
  def.left_handed = e.left_handed;
  def.metres = e.metres;
  def.gravity[e.up == 'y' ? 1 : 2] = e.told_gravity;
  def.phases = "move,solve";
  def.ground = e.sphere ? 1 : 0;
  TumbleRec* rec = tumble_rec_create(&def);
  TumbleRecBody body = {};
  body.id = 1;
  body.name = "ball";
  body.shape = e.sphere ? TUMBLE_REC_SPHERE : TUMBLE_REC_BOX;
  for (double& edge : body.size) edge = e.sphere ? 0.5 : 1;
  body.mass = 2;
  float y = e.start, v = 0;
  double angle = 0;
  const auto state = [&] {
    TumbleRecState s = {};
    s.position[0] = 1;
    s.position[1] = y;
    s.position[2] = 3;
    const double half = angle / 2;
    s.orientation[0] = e.scalar_last ? std::sin(half) : std::cos(half);
    s.orientation[e.scalar_last ? 0 : 1] = std::sin(half);
    if (e.scalar_last) s.orientation[3] = std::cos(half);
    s.velocity[1] = v * e.velocity_factor;
    s.spin[0] = e.spin * e.spin_factor;
    return s;
  };
  body.state = state();
  tumble_rec_body(rec, &body);
  for (int k = 1; k <= 20; ++k) {
    v += e.gravity * 0.01F;
    y += v * 0.01F;
    angle += e.spin * 0.01;
    tumble_rec_step_begin(rec, e.told_dt);
    const TumbleRecState now = state();
    tumble_rec_state(rec, 1, &now);
    tumble_rec_phase_hash(rec, 0, static_cast<std::uint64_t>(std::lround(y * 1e6F)));
    tumble_rec_phase_hash(rec, 1, 7);
    const TumbleRecPoint point = {{10, e.contact_y, 20}, e.depth, 2};
    const TumbleRecContact contact = {1, 0, 0, {0, e.normal_length, 0}, &point, 1};
    if (!std::isnan(e.contact_y)) tumble_rec_contact(rec, &contact);
    tumble_rec_step_end(rec);
  }
  tumble_rec_finish(rec);
  ASSERT_STREQ(tumble_rec_message(rec), "");
  tumble_rec_close(rec);
}

/// With what `import` says.
inline std::string recorded(const Workshop& shop, const std::string& name, const FloatEngine& engine = {}) {
  record(shop, name, engine);
  const Outcome outcome = shop.run({"import", name + ".tumblestream"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  return outcome.out + outcome.err;
}

inline FloatEngine heavier() {
  FloatEngine engine;
  engine.gravity = -9.82F;
  return engine;
}

inline void write_project(const Workshop& shop, const std::string& stream) {
  shop.write("tumble.toml", "[engine]\nrun = 'cp " + shop.path(stream) + ".tumblestream {log}'\n");
}

}  // namespace tumble::test
