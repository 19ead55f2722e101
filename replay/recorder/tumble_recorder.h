#pragma once

/* A flight recorder for any physics engine: this header and tumble_recorder.c, C99, nothing else. Copy both into the
 * engine. The recorder writes a stream (docs/recorder_stream.md), which `tumble import` turns into a log that diff,
 * measure, dump, render, check and bisect read. docs/your_engine.md is the tutorial.
 *
 *   TumbleRecDef def = {0};
 *   def.engine = "mine"; def.path = "session.tumblestream"; def.precision_bits = 24; def.gravity[2] = -9.81;
 *   TumbleRec* rec = tumble_rec_create(&def);
 *   tumble_rec_body(rec, &body);                      every body of the start
 *   each step:
 *     tumble_rec_body(), tumble_rec_push() …          what was done to the bodies before it: inputs
 *     tumble_rec_step_begin(rec, dt);
 *     tumble_rec_state(rec, id, &state);              every body that moves
 *     tumble_rec_contact(), tumble_rec_value() …      what else the engine computed
 *     tumble_rec_step_end(rec);                       written: a crash from here on costs the next step at most
 *   tumble_rec_close(rec);
 *
 * Lengths in the engine's unit, vectors in its axes (def.up, def.metres); times in s, angular velocity in rad/s about
 * world axes, orientations w, x, y, z. Every double is kept to the bit; numbers that are floats take 4 bytes. So is
 * what no world would hold, as a mass of -1 or a place that is NaN, which a table of `import` may not have: the log
 * keeps it beside a scene that is cut (docs/recorder_stream.md), and no golden is made of it.
 *
 * What contradicts itself is TUMBLE_REC_BAD_CALL: a second state of a body or a second value of a channel and its
 * bodies in one step, a state, contact, value or input of a body that does not exist (not added, or removed), a contact
 * of a body with itself, a state, contact or value between two steps, no state of a body that moves. Two contacts of
 * one pair and part are kept: more points. Parts, and contacts without points, are a channel of the log.
 *
 * Functions return TUMBLE_REC_OK or the kind of error, never abort, and accept NULL for rec. After an error, every
 * further call returns the same one and tumble_rec_message() says what was found and wanted; what was written before
 * stays, and the message stands behind it in the stream, where `tumble import` reads it. One thread at a time may use a
 * recorder, and one thread only from step_begin to step_end: a call of another thread is TUMBLE_REC_TWO_THREADS. */

/* The names of C: NOLINTBEGIN(modernize-deprecated-headers,readability-identifier-naming,modernize-use-using) */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct TumbleRec TumbleRec;

typedef enum TumbleRecStatus {
  TUMBLE_REC_OK = 0,
  TUMBLE_REC_DIFFERENT = 1,    /* verify: this call gave the first value that differs; recording goes on */
  TUMBLE_REC_BAD_CALL = 2,     /* a value, an id or an order of calls that cannot be */
  TUMBLE_REC_BAD_STREAM = 3,   /* the stream to verify against is damaged or none */
  TUMBLE_REC_CANNOT_WRITE = 4, /* disk, or the callback said so */
  TUMBLE_REC_NO_MEMORY = 5,
  TUMBLE_REC_TWO_THREADS = 6
} TumbleRecStatus;

typedef enum TumbleRecShape {
  TUMBLE_REC_BOX = 0,      /* size: three edge lengths */
  TUMBLE_REC_SPHERE = 1,   /* size[0]: radius */
  TUMBLE_REC_CAPSULE = 2,  /* size[0]: radius, size[1]: length of its cylinder, along the body's z */
  TUMBLE_REC_CYLINDER = 3, /* size[0]: radius, size[1]: length, along the body's z */
  TUMBLE_REC_HULL = 4,     /* mesh_hash: a name for the surface; size: edge lengths of a box around it */
  TUMBLE_REC_MESH = 5      /* likewise */
} TumbleRecShape;

typedef enum TumbleRecScope { TUMBLE_REC_WORLD = 0, TUMBLE_REC_OF_BODY = 1, TUMBLE_REC_OF_PAIR = 2 } TumbleRecScope;

typedef enum TumbleRecType {
  TUMBLE_REC_F32 = 0,
  TUMBLE_REC_F64 = 1,
  TUMBLE_REC_I32 = 2,
  TUMBLE_REC_I64 = 3,
  TUMBLE_REC_U32 = 4,
  TUMBLE_REC_U64 = 5,
  TUMBLE_REC_BYTES = 6,
  TUMBLE_REC_TEXT = 7 /* UTF-8 */
} TumbleRecType;

typedef struct TumbleRecState {
  double position[3];    /* centre of mass */
  double orientation[4]; /* unit quaternion w, x, y, z, body to world */
  double velocity[3];
  double spin[3]; /* angular velocity, rad/s, world axes */
  /* The engine lets it rest: it needs no further state until it wakes. A push or a velocity wakes it, and the step then
   * needs its state, which may be asleep again. Nothing else does, neither gravity nor a support that is removed: an
   * engine that wakes it for these tells its state. */
  int asleep;
} TumbleRecState;

typedef struct TumbleRecBody {
  uint64_t id;      /* 1 … 2^53 - 1, never used again */
  const char* name; /* NULL: none */
  TumbleRecShape shape;
  double size[3];
  uint64_t mesh_hash;
  double mass; /* kg */
  int is_static;
  double friction, restitution;
  TumbleRecState state;
} TumbleRecBody;

typedef struct TumbleRecPoint {
  double position[3];
  double depth;   /* of overlap; below 0: apart */
  double impulse; /* along the normal, N s (in the engine's unit of length) */
} TumbleRecPoint;

typedef struct TumbleRecContact {
  uint64_t a, b;    /* bodies; b = 0: the ground */
  uint32_t part;    /* tells contacts of one pair apart: of sub-shapes, say */
  double normal[3]; /* from a to b */
  const TumbleRecPoint* points;
  uint32_t point_count;
} TumbleRecContact;

/* The first difference from an earlier stream. */
typedef struct TumbleRecDifference {
  uint64_t step;
  const char* part;     /* "state", "body", "input", "contact", "phase hash", "channel", "note", "snapshot", "order" */
  uint64_t body, other; /* 0: none */
  const char* field;    /* "position.x", "impulse of point 2", or the name of a channel or phase */
  const char* earlier;  /* the value of the earlier stream, with all digits; "absent" */
  const char* now;
  const char* text; /* all of it as a sentence */
} TumbleRecDifference;

/* Takes the next bytes of the stream; not 0: it could not. */
typedef int (*TumbleRecWrite)(void* user, const void* bytes, size_t size);

typedef struct TumbleRecDef {
  const char* engine; /* its name */
  const char* version;
  const char* scene;  /* a name for reports; NULL: "session" */
  int precision_bits; /* 24: the engine computes in float, 53: in double */
  char up;            /* 'x', 'y' or 'z'; 0: 'z' */
  int left_handed;
  double metres; /* per unit of length; 0: 1 */
  double gravity[3];
  int ground;         /* the half-space below 0 along `up` is solid */
  const char* phases; /* names that differ, with commas between, for tumble_rec_phase_hash(); NULL: none */

  /* Where the stream goes: a file, or write(), or memory that holds the last ring_s seconds until tumble_rec_dump().
   * Nowhere is fine with `verify`. A file that is there and no stream is not overwritten. */
  const char* path; /* and beside it, while it is written, PATH.tail: see steps_a_write */
  TumbleRecWrite write;
  void* write_user;
  double ring_s;
  int hashes_only; /* a few words a step instead of values: to compare, not to draw */

  uint32_t rollback_steps; /* how far tumble_rec_rewind() may go back */

  /* An earlier stream to compare with, while the engine runs. on_difference is called once, by the call that gives
   * the first value that differs: set a breakpoint there. It must not call the recorder. */
  const char* verify;
  void (*on_difference)(void* user, const TumbleRecDifference* difference);
  void* difference_user;

  /* How steps reach the file of `path`. 0: first to PATH.tail, 1 MiB of memory that the system keeps whatever happens
   * to the process, and from there to the file, at least once a second; tumble_rec_close() removes the tail. A crash
   * costs the open step and no more, as long as the two files stay together. Without mmap (Windows): as 1.
   * 1: each step when it ends, in one file. n: n steps together; a crash costs up to n, unless its handler calls
   * tumble_rec_flush(). With write() instead of a path, 0 is 1. */
  uint32_t steps_a_write;
} TumbleRecDef;

/* NULL only without memory. */
TumbleRec* tumble_rec_create(const TumbleRecDef* def);

/* Inputs of the coming step: between steps. A body before the first step belongs to the start, unless a push, a removal
 * or a velocity came before it. */
TumbleRecStatus tumble_rec_body(TumbleRec* rec, const TumbleRecBody* body);
/* The surface of the bodies with this mesh_hash, to draw them: points x y z in the body's axes around its centre of
 * mass; triangles: three places of points each, none for a hull. Told once, at any time before or after them. */
TumbleRecStatus tumble_rec_mesh(TumbleRec* rec, uint64_t mesh_hash, const double* points, uint32_t point_count,
                                const uint32_t* triangles, uint32_t triangle_count);
TumbleRecStatus tumble_rec_remove(TumbleRec* rec, uint64_t id);
TumbleRecStatus tumble_rec_push(TumbleRec* rec, uint64_t id, const double impulse[3]); /* at the centre */
TumbleRecStatus tumble_rec_set_velocity(TumbleRec* rec, uint64_t id, const double velocity[3], const double spin[3]);
TumbleRecStatus tumble_rec_set_gravity(TumbleRec* rec, const double gravity[3]);
/* Any other input by its name, in the engine's own bytes: a control, a command. body 0: of the world. */
TumbleRecStatus tumble_rec_input(TumbleRec* rec, const char* name, uint64_t body, const void* bytes, size_t size);

TumbleRecStatus tumble_rec_step_begin(TumbleRec* rec, double dt_s);
TumbleRecStatus tumble_rec_state(TumbleRec* rec, uint64_t id, const TumbleRecState* state);
TumbleRecStatus tumble_rec_contact(TumbleRec* rec, const TumbleRecContact* contact);
/* phase: place of the name in def.phases. Called again for a further substep. Hash fields, never raw structs. */
TumbleRecStatus tumble_rec_phase_hash(TumbleRec* rec, uint32_t phase, uint64_t hash);
TumbleRecStatus tumble_rec_step_end(TumbleRec* rec);

/* A named quantity; *channel is its number. Declared once, at any time outside a step; at most 4096 of them. */
TumbleRecStatus tumble_rec_channel(TumbleRec* rec, const char* name, TumbleRecScope scope, TumbleRecType type,
                                   uint32_t* channel);
/* Its value(s) in the open step, or at the start: count numbers of the channel's type, or bytes. a, b: the body or the
 * pair, else 0. Once a step for each a, b. */
TumbleRecStatus tumble_rec_value(TumbleRec* rec, uint32_t channel, uint64_t a, uint64_t b, const void* values,
                                 uint32_t count);
TumbleRecStatus tumble_rec_f64(TumbleRec* rec, uint32_t channel, uint64_t a, double value);
TumbleRecStatus tumble_rec_i64(TumbleRec* rec, uint32_t channel, uint64_t a, int64_t value);
TumbleRecStatus tumble_rec_text(TumbleRec* rec, uint32_t channel, uint64_t a, const char* value);

/* Anything to read beside the open step, or the coming one: after the last step there is none, and close says so. */
TumbleRecStatus tumble_rec_note(TumbleRec* rec, const char* text);

/* The engine's own state after the last step, to begin again from; between steps. */
TumbleRecStatus tumble_rec_snapshot(TumbleRec* rec, const char* name, const void* bytes, size_t size);

/* Rollback: the world is again as after `step`; the steps that follow replace those recorded after it. */
TumbleRecStatus tumble_rec_rewind(TumbleRec* rec, uint64_t step);

/* Writes the ring: to a file, or through write(). The second allocates nothing, so a crash handler of the thread that
 * recorded may call it with a write() that is safe there. The open step is left out. */
TumbleRecStatus tumble_rec_dump(TumbleRec* rec, const char* path);
TumbleRecStatus tumble_rec_dump_to(TumbleRec* rec, TumbleRecWrite write, void* user);

/* Writes the steps that wait, in the tail or for `steps_a_write`, also within a step; a crash handler of the thread
 * that recorded may call it where write(2) may be called. */
TumbleRecStatus tumble_rec_flush(TumbleRec* rec);

uint64_t tumble_rec_step(const TumbleRec* rec);           /* the last step that was ended; 0: none */
uint64_t tumble_rec_steps_verified(const TumbleRec* rec); /* steps compared whole and found equal */
/* What went wrong first, or "". The first difference, or NULL. Good until tumble_rec_close(). */
const char* tumble_rec_message(const TumbleRec* rec);
const TumbleRecDifference* tumble_rec_difference(const TumbleRec* rec);

/* Completes the stream and frees the recorder; the first error of all, or TUMBLE_REC_DIFFERENT, or TUMBLE_REC_OK. A
 * program that needs the message reads it before. */
TumbleRecStatus tumble_rec_finish(TumbleRec* rec); /* completes the stream, so that message and difference remain */
TumbleRecStatus tumble_rec_close(TumbleRec* rec);  /* finish, unless it was called, and free */

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-deprecated-headers,readability-identifier-naming,modernize-use-using) */
