/* engine OUT.tumblestream: a ball falls for 20 steps; exits with 1 where the recorder reports an error. */
#include <stdio.h>

#include "tumble_probe.h"
#include "tumble_recorder.h"

int main(int argc, char** argv) {
  TumbleRecDef def = {0};
  TumbleRecBody ball = {0};
  TumbleRec* rec;
  int step, failed;
  if (argc != 2) return 2;
  def.engine = "installed";
  def.path = argv[1];
  def.precision_bits = 53;
  def.gravity[2] = -10;
  rec = tumble_rec_create(&def);
  ball.id = 1;
  ball.shape = TUMBLE_REC_SPHERE;
  ball.size[0] = 0.5;
  ball.mass = 1;
  ball.state.position[2] = 10;
  ball.state.orientation[0] = 1;
  tumble_rec_body(rec, &ball);
  for (step = 1; step <= 20; ++step) {
    tumble_probes_step(&tumble_probes, (uint64_t)step);
    tumble_rec_step_begin(rec, 0.01);
    ball.state.velocity[2] -= 0.1;
    ball.state.position[2] += 0.01 * ball.state.velocity[2];
    tumble_rec_state(rec, 1, &ball.state);
    tumble_rec_step_end(rec);
  }
  failed = tumble_rec_close(rec) != TUMBLE_REC_OK;
  if (failed) fprintf(stderr, "engine: the recorder reported an error\n");
  return failed;
}
