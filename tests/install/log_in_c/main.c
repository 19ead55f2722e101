/* A body in free fall, written as a log: log_in_c FALL.tumble */
#include <stdio.h>

#include "tumble/replay/engine_log_c.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const double dt = 0.01, g = -9.81;
  TumbleLog* log = tumble_log_new("falling", "1");
  TumbleLogBody body = {.id = 1, .size = {1, 1, 1}, .mass = 2};
  body.state.orientation[0] = 1;
  tumble_log_add_body(log, &body);
  const TumbleLogStart start = {.dt = dt, .gravity = {0, 0, g}, .precision_bits = 53};
  tumble_log_begin(log, argv[1], &start);
  for (int k = 0; k < 20; ++k) {
    body.state.velocity[2] += g * dt;
    body.state.position[2] += body.state.velocity[2] * dt;
    tumble_log_set_state(log, 1, &body.state);
    tumble_log_end_step(log, dt);
  }
  const TumbleLogStatus status = tumble_log_finish(log);
  if (status != TUMBLE_OK) fprintf(stderr, "%s\n", tumble_log_message(log));
  tumble_log_free(log);
  return (int)status;
}
