#pragma once

/* The log of another engine, written from C (C99) or from any language that calls C: engine_log.h has what each part
 * means. SI units, z up, orientations (w, x, y, z), spins about world axes.
 *
 *   TumbleLog* log = tumble_log_new("my engine", "1.2");
 *   tumble_log_add_body(log, &body);                 each body of the start, in any order
 *   tumble_log_begin(log, "session.tumble", &start);
 *   each step: tumble_log_throw() and other inputs, tumble_log_set_state() of every body, tumble_log_end_step()
 *   tumble_log_finish(log);
 *   tumble_log_free(log);
 *
 * Every function but _new, _message and _free returns TUMBLE_OK or the kind of error; tumble_log_message() then says
 * what was found and what was wanted. After an error every further call returns the same one, so a program may look at
 * the last call alone. No function may be called for one log from two threads at once. */

/* The names of C: NOLINTBEGIN(modernize-deprecated-headers,readability-identifier-naming) */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct TumbleLog TumbleLog;

/* The numbers are the exit codes of the program `tumble`. */
typedef enum TumbleLogStatus {
  TUMBLE_OK = 0,
  TUMBLE_BAD_INPUT = 2,    /* a value, an id or an order of calls that cannot be */
  TUMBLE_CANNOT_FINISH = 4 /* disk or memory */
} TumbleLogStatus;

typedef struct TumbleLogState {
  double position[3];    /* m, centre of mass */
  double orientation[4]; /* unit quaternion w, x, y, z; of another length by more than 0.01: an error */
  double velocity[3];    /* m/s */
  double spin[3];        /* rad/s, world axes */
  int frozen;            /* the engine lets it sleep */
} TumbleLogState;

typedef struct TumbleLogBody {
  uint64_t id;    /* 1 … 2^53 - 1, never used again */
  double size[3]; /* m, edge lengths of its box */
  double mass;    /* kg */
  int is_static;
  double friction;
  double restitution;
  int in_grid;          /* the metric column_spread wants row and column of bodies that lie in a grid; 0: none */
  uint32_t row, column; /* read only with in_grid */
  TumbleLogState state;
} TumbleLogBody;

typedef struct TumbleLogStart {
  const char* scene;      /* a name for reports; NULL: "session" */
  double dt;              /* s, of the first step */
  double gravity[3];      /* m/s^2 */
  int ground;             /* the half-space z <= 0 is solid */
  int precision_bits;     /* 24: the engine computes in float, 53: in double */
  const char* phases;     /* names with commas between, for tumble_log_set_phase_hashes(); NULL: none */
  uint64_t planned_steps; /* 0: not known */
} TumbleLogStart;

/* NULL only without memory. version may be NULL. */
TumbleLog* tumble_log_new(const char* engine, const char* version);

/* What went wrong first; "" if nothing did. Good until tumble_log_free(). */
const char* tumble_log_message(const TumbleLog* log);

TumbleLogStatus tumble_log_add_body(TumbleLog* log, const TumbleLogBody* body);
TumbleLogStatus tumble_log_begin(TumbleLog* log, const char* path, const TumbleLogStart* start);

/* Inputs: done to the bodies before the coming step, and before its states. */
TumbleLogStatus tumble_log_throw(TumbleLog* log, const TumbleLogBody* body);
TumbleLogStatus tumble_log_remove(TumbleLog* log, uint64_t id);
TumbleLogStatus tumble_log_push(TumbleLog* log, uint64_t id, const double impulse[3]); /* N s, at the centre */
TumbleLogStatus tumble_log_set_velocity(TumbleLog* log, uint64_t id, const double velocity[3], const double spin[3]);
TumbleLogStatus tumble_log_set_gravity(TumbleLog* log, const double gravity[3]);

TumbleLogStatus tumble_log_set_state(TumbleLog* log, uint64_t id, const TumbleLogState* state);
TumbleLogStatus tumble_log_set_phase_hashes(TumbleLog* log, const uint64_t* words, size_t count);
TumbleLogStatus tumble_log_end_step(TumbleLog* log, double dt);
TumbleLogStatus tumble_log_finish(TumbleLog* log);

/* Without tumble_log_finish() the log reads as torn after its last whole chunk. NULL is fine. */
void tumble_log_free(TumbleLog* log);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-deprecated-headers,readability-identifier-naming) */
