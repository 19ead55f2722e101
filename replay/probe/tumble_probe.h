#pragma once

/* Probes: named values inside a step of any engine, written in one chosen step only. This header and tumble_probe.c,
 * C99, nothing else. `tumble diff A B --zoom` turns them on in the first step that differs, in both builds, and names
 * the first probe with another value, with file and line. docs/zoom.md is the tutorial.
 *
 *   tumble_probes_from_environment(&tumble_probes);          once, when the engine starts
 *   tumble_probes_step(&tumble_probes, step);                before each step: 1 for the first one of the log
 *   TUMBLE_PROBE_PAIR(&tumble_probes, "solver.lambda", a, b, lambda);      where a value was computed
 *   tumble_probes_close(&tumble_probes);                     before the engine ends
 *
 * The key says whose value it is (a body, a pair, an island), so that probes of two builds are matched although one
 * visits its pairs in another order; of one name and key, the first matches the first, the second the second.
 *
 * While probes are off, a probe is a branch that is never taken; with -DTUMBLE_NO_PROBES it is nothing. Several threads
 * may write at once (gcc, clang). */

/* The names of C: NOLINTBEGIN(modernize-deprecated-headers,readability-identifier-naming,modernize-use-using) */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct TumbleProbes {
  int on; /* in the chosen step */
  int lock;
  uint64_t wanted;     /* the chosen step; UINT64_MAX: none */
  uint64_t count;      /* probes of this step */
  uint32_t site_count; /* places known to the file */
  uint32_t generation; /* of the file; a place's number is of one file */
  void* file;
  int failed; /* a write failed: the file is not complete */
} TumbleProbes;

/* A place in the source; one static object for each probe. */
typedef struct TumbleProbeSite {
  const char* name;
  const char* file;
  uint32_t line;
  uint32_t number;
  uint32_t generation;
} TumbleProbeSite;

/* The probes of the process, for engines that carry no object of their own to every place. */
extern TumbleProbes tumble_probes;

/* Opens the file TUMBLE_PROBE_FILE for step TUMBLE_PROBE_STEP, which `diff --zoom` sets; without them probes stay off.
 * Returns 0, or -1 where the file cannot be written. */
int tumble_probes_from_environment(TumbleProbes* probes);

/* The same with path and step from elsewhere, such as arguments. */
int tumble_probes_open(TumbleProbes* probes, const char* path, uint64_t step);

/* Before each step; turns the probes on if it is the chosen one, off after it. A step that is taken again after a
 * rollback takes the place of the one before. */
void tumble_probes_step(TumbleProbes* probes, uint64_t step);

/* Ends the step and the file. Returns 0, or -1 where not all could be written. */
int tumble_probes_close(TumbleProbes* probes);

enum { TUMBLE_PROBE_F64 = 0, TUMBLE_PROBE_U64 = 1, TUMBLE_PROBE_I64 = 2, TUMBLE_PROBE_OF_PAIR = 0x80 };

/* Of the macros below. bits: of the value, as its kind says. */
void tumble_probes_write(TumbleProbes* probes, TumbleProbeSite* site, int kind, uint64_t a, uint64_t b, uint64_t bits);
uint64_t tumble_probe_bits(double value);

#ifdef __cplusplus
}
#endif

#if defined(__GNUC__)
#define TUMBLE_PROBE_RARELY(condition) __builtin_expect(!!(condition), 0)
#else
#define TUMBLE_PROBE_RARELY(condition) (condition)
#endif

#ifdef __cplusplus
#define TUMBLE_PROBE_AS(type, value) static_cast<type>(value)
#else
#define TUMBLE_PROBE_AS(type, value) ((type)(value))
#endif

#ifdef TUMBLE_NO_PROBES
#define TUMBLE_PROBE_AT(probes, name, kind, a, b, bits) ((void)0)
#else
#define TUMBLE_PROBE_AT(probes, name, kind, a, b, bits)                                               \
  do {                                                                                                \
    TumbleProbes* const tumble_probes_here = (probes);                                                \
    if (TUMBLE_PROBE_RARELY(tumble_probes_here != NULL && tumble_probes_here->on)) {                  \
      static TumbleProbeSite tumble_probe_site = {name, __FILE__, __LINE__, 0, 0};                    \
      tumble_probes_write(tumble_probes_here, &tumble_probe_site, kind, TUMBLE_PROBE_AS(uint64_t, a), \
                          TUMBLE_PROBE_AS(uint64_t, b), (bits));                                      \
    }                                                                                                 \
  } while (0)
#endif

/* A number that a float or a double holds, of one body or anything with a number. */
#define TUMBLE_PROBE(probes, name, key, value) \
  TUMBLE_PROBE_AT(probes, name, TUMBLE_PROBE_F64, key, 0, tumble_probe_bits(TUMBLE_PROBE_AS(double, value)))
/* Of a pair. Give a and b in an order that both builds agree on: the smaller id first, say. */
#define TUMBLE_PROBE_PAIR(probes, name, a, b, value)                           \
  TUMBLE_PROBE_AT(probes, name, TUMBLE_PROBE_F64 | TUMBLE_PROBE_OF_PAIR, a, b, \
                  tumble_probe_bits(TUMBLE_PROBE_AS(double, value)))
/* Whole numbers of up to 64 bits. */
#define TUMBLE_PROBE_UINT(probes, name, key, value) \
  TUMBLE_PROBE_AT(probes, name, TUMBLE_PROBE_U64, key, 0, TUMBLE_PROBE_AS(uint64_t, value))
#define TUMBLE_PROBE_INT(probes, name, key, value) \
  TUMBLE_PROBE_AT(probes, name, TUMBLE_PROBE_I64, key, 0, TUMBLE_PROBE_AS(uint64_t, TUMBLE_PROBE_AS(int64_t, value)))

/* NOLINTEND(modernize-deprecated-headers,readability-identifier-naming,modernize-use-using) */
