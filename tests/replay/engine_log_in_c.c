/* What a C program does with replay/import/engine_log_c.h; compiled as C99. */
#include "tests/support/engine_log_in_c.h"

#include <string.h>

#include "tumble/replay/engine_log_c.h"

static TumbleLogBody cube(uint64_t id, double height) {
  TumbleLogBody body;
  memset(&body, 0, sizeof body);
  body.id = id;
  body.size[0] = body.size[1] = body.size[2] = 1;
  body.mass = 2;
  body.friction = 0.4;
  body.state.position[2] = height;
  body.state.orientation[0] = 1;
  return body;
}

static TumbleLogStatus write_steps(TumbleLog* log) {
  const uint64_t words[2] = {7, 8};
  int k;
  for (k = 1; k <= 3; ++k) {
    TumbleLogBody body = cube(1, 5 - 0.5 * k);
    body.state.velocity[2] = -1;
    if (k == 2) {
      const TumbleLogBody thrown = cube(9, 3);
      tumble_log_throw(log, &thrown);
    }
    tumble_log_set_state(log, 1, &body.state);
    if (k >= 2) {
      body.state.frozen = 1;
      tumble_log_set_state(log, 9, &body.state);
    }
    tumble_log_set_phase_hashes(log, words, 2);
    tumble_log_end_step(log, 0.5);
  }
  return tumble_log_finish(log);
}

int write_log_in_c(const char* path, char* message, size_t room) {
  TumbleLog* log = tumble_log_new("C engine", "0.1");
  const TumbleLogBody first = cube(1, 5);
  TumbleLogStart start;
  TumbleLogStatus status;
  memset(&start, 0, sizeof start);
  start.scene = "two cubes";
  start.dt = 0.5;
  start.gravity[2] = -9.81;
  start.ground = 1;
  start.precision_bits = 24;
  start.phases = "collide,solve";
  start.planned_steps = 3;
  tumble_log_add_body(log, &first);
  tumble_log_begin(log, path, &start);
  status = write_steps(log);
  strncpy(message, tumble_log_message(log), room - 1);
  message[room - 1] = '\0';
  tumble_log_free(log);
  return status;
}

int misuse_log_in_c(char* message, size_t room) {
  TumbleLog* log = tumble_log_new("C engine", NULL);
  TumbleLogStatus first = tumble_log_end_step(log, 0.5);
  TumbleLogStatus second = tumble_log_finish(log);
  strncpy(message, tumble_log_message(log), room - 1);
  message[room - 1] = '\0';
  tumble_log_free(log);
  tumble_log_free(NULL);
  return first == second ? (int)first : -1;
}

int add_channel_in_c(int kind, int scope, char* message, size_t room) {
  TumbleLog* log = tumble_log_new("C engine", NULL);
  const TumbleLogStatus done = tumble_log_add_channel(log, "joint", (TumbleLogKind)kind, (TumbleLogScope)scope, NULL);
  strncpy(message, tumble_log_message(log), room - 1);
  message[room - 1] = '\0';
  tumble_log_free(log);
  return (int)done;
}
