/* Recorders that share a file or a process, and the first call of a session: from C99, without any library, as
 * recorder_check.c. The status is the number of failures. */
#if defined(__unix__) || defined(__APPLE__)
#define _POSIX_C_SOURCE 200809L
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <stdio.h>
#include <string.h>

#include "tumble_recorder.h"

static int failures = 0;

static void check(int good, const char* what, const char* more) {
  if (good) return;
  ++failures;
  printf("recorder_share: FAILED: %s: %s\n", what, more != NULL ? more : "");
}

static TumbleRecState at_height(double height) {
  TumbleRecState state;
  memset(&state, 0, sizeof state);
  state.position[2] = height;
  state.orientation[0] = 1;
  return state;
}

static TumbleRecBody cube(uint64_t id) {
  TumbleRecBody body;
  memset(&body, 0, sizeof body);
  body.id = id;
  body.size[0] = body.size[1] = body.size[2] = 1;
  body.mass = 2;
  body.state = at_height(1);
  return body;
}

static TumbleRecDef definition(void) {
  TumbleRecDef def;
  memset(&def, 0, sizeof def);
  def.engine = "C engine";
  def.precision_bits = 53;
  return def;
}

/* An engine's loop that pushes, then steps: the first push comes before any step. */
static void takes_a_push_before_the_first_step(void) {
  TumbleRecDef def = definition();
  const TumbleRecBody body = cube(1);
  double impulse[3] = {0, 0, 1};
  int round;
  for (round = 0; round < 3; ++round) {
    TumbleRec* rec;
    def.path = round == 0 ? "pushed.tumblestream" : NULL;
    def.verify = round == 0 ? NULL : "pushed.tumblestream";
    impulse[2] = round < 2 ? 1 : 2;
    rec = tumble_rec_create(&def);
    tumble_rec_body(rec, &body);
    check(tumble_rec_push(rec, 1, impulse) == (round < 2 ? TUMBLE_REC_OK : TUMBLE_REC_DIFFERENT), "a push at once",
          tumble_rec_message(rec));
    tumble_rec_step_begin(rec, 0.5);
    tumble_rec_state(rec, 1, &body.state);
    tumble_rec_step_end(rec);
    if (round == 2) {
      const TumbleRecDifference* found = tumble_rec_difference(rec);
      check(found != NULL && found->step == 1 && strcmp(found->part, "input") == 0, "the push differs", NULL);
    }
    check(tumble_rec_close(rec) == (round < 2 ? TUMBLE_REC_OK : TUMBLE_REC_DIFFERENT), "a push at once", NULL);
  }
}

#if defined(__unix__) || defined(__APPLE__)
static void refuses(TumbleRec* rec, const char* wanted) {
  check(strstr(tumble_rec_message(rec), wanted) != NULL, wanted, tumble_rec_message(rec));
  check(tumble_rec_close(rec) == TUMBLE_REC_BAD_CALL, "an error stays", wanted);
}

static void fall_to(TumbleRec* rec, double height) {
  const TumbleRecState state = at_height(height);
  tumble_rec_step_begin(rec, 0.5);
  tumble_rec_state(rec, 1, &state);
  tumble_rec_step_end(rec);
}

/* Of two recorders of one file, in one process or two, the second one is refused, and the first loses nothing. */
static void shares_no_file(void) {
  TumbleRecDef def = definition();
  const TumbleRecBody body = cube(1);
  TumbleRec* rec;
  int round, ended = 0;
  for (round = 0; round < 3; ++round) {
    def.path = "shared.tumblestream";
    def.verify = NULL;
    rec = tumble_rec_create(&def);
    tumble_rec_body(rec, &body);
    fall_to(rec, 2);
    if (round == 0) {
      refuses(tumble_rec_create(&def), "another recorder writes it now");
    } else if (fork() == 0) {
      if (round == 2) { /* the child's copy of the recorder itself */
        fall_to(rec, 7);
        _exit(tumble_rec_close(rec) == TUMBLE_REC_BAD_CALL ? 0 : 1);
      }
      _exit(tumble_rec_close(tumble_rec_create(&def)) == TUMBLE_REC_BAD_CALL ? 0 : 1);
    } else {
      check(wait(&ended) > 0 && ended == 0, "a second process is refused", NULL);
    }
    fall_to(rec, 3);
    check(tumble_rec_close(rec) == TUMBLE_REC_OK, "the first recorder goes on", NULL);
    def.path = NULL;
    def.verify = "shared.tumblestream";
    rec = tumble_rec_create(&def);
    tumble_rec_body(rec, &body);
    fall_to(rec, 2);
    fall_to(rec, 3);
    check(tumble_rec_finish(rec) == TUMBLE_REC_OK && tumble_rec_steps_verified(rec) == 2, "all of it is there",
          tumble_rec_message(rec));
    tumble_rec_close(rec);
  }
}
#else
static void shares_no_file(void) {}
#endif

int main(void) {
  takes_a_push_before_the_first_step();
  shares_no_file();
  printf("recorder_share: %d failures\n", failures);
  return failures;
}
