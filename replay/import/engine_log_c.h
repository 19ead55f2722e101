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
 * the last call alone. A call that is refused (TUMBLE_BAD_INPUT) after tumble_log_begin() completes the log at once: it
 * has the steps before, and keeps why it ends. No function may be called for one log from two threads at once. */

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
  uint64_t id;    /* 1 … 2^53 - 1; of a removed body: only for the same one, which comes back */
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
  const char* phases;     /* names that differ, with commas between, for tumble_log_set_phase_hashes(); NULL: none */
  uint64_t planned_steps; /* 0: not known */
} TumbleLogStart;

/* A named value of the engine beside the states of its bodies: a joint angle, a control, a random seed. */
typedef enum TumbleLogKind {
  TUMBLE_FLOAT64 = 0,
  TUMBLE_FLOAT32 = 1,
  TUMBLE_INT64 = 2,
  TUMBLE_UINT64 = 3,
  TUMBLE_BYTES = 4,
  TUMBLE_TEXT = 5
} TumbleLogKind;

typedef enum TumbleLogScope {
  TUMBLE_WORLD = 0, /* at most one value a step */
  TUMBLE_BODY = 1,  /* a body and step */
  TUMBLE_PAIR = 2   /* a pair of bodies and step */
} TumbleLogScope;

typedef struct TumbleLogContact {
  uint64_t a, b;      /* ids; b 0: the ground */
  double position[3]; /* m, world */
  double normal[3];   /* from a to b */
  double depth;       /* m; above 0: the bodies overlap */
  double impulse;     /* N s along the normal, in this step */
} TumbleLogContact;

typedef enum TumbleLogShapeKind {
  TUMBLE_SPHERE = 1,
  TUMBLE_CAPSULE = 2,
  TUMBLE_CYLINDER = 3,
  TUMBLE_HULL = 4, /* the convex hull of the points */
  TUMBLE_MESH = 5
} TumbleLogShapeKind;

typedef struct TumbleLogShape {
  int kind;
  int axis;             /* of capsule and cylinder: 0 x, 1 y, 2 z, in the body's axes */
  double radius;        /* m */
  double half_length;   /* m, of a capsule without its caps */
  const double* points; /* m, x y z each, around the centre of mass; of hull and mesh */
  size_t point_count;
  const uint32_t* triangles; /* three points each; of a mesh */
  size_t triangle_count;
} TumbleLogShape;

/* NULL only without memory. version may be NULL. */
TumbleLog* tumble_log_new(const char* engine, const char* version);

/* What went wrong first; "" if nothing did. Good until tumble_log_free(). */
const char* tumble_log_message(const TumbleLog* log);

TumbleLogStatus tumble_log_add_body(TumbleLog* log, const TumbleLogBody* body);

/* Declares a channel, before tumble_log_begin(). unit may be NULL. Channels are numbered 0, 1, … as they are declared.
 */
TumbleLogStatus tumble_log_add_channel(TumbleLog* log, const char* name, TumbleLogKind kind, TumbleLogScope scope,
                                       const char* unit);

/* Names a body of the start (before tumble_log_begin()) or one that is thrown in the coming step. NULL: no name, a box.
 * A shape is stored once, however many bodies have it. */
TumbleLogStatus tumble_log_describe_body(TumbleLog* log, uint64_t id, const char* name, const TumbleLogShape* shape);

TumbleLogStatus tumble_log_begin(TumbleLog* log, const char* path, const TumbleLogStart* start);

/* Inputs: done to the bodies before the coming step, and before its states. */
TumbleLogStatus tumble_log_throw(TumbleLog* log, const TumbleLogBody* body);
TumbleLogStatus tumble_log_remove(TumbleLog* log, uint64_t id);
TumbleLogStatus tumble_log_push(TumbleLog* log, uint64_t id, const double impulse[3]); /* N s, at the centre */
TumbleLogStatus tumble_log_set_velocity(TumbleLog* log, uint64_t id, const double velocity[3], const double spin[3]);
TumbleLogStatus tumble_log_set_gravity(TumbleLog* log, const double gravity[3]);

TumbleLogStatus tumble_log_set_state(TumbleLog* log, uint64_t id, const TumbleLogState* state);
TumbleLogStatus tumble_log_set_phase_hashes(TumbleLog* log, const uint64_t* words, size_t count);

/* Values of channels after the coming step; before tumble_log_begin(): of the start. a and b: 0 where the scope of the
 * channel has none. Texts and bytes are copied. */
TumbleLogStatus tumble_log_set_f64(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, double value);
TumbleLogStatus tumble_log_set_f32(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, float value);
TumbleLogStatus tumble_log_set_i64(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, int64_t value);
TumbleLogStatus tumble_log_set_u64(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, uint64_t value);
TumbleLogStatus tumble_log_set_bytes(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, const void* bytes,
                                     size_t count);
TumbleLogStatus tumble_log_set_text(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, const char* text);

/* Of the coming step: a contact point; a note for people; the engine's own state in its own bytes, which no comparison
 * reads. */
TumbleLogStatus tumble_log_contact(TumbleLog* log, const TumbleLogContact* contact);
TumbleLogStatus tumble_log_note(TumbleLog* log, const char* text);
TumbleLogStatus tumble_log_snapshot(TumbleLog* log, const void* bytes, size_t count);
TumbleLogStatus tumble_log_named_snapshot(TumbleLog* log, const char* name, const void* bytes, size_t count);

TumbleLogStatus tumble_log_end_step(TumbleLog* log, double dt);
TumbleLogStatus tumble_log_finish(TumbleLog* log);

/* Without tumble_log_finish() the log reads as torn after its last whole chunk, unless a call was refused. NULL is
 * fine.
 */
void tumble_log_free(TumbleLog* log);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-deprecated-headers,readability-identifier-naming) */
