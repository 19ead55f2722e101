/* The recorder from C99, without any library: what every compiler and system must do alike. Each check says what
 * failed; the status is the number of failures. Files are written into the current folder. */
#include <stdio.h>
#include <string.h>

#include "tumble_recorder.h"

static int failures = 0;

static void check(int good, const char* what, const char* more) {
  if (good) return;
  ++failures;
  printf("recorder_check: FAILED: %s: %s\n", what, more != NULL ? more : "");
}

/* A session of two bodies and all that can be recorded; `change` plants one difference. */
typedef enum Change {
  kNone,
  kPosition,
  kAsleep,
  kFriction,
  kPushed,
  kContact,
  kPhase,
  kAngle,
  kSeed,
  kControl,
  kLabel,
  kDt,
  kFewerContacts,
  kGravityAtStart,
  kSecondRun
} Change;

static TumbleRecBody cube(uint64_t id, double height, Change change) {
  TumbleRecBody body;
  memset(&body, 0, sizeof body);
  body.id = id;
  body.name = id == 1 ? "lower" : "upper";
  body.size[0] = body.size[1] = body.size[2] = 1;
  body.mass = 2;
  body.friction = id == 2 && change == kFriction ? 0.5 : 0.25;
  body.state.position[2] = height;
  body.state.orientation[0] = 1;
  return body;
}

typedef struct Channels {
  uint32_t angle, seed, control, label;
} Channels;

static Channels declare(TumbleRec* rec) {
  Channels c = {0, 0, 0, 0};
  tumble_rec_channel(rec, "joint.angle", TUMBLE_REC_OF_PAIR, TUMBLE_REC_F32, &c.angle);
  tumble_rec_channel(rec, "random.seed", TUMBLE_REC_WORLD, TUMBLE_REC_U64, &c.seed);
  tumble_rec_channel(rec, "control", TUMBLE_REC_OF_BODY, TUMBLE_REC_F64, &c.control);
  tumble_rec_channel(rec, "label", TUMBLE_REC_WORLD, TUMBLE_REC_TEXT, &c.label);
  return c;
}

static void tell_contact(TumbleRec* rec, int k, Change change) {
  TumbleRecPoint points[2];
  TumbleRecContact contact;
  memset(points, 0, sizeof points);
  memset(&contact, 0, sizeof contact);
  contact.a = 2, contact.b = 1;
  contact.normal[2] = -1;
  points[1].impulse = change == kContact && k == 3 ? 5 : 4;
  contact.points = points;
  contact.point_count = change == kFewerContacts && k == 3 ? 0 : 2;
  if (contact.point_count > 0) tumble_rec_contact(rec, &contact);
}

static TumbleRecStatus one_step(TumbleRec* rec, int k, Channels c, Change change) {
  const double push[3] = {0, change == kPushed && k == 3 ? 2 : 1, 0};
  const float angle = change == kAngle && k == 3 ? 0.5f : 0.25f;
  const uint64_t seed = change == kSeed && k == 3 ? 43 : 42;
  TumbleRecState state = cube(1, 0.5, kNone).state;
  if (k == 3) tumble_rec_push(rec, 2, push);
  if (k == 3) tumble_rec_input(rec, "button", 0, "jump", 4);
  tumble_rec_step_begin(rec, change == kDt && k == 3 ? 0.25 : 0.5);
  if (k > 1) state.asleep = 0;
  tumble_rec_state(rec, 1, &state);
  state.position[2] = 1.5 - 0.0625 * k;
  state.velocity[2] = 1.0 / 3;
  if (change == kPosition && k == 3) state.position[1] = 1e-300;
  state.asleep = change == kAsleep && k == 4;
  tumble_rec_state(rec, 2, &state);
  tell_contact(rec, k, change);
  tumble_rec_phase_hash(rec, 0, 7);
  tumble_rec_phase_hash(rec, 1, change == kPhase && k == 3 ? 9 : 8);
  tumble_rec_value(rec, c.angle, 1, 2, &angle, 1);
  tumble_rec_value(rec, c.seed, 0, 0, &seed, 1);
  tumble_rec_f64(rec, c.control, 2, change == kControl && k == 3 ? 0.125 : 0.75);
  tumble_rec_text(rec, c.label, 0, change == kLabel && k == 3 ? "fall" : "rest");
  if (change == kSecondRun) tumble_rec_note(rec, "another run");
  return tumble_rec_step_end(rec);
}

static TumbleRecDef definition(void) {
  TumbleRecDef def;
  memset(&def, 0, sizeof def);
  def.engine = "C engine";
  def.version = "0.1";
  def.scene = "two cubes";
  def.precision_bits = 53;
  def.gravity[2] = -9.81;
  def.ground = 1;
  def.phases = "collide,solve";
  return def;
}

static TumbleRec* begin(TumbleRecDef def, Change change, Channels* channels) {
  TumbleRec* rec;
  TumbleRecBody body = cube(1, 0.5, change);
  if (change == kGravityAtStart) def.gravity[2] = -9.8;
  rec = tumble_rec_create(&def);
  *channels = declare(rec);
  tumble_rec_body(rec, &body);
  body = cube(2, 1.5, change);
  tumble_rec_body(rec, &body);
  return rec;
}

static TumbleRec* session(TumbleRecDef def, Change change, int steps) {
  Channels channels;
  TumbleRec* rec = begin(def, change, &channels);
  int k;
  for (k = 1; k <= steps; ++k) one_step(rec, k, channels, change);
  return rec;
}

static void writes_a_file(void) {
  TumbleRecDef def = definition();
  TumbleRec* rec;
  def.path = "check.tumblestream";
  rec = session(def, kNone, 6);
  check(tumble_rec_finish(rec) == TUMBLE_REC_OK, "a file is written", tumble_rec_message(rec));
  check(tumble_rec_step(rec) == 6, "six steps", NULL);
  check(tumble_rec_finish(rec) == TUMBLE_REC_OK, "a second finish does nothing", tumble_rec_message(rec));
  check(tumble_rec_close(rec) == TUMBLE_REC_OK, "close", NULL);
}

static void finds(Change change, const char* earlier, const char* part, const char* field, uint64_t step, uint64_t body) {
  TumbleRecDef def = definition();
  const TumbleRecDifference* d;
  TumbleRec* rec;
  char what[64];
  sprintf(what, "verify: change %d", (int)change);
  def.verify = earlier;
  rec = session(def, change, 6);
  d = tumble_rec_difference(rec);
  check(tumble_rec_finish(rec) == (part != NULL ? TUMBLE_REC_DIFFERENT : TUMBLE_REC_OK), what, tumble_rec_message(rec));
  check((d != NULL) == (part != NULL), what, d != NULL ? d->text : "found no difference");
  if (d == NULL) check(tumble_rec_steps_verified(rec) == 6, what, "wanted six steps verified");
  if (d != NULL && part != NULL) {
    check(strcmp(d->part, part) == 0 && strcmp(d->field, field) == 0 && d->step == step && d->body == body, what,
          d->text);
    printf("%s\n", d->text);
  }
  tumble_rec_close(rec);
}

static void verifies(void) {
  const char* const full = "check.tumblestream";
  finds(kNone, full, NULL, NULL, 0, 0);
  finds(kSecondRun, full, NULL, NULL, 0, 0); /* notes are not compared */
  finds(kPosition, full, "state", "position.y", 3, 2);
  finds(kAsleep, full, "state", "asleep", 4, 2);
  finds(kFriction, full, "input", "friction", 0, 2);
  finds(kPushed, full, "input", "impulse.y", 3, 2);
  finds(kContact, full, "contact", "impulse of point 2", 3, 2);
  finds(kFewerContacts, full, "contact", "contact", 3, 2);
  finds(kPhase, full, "phase hash", "solve", 3, 0);
  finds(kAngle, full, "channel", "joint.angle", 3, 1);
  finds(kSeed, full, "channel", "random.seed", 3, 0);
  finds(kControl, full, "channel", "control", 3, 2);
  finds(kLabel, full, "channel", "label", 3, 0);
  finds(kDt, full, "step", "dt", 3, 0);
  finds(kGravityAtStart, full, "start", "gravity.z", 0, 0);
}

static void verifies_by_hashes(void) {
  TumbleRecDef def = definition();
  def.path = "hashes.tumblestream";
  def.hashes_only = 1;
  check(tumble_rec_close(session(def, kNone, 6)) == TUMBLE_REC_OK, "hashes only", NULL);
  finds(kNone, "hashes.tumblestream", NULL, NULL, 0, 0);
  finds(kPosition, "hashes.tumblestream", "state", "hash", 3, 0);
  finds(kSeed, "hashes.tumblestream", "channel", "hash", 3, 0);
  finds(kPushed, "hashes.tumblestream", "input", "hash", 3, 0);
}

static void keeps_a_ring(void) {
  TumbleRecDef def = definition();
  TumbleRec* rec;
  def.ring_s = 8;
  rec = session(def, kNone, 1000);
  check(tumble_rec_dump(rec, "ring.tumblestream") == TUMBLE_REC_OK, "a ring is dumped", tumble_rec_message(rec));
  check(tumble_rec_close(rec) == TUMBLE_REC_OK, "close a ring", NULL);
  def.ring_s = 0;
  def.verify = "ring.tumblestream";
  rec = session(def, kNone, 6);
  check(tumble_rec_finish(rec) == TUMBLE_REC_BAD_STREAM, "no session is compared with a ring", tumble_rec_message(rec));
  check(strstr(tumble_rec_message(rec), "found a ring") != NULL, "a ring is named", tumble_rec_message(rec));
  check(tumble_rec_difference(rec) == NULL, "a ring is no difference", NULL);
  tumble_rec_close(rec);
}

static void rewinds(void) {
  TumbleRecDef def = definition();
  Channels c;
  TumbleRec* rec;
  int pass, k;
  def.path = "rewound.tumblestream";
  def.rollback_steps = 4;
  for (pass = 0; pass < 2; ++pass) {
    rec = begin(def, kNone, &c);
    for (k = 1; k <= 5; ++k) one_step(rec, k, c, kPosition);
    check(tumble_rec_rewind(rec, 2) == TUMBLE_REC_OK, "rewind", tumble_rec_message(rec));
    for (k = 3; k <= 6; ++k) one_step(rec, k, c, kNone);
    check(tumble_rec_finish(rec) == TUMBLE_REC_OK, "a session with a rewind", tumble_rec_message(rec));
    check(pass == 0 || tumble_rec_steps_verified(rec) == 9, "a rewind is verified", tumble_rec_message(rec));
    check(tumble_rec_close(rec) == TUMBLE_REC_OK, "close", NULL);
    def.path = NULL;
    def.verify = "rewound.tumblestream";
  }
}

static void refuses(TumbleRec* rec, const char* wanted) {
  check(strstr(tumble_rec_message(rec), wanted) != NULL, wanted, tumble_rec_message(rec));
  check(tumble_rec_finish(rec) != TUMBLE_REC_OK, "an error stays", wanted);
  tumble_rec_close(rec);
}

static void refuses_misuse(void) {
  TumbleRecDef def = definition();
  const TumbleRecState state = cube(1, 1, kNone).state;
  TumbleRec* rec;
  Channels c;
  def.path = "misuse.tumblestream";
  rec = begin(def, kNone, &c);
  tumble_rec_state(rec, 1, &state);
  refuses(rec, "wanted step_begin before");
  rec = begin(def, kNone, &c);
  tumble_rec_step_begin(rec, 0.5);
  tumble_rec_state(rec, 3, &state);
  refuses(rec, "found a state of body 3, wanted the id of a body that exists");
  rec = begin(def, kNone, &c);
  tumble_rec_step_begin(rec, 0.5);
  tumble_rec_state(rec, 1, &state);
  tumble_rec_step_end(rec);
  refuses(rec, "step 1: found no state of body 2");
  rec = begin(def, kNone, &c);
  tumble_rec_step_begin(rec, 0.5);
  tumble_rec_state(rec, 1, &state);
  tumble_rec_state(rec, 1, &state);
  refuses(rec, "found two states of body 1");
  rec = begin(def, kNone, &c);
  tumble_rec_step_begin(rec, 0.5);
  refuses(rec, "");
  rec = begin(def, kNone, &c);
  tumble_rec_f64(rec, c.seed, 0, 1);
  refuses(rec, "found a value of another type");
  rec = begin(def, kNone, &c);
  tumble_rec_channel(rec, "control", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &c.seed);
  refuses(rec, "found channel \"control\" twice");
  rec = begin(def, kNone, &c);
  tumble_rec_channel(rec, "a=b", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &c.seed);
  refuses(rec, "found a '=' or a control character");
  rec = begin(def, kNone, &c);
  tumble_rec_rewind(rec, 0);
  refuses(rec, "found a rewind");
  rec = begin(def, kNone, &c);
  tumble_rec_step_begin(rec, 1e-300);
  refuses(rec, "found a dt of 1e-300 s, wanted 1e-07 to 1 s");
  def.path = "no folder/misuse.tumblestream";
  refuses(begin(def, kNone, &c), "cannot be written: ");
  def.path = NULL;
  refuses(begin(def, kNone, &c), "found 0 of path, write and ring_s");
  def.verify = "misuse.c";
  refuses(begin(def, kNone, &c), "cannot be opened");
  check(tumble_rec_close(NULL) == TUMBLE_REC_OK && tumble_rec_step_end(NULL) == TUMBLE_REC_BAD_CALL, "NULL", NULL);
}

int main(void) {
  writes_a_file();
  verifies();
  verifies_by_hashes();
  keeps_a_ring();
  rewinds();
  refuses_misuse();
  printf("recorder_check: %d failures\n", failures);
  return failures;
}
