/* See tumble_recorder.h for the use and docs/recorder_stream.md for the bytes. One file, so that an engine copies two.
 */
#if (defined(__unix__) || defined(__APPLE__)) && !defined(__EMSCRIPTEN__) && !defined(TUMBLE_REC_NO_TAIL)
#define HAS_TAIL 1
#if !defined(_POSIX_C_SOURCE) && !defined(__APPLE__)
#define _POSIX_C_SOURCE 200809L /* NOLINT(bugprone-reserved-identifier): what the tail needs */
#endif
#endif

#include "tumble_recorder.h"

#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif
#ifdef HAS_TAIL
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#endif

/* ---- What C99 lacks: an atomic exchange and a mark of the thread. ---- */

#if defined(_MSC_VER)
#include <intrin.h>
static __declspec(thread) char thread_mark;
#define SWAP_IF_NULL(at, mark) _InterlockedCompareExchangePointer((void* volatile*)(at), (mark), NULL)
#define STORE(at, value) _InterlockedExchangePointer((void* volatile*)(at), (value))
#define LOAD(at) _InterlockedCompareExchangePointer((void* volatile*)(at), NULL, NULL)
#elif defined(__GNUC__) || defined(__clang__)
static __thread char thread_mark;
#define SWAP_IF_NULL(at, mark) swap_if_null((at), (mark))
#define STORE(at, value) __atomic_store_n((at), (void*)(value), __ATOMIC_RELEASE)
#define LOAD(at) __atomic_load_n((at), __ATOMIC_ACQUIRE)
static void* swap_if_null(void** at, void* mark) {
  void* found = NULL;
  __atomic_compare_exchange_n(at, &found, mark, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE);
  return found;
}
#else
#error "tumble_recorder.c: wanted gcc, clang or Visual C++; add an atomic exchange and a thread-local byte here"
#endif

/* ---- Limits and layout: docs/recorder_stream.md. ---- */

enum {
  kMagicBytes = 16,
  kPreludeBytes = 24, /* magic, version */
  kFrameBytes = 24,   /* kind, length, number, hash */
  kNameMax = 200,
  kTextMax = 65535,
  kPhasesMax = 256,
  kRowsMax = 16,
  kChannelsMax = 4096,
  kPointsMax = 4096,
  kMeshMax = 100000,
  kGroupBytesMax = 1 << 20,
  kRecordMax = (1 << 24) - 1,
  kPendingMax = 1 << 24,
  kStateDoubles = 13,
  kRingParts = 8,
  kTailBytes = 1 << 20,
  kTailHeadBytes = 40 /* magic, tag, number and hash of the frame before */
};
#define FRAME_MAX ((size_t)1 << 28)
#define ID_MAX (((uint64_t)1 << 53) - 1)
static const unsigned char kMagic[kMagicBytes] = {0x89, 't', 'u', 'm', 'b', 'l',  'e',  's',
                                                  't',  'r', 'e', 'a', 'm', '\r', '\n', 0x1a};
static const unsigned char kTailMagic[kMagicBytes] = {0x89, 't', 'u', 'm', 'b', 'l',  'e',  't',
                                                      'a',  'i', 'l', 0,   0,   '\r', '\n', 0x1a};
static const char kTailSuffix[] = ".tail";
static const char kRefusedName[] = "tumble_recorder: refused"; /* of a snapshot whose bytes say why the stream ends */
enum { kMajor = 1, kMinor = 0 };

enum FrameKind { kHeader = 1, kStart = 2, kStep = 3, kHashes = 4, kRewind = 5, kSnapshot = 6, kEnd = 7 };

enum RecordKind {
  kBody = 1,
  kRemove = 2,
  kPush = 3,
  kSetVelocity = 4,
  kSetGravity = 5,
  kInput = 6,
  kStates32 = 10,
  kStates64 = 11,
  kSame = 12,
  kContact = 20,
  kContact32 = 21,
  kPhase = 30,
  kNote = 40,
  kChannel = 50,
  kValue = 51,
  kMesh = 52
};

/* What a hash of a step covers; also what an entry is looked up by in verify mode. */
enum Class { kInputs, kStates, kContacts, kPhases, kValues, kClasses };
static const char* const kClassNames[kClasses] = {"input", "state", "contact", "phase hash", "channel"};

static int class_of(int kind) {
  return kind <= kInput       ? kInputs
         : kind <= kSame      ? kStates
         : kind <= kContact32 ? kContacts
         : kind == kPhase     ? kPhases
                              : kValues;
}

static const char* const kStateFields[kStateDoubles] = {
    "position.x", "position.y", "position.z", "orientation.w", "orientation.x", "orientation.y", "orientation.z",
    "velocity.x", "velocity.y", "velocity.z", "spin.x",        "spin.y",        "spin.z"};

/* The fields of records that are compared field by field: b u8, w u32, q u64, d f64, s text; * repeats the rest. */
typedef struct Field {
  char type;
  const char* name;
} Field;
static const Field kBodyFields[] = {{'q', "id"},
                                    {'b', "flags"},
                                    {'d', "position.x"},
                                    {'d', "position.y"},
                                    {'d', "position.z"},
                                    {'d', "orientation.w"},
                                    {'d', "orientation.x"},
                                    {'d', "orientation.y"},
                                    {'d', "orientation.z"},
                                    {'d', "velocity.x"},
                                    {'d', "velocity.y"},
                                    {'d', "velocity.z"},
                                    {'d', "spin.x"},
                                    {'d', "spin.y"},
                                    {'d', "spin.z"},
                                    {'b', "shape"},
                                    {'d', "size.x"},
                                    {'d', "size.y"},
                                    {'d', "size.z"},
                                    {'q', "mesh hash"},
                                    {'d', "mass"},
                                    {'d', "friction"},
                                    {'d', "restitution"},
                                    {'s', "name"},
                                    {0, NULL}};
static const Field kRemoveFields[] = {{'q', "id"}, {0, NULL}};
static const Field kPushFields[] = {{'q', "id"}, {'d', "impulse.x"}, {'d', "impulse.y"}, {'d', "impulse.z"}, {0, NULL}};
static const Field kSetVelocityFields[] = {
    {'q', "id"},     {'d', "velocity.x"}, {'d', "velocity.y"}, {'d', "velocity.z"},
    {'d', "spin.x"}, {'d', "spin.y"},     {'d', "spin.z"},     {0, NULL}};
static const Field kGravityFields[] = {{'d', "gravity.x"}, {'d', "gravity.y"}, {'d', "gravity.z"}, {0, NULL}};
static const Field kInputFields[] = {{'q', "id"}, {'s', "name"}, {'*', NULL}, {'b', "byte"}, {0, NULL}};
static const Field kContactFields[] = {{'q', "a"},
                                       {'q', "b"},
                                       {'w', "part"},
                                       {'d', "normal.x"},
                                       {'d', "normal.y"},
                                       {'d', "normal.z"},
                                       {'w', "count of points"},
                                       {'*', NULL},
                                       {'d', "position.x"},
                                       {'d', "position.y"},
                                       {'d', "position.z"},
                                       {'d', "depth"},
                                       {'d', "impulse"},
                                       {0, NULL}};
static const Field kPhaseFields[] = {{'w', "phase"}, {'w', "substep"}, {'q', "hash"}, {0, NULL}};
static const Field kChannelFields[] = {{'w', "number"}, {'b', "scope"}, {'b', "type"}, {'s', "name"}, {0, NULL}};
static const Field kHeaderFields[] = {
    {'w', "precision"}, {'c', "up"},     {'b', "left_handed"}, {'b', "ground"},    {'b', "hashes_only"},
    {'b', "ring"},      {'d', "metres"}, {'d', "gravity.x"},   {'d', "gravity.y"}, {'d', "gravity.z"},
    {0, NULL}};

/* ---- The recorder. ---- */

typedef struct Bytes {
  unsigned char* at;
  size_t size, room;
} Bytes;

typedef struct Body {
  uint64_t id;
  uint64_t told; /* serial of the step in which the state was last given */
  unsigned char is_static, asleep, gone, last_known, last_wide;
  unsigned char last[8 * kStateDoubles]; /* as in states64 where wide, else as in states32 */
  uint64_t added, removed_at;            /* steps */
  unsigned char* record;                 /* ring: its record, to begin a part with */
  size_t record_size;
} Body;

typedef struct Channel {
  char name[kNameMax + 1];
  unsigned char scope, type;
} Channel;

typedef struct Told { /* a value of the step */
  uint64_t a, b, serial;
  uint32_t channel;
} Told;

typedef struct Part { /* of the ring: frames that can be read by themselves */
  Bytes bytes;
  double seconds;
} Part;

/* Of a file, in memory: frames that the stream's file lacks yet. It outlives the process, and costs no call to the
 * system. */
typedef struct Tail {
  unsigned char* at; /* NULL: none */
  size_t size;
  char* path;
  uint64_t number, hash; /* of the last frame given to it or to the file */
  int64_t written_s;     /* when the stream's file was last written */
} Tail;

typedef struct Entry { /* of the step to compare with */
  uint64_t a, b;
  uint32_t c;
  unsigned char kind, class_, seen;
  size_t at, size;
} Entry;

typedef struct Verify {
  FILE* file;
  char* tail_path; /* where the stream may go on; NULL: it was opened */
  uint64_t tag, number, next, last_hash;
  int active, by_hash, in_tail, is_ring;
  uint64_t steps;
  Bytes frame; /* the payload of the current one */
  Bytes wide;  /* a contact of it, in doubles */
  uint32_t kind;
  int has_frame;
  Entry* entries;
  size_t count, room, cursor;
  Entry** sorted; /* by key; made when the order of entries is another */
  int is_sorted;
} Verify;

struct TumbleRec {
  TumbleRecDef def;  /* its texts are not kept, only numbers and callbacks */
  void* user_thread; /* in a call, and from step_begin to step_end */
  void* misused;     /* another thread called */
  int in_call;       /* of user_thread */
  TumbleRecStatus status;
  char message[512];
  FILE* file;
  long process; /* that writes to file */
  int finished, in_step, after_state, started;
  int is_closed; /* no frame may follow */
  Bytes frame;   /* room for its head, then the payload of the coming step */
  size_t group;  /* where the open group record begins; 0: none */
  int group_kind;
  uint64_t frames, step, serial;
  uint64_t tag; /* hash of the header */
  uint64_t hashes[kClasses];
  uint64_t inputs_told;
  int notes_told;
  uint32_t phases, phase_rows[kPhasesMax];
  char (*phase_names)[kNameMax + 1];
  double gravity[3];
  int full; /* states are never written as "same" */
  Body* bodies;
  size_t body_count, body_room;
  uint32_t* slots; /* by hash of id: 1 + place of a body, 0 free */
  size_t slot_count;
  uint64_t* used; /* ids of bodies that were forgotten, by hash; 0: free */
  size_t used_count, used_room;
  size_t hint;
  size_t moving, moving_told; /* bodies that need a state in this step */
  size_t woken, slept;        /* of those told in this step */
  Channel* channels;
  uint32_t channel_count, channel_room;
  Told* told; /* by hash of channel and bodies: the values of this step; of another serial: free */
  size_t told_count, told_room;
  Bytes header;  /* ring: its frame */
  Bytes meshes;  /* ring: their records, to begin each part with */
  Bytes head;    /* frames that are no step's */
  Bytes pending; /* complete frames that are not written yet */
  uint32_t pending_steps;
  Tail tail;
  Part ring[kRingParts + 2];
  size_t ring_count;
  Verify verify;
  int differs;
  TumbleRecDifference difference;
  char field_text[kNameMax + 64], earlier_text[96], now_text[96], text[768];
};

static TumbleRecStatus fail(TumbleRec* rec, TumbleRecStatus status, const char* format, ...) {
  va_list arguments;
  int at = 0;
  if (rec->status != TUMBLE_REC_OK) return rec->status;
  rec->status = status;
  if (rec->started) at = snprintf(rec->message, sizeof rec->message, "step %" PRIu64 ": ", rec->step + 1);
  va_start(arguments, format);
  vsnprintf(rec->message + at, sizeof rec->message - (size_t)at, format, arguments);
  va_end(arguments);
  return status;
}

static int reserve(TumbleRec* rec, Bytes* bytes, size_t more) {
  size_t room = bytes->room;
  unsigned char* grown;
  if (more <= room - bytes->size) return 1;
  if (bytes->size + more > FRAME_MAX) {
    fail(rec, TUMBLE_REC_BAD_CALL, "found more than 256 MiB in a frame, wanted less; give fewer or smaller values");
    return 0;
  }
  while (room - bytes->size < more) room = room < 4096 ? 4096 : 2 * room;
  grown = (unsigned char*)realloc(bytes->at, room);
  if (grown == NULL) {
    fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for %lu bytes", (unsigned long)room);
    return 0;
  }
  bytes->at = grown;
  bytes->room = room;
  return 1;
}

/* ---- Little endian on every machine; compilers make one instruction of each. ---- */

static unsigned char* put16(unsigned char* at, uint32_t v) {
  at[0] = (unsigned char)v, at[1] = (unsigned char)(v >> 8);
  return at + 2;
}
static unsigned char* put32(unsigned char* at, uint32_t v) {
  at[0] = (unsigned char)v, at[1] = (unsigned char)(v >> 8);
  at[2] = (unsigned char)(v >> 16), at[3] = (unsigned char)(v >> 24);
  return at + 4;
}
static unsigned char* put64(unsigned char* at, uint64_t v) {
  at[0] = (unsigned char)v, at[1] = (unsigned char)(v >> 8), at[2] = (unsigned char)(v >> 16);
  at[3] = (unsigned char)(v >> 24), at[4] = (unsigned char)(v >> 32), at[5] = (unsigned char)(v >> 40);
  at[6] = (unsigned char)(v >> 48), at[7] = (unsigned char)(v >> 56);
  return at + 8;
}
static uint32_t get32(const unsigned char* at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}
static uint64_t get64(const unsigned char* at) { return (uint64_t)get32(at) | (uint64_t)get32(at + 4) << 32; }
static uint64_t bits_of(double v) {
  uint64_t bits;
  memcpy(&bits, &v, 8);
  return bits;
}
static unsigned char* put_double(unsigned char* at, double v) { return put64(at, bits_of(v)); }
static double get_double(const unsigned char* at) {
  const uint64_t bits = get64(at);
  double v;
  memcpy(&v, &bits, 8);
  return v;
}
static unsigned char* put_doubles(unsigned char* at, const double* v, int count) {
  int k;
  for (k = 0; k < count; ++k) at = put_double(at, v[k]);
  return at;
}
static double get_float(const unsigned char* at) {
  const uint32_t bits = get32(at);
  float v;
  memcpy(&v, &bits, 4);
  return v;
}
static unsigned char* put_widened(unsigned char* at, const unsigned char* floats, int count) {
  int k;
  for (k = 0; k < count; ++k) at = put_double(at, get_float(floats + 4 * k));
  return at;
}
/* Numbers as floats; not 0: that loses bits. Two at a time where the processor can. */
static uint64_t put_floats(unsigned char* to, const double* v, size_t count) {
  uint64_t lost = 0;
  size_t k = 0;
#if defined(__SSE2__)
  __m128i lost_of_two = _mm_setzero_si128();
  uint64_t lost_of[2];
  for (; k + 2 <= count; k += 2) {
    const __m128d wide = _mm_loadu_pd(v + k);
    const __m128 single = _mm_cvtpd_ps(wide);
    const __m128i back = _mm_castpd_si128(_mm_cvtps_pd(single));
    lost_of_two = _mm_or_si128(lost_of_two, _mm_xor_si128(back, _mm_castpd_si128(wide)));
    _mm_storel_epi64((__m128i*)(void*)(to + 4 * k), _mm_castps_si128(single));
  }
  _mm_storeu_si128((__m128i*)(void*)lost_of, lost_of_two);
  lost = lost_of[0] | lost_of[1];
#endif
  for (; k < count; ++k) {
    const float single = (float)v[k];
    uint32_t bits;
    memcpy(&bits, &single, 4);
    lost |= bits_of((double)single) ^ bits_of(v[k]);
    put32(to + 4 * k, bits);
  }
  return lost;
}
static unsigned char* put_text(unsigned char* at, const char* text, size_t size) {
  at = put16(at, (uint32_t)size);
  if (size > 0) memcpy(at, text, size);
  return at + size;
}

/* ---- XXH64, written from its specification (Collet, xxHash 64-bit, 0.1.1). ---- */

static const uint64_t kPrime[5] = {0x9E3779B185EBCA87u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u, 0x85EBCA77C2B2AE63u,
                                   0x27D4EB2F165667C5u};
static uint64_t rotl(uint64_t v, int by) { return v << by | v >> (64 - by); }
static uint64_t hash_round(uint64_t lane, uint64_t input) { return rotl(lane + input * kPrime[1], 31) * kPrime[0]; }

static uint64_t hash64(const unsigned char* at, size_t size, uint64_t seed) {
  const unsigned char* const end = at + size;
  uint64_t h;
  int k;
  if (size >= 32) {
    uint64_t lane[4];
    lane[0] = seed + kPrime[0] + kPrime[1], lane[1] = seed + kPrime[1], lane[2] = seed, lane[3] = seed - kPrime[0];
    for (; end - at >= 32; at += 32) {
      lane[0] = hash_round(lane[0], get64(at)), lane[1] = hash_round(lane[1], get64(at + 8));
      lane[2] = hash_round(lane[2], get64(at + 16)), lane[3] = hash_round(lane[3], get64(at + 24));
    }
    h = rotl(lane[0], 1) + rotl(lane[1], 7) + rotl(lane[2], 12) + rotl(lane[3], 18);
    for (k = 0; k < 4; ++k) h = (h ^ hash_round(0, lane[k])) * kPrime[0] + kPrime[3];
  } else {
    h = seed + kPrime[4];
  }
  h += (uint64_t)size;
  for (; end - at >= 8; at += 8) h = rotl(h ^ hash_round(0, get64(at)), 27) * kPrime[0] + kPrime[3];
  for (; end - at >= 4; at += 4) h = rotl(h ^ (uint64_t)get32(at) * kPrime[0], 23) * kPrime[1] + kPrime[2];
  for (; end != at; ++at) h = rotl(h ^ *at * kPrime[4], 11) * kPrime[0];
  h = (h ^ h >> 33) * kPrime[1];
  h = (h ^ h >> 29) * kPrime[2];
  return h ^ h >> 32;
}

/* ---- Threads. ---- */

static int flush(TumbleRec* rec);
static void tell_refusal(TumbleRec* rec);
static const char kTwoThreads[] = "found a call of a second thread, wanted one thread from step_begin to step_end";

/* The recorder is held here, so a misuse that another thread marked may be written down. It stays held in a step, which
 * saves an atomic exchange a body; not after an error, so that whoever closes it learns that error. */
static TumbleRecStatus leave(TumbleRec* rec, TumbleRecStatus status) {
  if (LOAD(&rec->misused) != NULL) fail(rec, TUMBLE_REC_TWO_THREADS, kTwoThreads);
  if (rec->status != TUMBLE_REC_OK) {
    status = rec->status;
    tell_refusal(rec);
    flush(rec); /* what was recorded before the error stays */
  }
  rec->in_call = 0;
  if (!rec->in_step || rec->status != TUMBLE_REC_OK) STORE(&rec->user_thread, NULL);
  return status;
}

/* 1: the call may go on, and ends with leave(). */
static int enter(TumbleRec* rec, TumbleRecStatus* status) {
  *status = TUMBLE_REC_BAD_CALL;
  if (rec == NULL) return 0;
  if (LOAD(&rec->user_thread) == &thread_mark) {
    if (rec->in_call) return 0; /* from a callback of its own */
  } else if (SWAP_IF_NULL(&rec->user_thread, &thread_mark) != NULL) {
    STORE(&rec->misused, &thread_mark);
    *status = TUMBLE_REC_TWO_THREADS;
    return 0;
  }
  rec->in_call = 1;
  if (rec->finished) fail(rec, TUMBLE_REC_BAD_CALL, "found a call after tumble_rec_finish(), wanted none");
  if (rec->status == TUMBLE_REC_OK && LOAD(&rec->misused) == NULL) return 1;
  *status = leave(rec, TUMBLE_REC_OK);
  return 0;
}

/* ---- Frames. ---- */

static char* tail_path_of(const char* path) {
  const size_t length = strlen(path);
  char* tail = (char*)malloc(length + sizeof kTailSuffix);
  if (tail == NULL) return NULL;
  memcpy(tail, path, length);
  memcpy(tail + length, kTailSuffix, sizeof kTailSuffix);
  return tail;
}

static int append(TumbleRec* rec, Bytes* to, const unsigned char* at, size_t size) {
  if (!reserve(rec, to, size)) return 0;
  if (size > 0) memcpy(to->at + to->size, at, size);
  to->size += size;
  return 1;
}

/* A child of fork() shares file and tail with the process that records: what it wrote there would be in the middle of
 * the other's steps. */
static int is_of_this_process(TumbleRec* rec) {
#ifdef HAS_TAIL
  if (rec->file == NULL || getpid() == (pid_t)rec->process) return 1;
  fail(rec, TUMBLE_REC_BAD_CALL, "found a call of a process that fork() made, wanted one of the process that records");
  return 0;
#else
  return rec != NULL;
#endif
}

/* A frame that is complete, to where the stream goes. */
static int give_away(TumbleRec* rec, const unsigned char* at, size_t size) {
  if (rec->def.write != NULL && rec->def.write(rec->def.write_user, at, size) != 0) {
    fail(rec, TUMBLE_REC_CANNOT_WRITE, "found that write() did not take %lu bytes", (unsigned long)size);
    return 0;
  }
  if (rec->file != NULL && fwrite(at, 1, size, rec->file) != size) {
    fail(rec, TUMBLE_REC_CANNOT_WRITE, "found that the file takes no more bytes; is the disk full?");
    return 0;
  }
  return 1;
}

#ifdef HAS_TAIL
static int64_t seconds_now(void) { return (int64_t)time(NULL); }

/* Before `path` is overwritten: the tail that an earlier recorder left there belongs to what it wrote. */
static int remove_tail(TumbleRec* rec, const char* path) {
  unsigned char magic[kMagicBytes];
  FILE* file;
  int is_ours;
  free(rec->tail.path);
  rec->tail.path = tail_path_of(path);
  if (rec->tail.path == NULL) return fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for a path"), 0;
  file = fopen(rec->tail.path, "rb");
  if (file == NULL) return 1;
  is_ours = fread(magic, 1, kMagicBytes, file) == kMagicBytes && memcmp(magic, kTailMagic, kMagicBytes) == 0;
  fclose(file);
  if (!is_ours || unlink(rec->tail.path) == 0) return 1;
  fail(rec, TUMBLE_REC_CANNOT_WRITE, "%s: found the tail of an earlier stream, which cannot be removed",
       rec->tail.path);
  return 0;
}

/* All its blocks are there before it is used, so that a full disk cannot hit it later. */
static unsigned char* map_tail(TumbleRec* rec, int file) {
  void* at;
  size_t k;
  ssize_t has = 1;
  Bytes* zeros = &rec->pending;
  if (!reserve(rec, zeros, 1 << 16)) return NULL;
  memset(zeros->at, 0, 1 << 16);
  for (k = 0; k < kTailBytes && has > 0; k += (size_t)(has > 0 ? has : 0)) {
    has = write(file, zeros->at, kTailBytes - k < 1 << 16 ? kTailBytes - k : 1 << 16);
  }
  if (k != kTailBytes) return NULL;
  at = mmap(NULL, kTailBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  return at == MAP_FAILED ? NULL : (unsigned char*)at;
}

/* What is in the stream's file counts for nothing here. */
static void empty_tail(TumbleRec* rec) {
  Tail* tail = &rec->tail;
  put64(put64(put64(tail->at + kMagicBytes, rec->tag), tail->number), tail->hash);
  tail->size = kTailHeadBytes;
  tail->written_s = seconds_now();
}

/* Without a tail (no room, another file of its name, a device), each step is written when it ends. */
static void open_tail(TumbleRec* rec, const char* path) {
  Tail* tail = &rec->tail;
  struct stat found;
  int file;
  if (rec->def.steps_a_write > 0 || stat(path, &found) != 0 || !S_ISREG(found.st_mode)) return;
  file = open(tail->path, O_RDWR | O_CREAT | O_EXCL, 0666);
  if (file < 0) return;
  tail->at = map_tail(rec, file);
  close(file);
  if (tail->at == NULL) {
    unlink(tail->path);
    return;
  }
  tail->hash = rec->tag; /* of the header, which is written */
  memcpy(tail->at, kTailMagic, kMagicBytes);
  empty_tail(rec);
}

/* After a failure it is left as it is: what the file did not take can be read from it. */
static int flush_tail(TumbleRec* rec) {
  const size_t size = rec->tail.size - kTailHeadBytes;
  if (rec->status == TUMBLE_REC_CANNOT_WRITE) return 0;
  if (size > 0 && !give_away(rec, rec->tail.at + kTailHeadBytes, size)) return 0;
  empty_tail(rec);
  return 1;
}

/* The file is written after the start and then at least once a second, so that who reads it as it grows is at most that
 * far behind. */
static int write_to_tail(TumbleRec* rec, const unsigned char* frame, size_t size) {
  Tail* tail = &rec->tail;
  const int is_large = kTailHeadBytes + size > kTailBytes;
  const int is_start = tail->number == 0;
  if (tail->size + size > kTailBytes && !flush_tail(rec)) return 0;
  if (is_large && !give_away(rec, frame, size)) return 0;
  tail->number = get64(frame + 8), tail->hash = get64(frame + 16);
  if (is_large) return 1;
  memcpy(tail->at + tail->size, frame, size);
  tail->size += size;
  return (!is_start && seconds_now() == tail->written_s) || flush_tail(rec);
}

static void close_tail(TumbleRec* rec) {
  if (rec->tail.at == NULL) return;
  if (rec->tail.size == kTailHeadBytes && is_of_this_process(rec))
    unlink(rec->tail.path); /* else it holds what the disk did not take */
  munmap(rec->tail.at, kTailBytes);
  rec->tail.at = NULL;
}
#else
static void open_tail(TumbleRec* rec, const char* path) { (void)rec, (void)path; }
static int flush_tail(TumbleRec* rec) { return rec != NULL; }
static int write_to_tail(TumbleRec* rec, const unsigned char* at, size_t size) { return give_away(rec, at, size); }
static void close_tail(TumbleRec* rec) { (void)rec; }
#endif

static int flush(TumbleRec* rec) {
  const size_t size = rec->pending.size;
  if (!is_of_this_process(rec)) return 0;
  rec->pending.size = 0;
  rec->pending_steps = 0;
  if (rec->tail.at != NULL) return flush_tail(rec);
  return size == 0 || give_away(rec, rec->pending.at, size);
}

/* Frames that wait for one another are given away together. */
static int write_bytes(TumbleRec* rec, const unsigned char* at, size_t size, int is_step) {
  if (rec->def.ring_s > 0) return append(rec, &rec->ring[rec->ring_count - 1].bytes, at, size);
  if (!is_of_this_process(rec)) return 0;
  if (rec->tail.at != NULL) return write_to_tail(rec, at, size);
  if (rec->def.steps_a_write <= 1) return give_away(rec, at, size);
  if (rec->pending.size > 0 && rec->pending.size + size > kPendingMax && !flush(rec)) return 0;
  if (size > kPendingMax) return give_away(rec, at, size);
  if (!append(rec, &rec->pending, at, size)) return 0;
  rec->pending_steps += (uint32_t)(is_step != 0);
  return rec->pending_steps < rec->def.steps_a_write || flush(rec);
}

/* Fills the head of a frame. Every hash depends on the header's, so frames of another stream are told apart. */
static void seal(unsigned char* frame, size_t size, uint32_t kind, uint64_t number, uint64_t tag) {
  put64(put32(put32(frame, kind), (uint32_t)(size - kFrameBytes)), number);
  put64(frame + 16, hash64(frame + kFrameBytes, size - kFrameBytes, hash64(frame, 16, tag)));
}

static int write_frame(TumbleRec* rec, uint32_t kind, Bytes* frame) {
  seal(frame->at, frame->size, kind, rec->frames, rec->tag);
  if (!write_bytes(rec, frame->at, frame->size, kind == kStep || kind == kHashes)) return 0;
  ++rec->frames;
  return 1;
}

/* After an error, once: the reason, for whoever reads the stream later. A snapshot, which readers of any version take
 * and no comparison reads. Nothing is allocated. */
static void tell_refusal(TumbleRec* rec) {
  unsigned char frame[kFrameBytes + 10 + sizeof kRefusedName + sizeof rec->message];
  unsigned char* at = frame + kFrameBytes;
  const size_t size = strlen(rec->message);
  if (rec->is_closed || rec->frames == 0 || rec->status == TUMBLE_REC_CANNOT_WRITE) return;
  rec->is_closed = 1;
  at = put_text(put64(at, rec->step), kRefusedName, sizeof kRefusedName - 1);
  memcpy(at, rec->message, size);
  at += size;
  seal(frame, (size_t)(at - frame), kSnapshot, rec->frames, rec->tag);
  if (write_bytes(rec, frame, (size_t)(at - frame), 0)) ++rec->frames;
}

/* An empty frame: room for its head. */
static int begin_frame(TumbleRec* rec, Bytes* frame, size_t more) {
  frame->size = 0;
  if (!reserve(rec, frame, kFrameBytes + more)) return 0;
  frame->size = kFrameBytes;
  return 1;
}

/* The frame of the coming step, or of the start: step and dt first. */
static int begin_step_frame(TumbleRec* rec) {
  if (!begin_frame(rec, &rec->frame, 16)) return 0;
  put_double(put64(rec->frame.at + kFrameBytes, rec->started ? rec->step + 1 : 0), 0);
  rec->frame.size += 16;
  rec->group = 0;
  rec->inputs_told = 0;
  rec->notes_told = 0;
  rec->after_state = 0;
  memset(rec->hashes, 0, sizeof rec->hashes);
  memset(rec->phase_rows, 0, sizeof rec->phase_rows);
  return 1;
}

/* Room for one record, or for one more entry of the record of this kind that is open. */
static unsigned char* add(TumbleRec* rec, int kind, size_t size, int grouped) {
  Bytes* frame = &rec->frame;
  unsigned char* at;
  if (size > kRecordMax) {
    fail(rec, TUMBLE_REC_BAD_CALL, "found a value of %lu bytes, wanted at most 16777215", (unsigned long)size);
    return NULL;
  }
  if (!reserve(rec, frame, size + 4)) return NULL;
  if (grouped && rec->group != 0 && rec->group_kind == kind && frame->size - rec->group < kGroupBytesMax) {
    at = frame->at + frame->size;
  } else {
    rec->group = grouped ? frame->size : 0;
    rec->group_kind = kind;
    put32(frame->at + frame->size, (uint32_t)kind | (uint32_t)(grouped ? 0 : size) << 8);
    at = frame->at + frame->size + 4;
    frame->size += 4;
  }
  frame->size += size;
  if (grouped) put32(frame->at + rec->group, (uint32_t)kind | (uint32_t)(frame->size - rec->group - 4) << 8);
  return at;
}

/* ---- Verification: the earlier stream, read frame by frame. ---- */

static void set_difference(TumbleRec* rec, const char* part, uint64_t body, uint64_t other) {
  TumbleRecDifference* d = &rec->difference;
  char of[64] = "";
  rec->differs = 1;
  rec->verify.active = 0;
  d->step = rec->started ? rec->step + 1 : 0;
  d->part = part;
  d->body = body, d->other = other;
  d->field = rec->field_text, d->earlier = rec->earlier_text, d->now = rec->now_text, d->text = rec->text;
  if (body != 0 && other != 0) snprintf(of, sizeof of, ", bodies %" PRIu64 " and %" PRIu64, body, other);
  if (body != 0 && other == 0) snprintf(of, sizeof of, ", body %" PRIu64, body);
  snprintf(rec->text, sizeof rec->text, "step %" PRIu64 "%s: %s: %s: %s in the earlier stream, %s now", d->step, of,
           part, rec->field_text, rec->earlier_text, rec->now_text);
  if (rec->def.on_difference != NULL) rec->def.on_difference(rec->def.difference_user, d);
}

static void name_field(TumbleRec* rec, const char* field, const char* earlier, const char* now) {
  snprintf(rec->field_text, sizeof rec->field_text, "%s", field);
  if (earlier != NULL) snprintf(rec->earlier_text, sizeof rec->earlier_text, "%s", earlier);
  if (now != NULL) snprintf(rec->now_text, sizeof rec->now_text, "%s", now);
}

static void print_double(char* to, size_t room, double v, int digits) {
  char* comma;
  snprintf(to, room, "%.*g", digits, v);
  comma = strchr(to, ',');
  if (comma != NULL) *comma = '.'; /* of a locale */
}

/* Reads a frame of the earlier stream. 0: its file ends, or something is wrong. */
static int read_earlier(TumbleRec* rec) {
  Verify* v = &rec->verify;
  unsigned char head[kFrameBytes];
  uint32_t size;
  if (fread(head, 1, kFrameBytes, v->file) != kFrameBytes) return 0;
  v->kind = get32(head);
  size = get32(head + 4);
  v->frame.size = 0;
  if (size > FRAME_MAX) {
    if (v->in_tail) return 0;
    fail(rec, TUMBLE_REC_BAD_STREAM, "found a frame of %lu bytes in the earlier stream", (unsigned long)size);
    return 0;
  }
  do { /* in blocks, so that a length that is a lie costs no memory; never NULL */
    const size_t left = size - v->frame.size, block = left < (size_t)1 << 20 ? left : (size_t)1 << 20;
    if (!reserve(rec, &v->frame, block + 1)) return 0;
    if (fread(v->frame.at + v->frame.size, 1, block, v->file) != block) return 0; /* torn */
    v->frame.size += block;
  } while (v->frame.size < size);
  if (hash64(v->frame.at, size, hash64(head, 16, v->kind == kHeader ? 0 : v->tag)) != get64(head + 16)) {
    if (v->in_tail) return 0; /* of an earlier use of the tail */
    fail(rec, TUMBLE_REC_BAD_STREAM, "found a damaged frame %" PRIu64 " in the earlier stream", get64(head + 8));
    return 0;
  }
  if (v->kind == kHeader) v->tag = get64(head + 16);
  v->number = get64(head + 8), v->last_hash = get64(head + 16);
  return 1;
}

/* Where the recorder of the earlier stream was killed, its last frames are in its tail. */
static int turn_to_tail(TumbleRec* rec) {
  Verify* v = &rec->verify;
  unsigned char head[kTailHeadBytes];
  FILE* file = v->in_tail || v->tail_path == NULL || v->is_ring ? NULL : fopen(v->tail_path, "rb");
  if (file == NULL) return 0;
  fclose(v->file);
  v->file = file;
  v->in_tail = 1;
  return fread(head, 1, sizeof head, file) == sizeof head && memcmp(head, kTailMagic, kMagicBytes) == 0 &&
         get64(head + 16) == v->tag && get64(head + 24) <= v->number &&
         (get64(head + 24) != v->number || get64(head + 32) == v->last_hash);
}

/* Reads the next frame that is compared. 0: there is none. */
static int next_earlier(TumbleRec* rec) {
  Verify* v = &rec->verify;
  uint64_t wanted = v->next;
  for (;;) {
    if (!read_earlier(rec)) {
      if (rec->status != TUMBLE_REC_OK || !turn_to_tail(rec)) return 0;
      wanted = v->next;
      continue;
    }
    if (v->in_tail && v->number < wanted) continue; /* in the file already */
    if (v->in_tail && v->number > wanted) return 0;
    wanted = v->next = v->number + 1;
    if (v->kind != kSnapshot) return v->kind != kEnd;
  }
}

static int add_entry(TumbleRec* rec, Verify* v, int kind, size_t at, size_t size, uint64_t a, uint64_t b, uint32_t c) {
  Entry* e;
  if (v->count == v->room) {
    const size_t room = v->room == 0 ? 256 : 2 * v->room;
    Entry* grown = (Entry*)realloc(v->entries, room * sizeof *grown);
    if (grown == NULL) {
      fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for %lu entries", (unsigned long)room);
      return 0;
    }
    v->entries = grown;
    v->room = room;
  }
  e = &v->entries[v->count++];
  e->a = a, e->b = b, e->c = c;
  e->kind = (unsigned char)kind;
  e->class_ = (unsigned char)class_of(kind);
  e->seen = 0;
  e->at = at, e->size = size;
  return 1;
}

/* The key of a record that is no group. */
static int add_record_entry(TumbleRec* rec, Verify* v, int kind, size_t at, size_t size, uint64_t* inputs) {
  const unsigned char* p = v->frame.at + at;
  if (kind == kNote || kind == kMesh) return 1; /* not compared; the bodies' mesh hashes are */
  if (class_of(kind) == kInputs) return add_entry(rec, v, kind, at, size, (*inputs)++, 0, 0);
  if ((kind == kContact && size >= 48) || (kind == kContact32 && size >= 36)) {
    return add_entry(rec, v, kind, at, size, get64(p), get64(p + 8), get32(p + 16));
  }
  if (kind == kPhase && size == 16) return add_entry(rec, v, kind, at, size, get32(p), get32(p + 4), 0);
  if (kind == kChannel && size >= 8) return add_entry(rec, v, kind, at, size, get32(p), 0, UINT32_MAX);
  if (kind == kValue && size >= 25) return add_entry(rec, v, kind, at, size, get64(p + 4), get64(p + 12), get32(p));
  fail(rec, TUMBLE_REC_BAD_STREAM, "found a record of kind %d and %lu bytes in the earlier stream", kind,
       (unsigned long)size);
  return 0;
}

static int index_entries(TumbleRec* rec) {
  Verify* v = &rec->verify;
  size_t at = 16;
  uint64_t inputs = 0;
  v->count = v->cursor = 0;
  v->is_sorted = 0;
  while (at + 4 <= v->frame.size) {
    const uint32_t head = get32(v->frame.at + at);
    const int kind = (int)(head & 255);
    const size_t size = head >> 8;
    const size_t each = kind == kStates32 ? 61 : kind == kStates64 ? 113 : kind == kSame ? 8 : 0;
    size_t k;
    at += 4;
    if (size > v->frame.size - at) break;
    if (each == 0) {
      if (!add_record_entry(rec, v, kind, at, size, &inputs)) return 0;
    } else {
      for (k = 0; k + each <= size; k += each) {
        if (!add_entry(rec, v, kind, at + k, each, get64(v->frame.at + at + k), 0, 0)) return 0;
      }
    }
    at += size;
  }
  return 1;
}

/* Reads the earlier frame of the step that is open now. */
static int open_earlier(TumbleRec* rec) {
  Verify* v = &rec->verify;
  const uint32_t wanted = rec->started ? kStep : kStart;
  if (!v->active) return 0;
  if (v->has_frame) return 1;
  if (!next_earlier(rec)) {
    v->active = 0; /* it ends here; steps_verified says how far */
    return 0;
  }
  if (v->kind != (v->by_hash ? (uint32_t)kHashes : wanted) || v->frame.size < 16) {
    name_field(rec, "what comes next", v->kind == kRewind ? "a rewind" : "a step", "a step");
    set_difference(rec, "order", 0, 0);
    return 0;
  }
  if (!rec->started && get64(v->frame.at) > 0) {
    v->active = 0;
    fail(rec, TUMBLE_REC_BAD_STREAM,
         "verify: found a ring, which begins after step %" PRIu64 ", wanted a stream from the session's start on",
         get64(v->frame.at));
    return 0;
  }
  v->has_frame = 1;
  return v->by_hash || index_entries(rec);
}

static int compare_entries(const Entry* x, const Entry* y) {
  if (x->class_ != y->class_) return x->class_ < y->class_ ? -1 : 1;
  if (x->a != y->a) return x->a < y->a ? -1 : 1;
  if (x->b != y->b) return x->b < y->b ? -1 : 1;
  return x->c == y->c ? 0 : x->c < y->c ? -1 : 1;
}
static int compare_places(const void* x, const void* y) {
  return compare_entries(*(const Entry* const*)x, *(const Entry* const*)y);
}

/* In the order of the earlier stream where that is kept, else by search. */
static Entry* find_entry(TumbleRec* rec, const Entry* key) {
  Verify* v = &rec->verify;
  size_t low = 0, high = v->count, k;
  while (v->cursor < v->count && v->entries[v->cursor].seen) ++v->cursor;
  if (v->cursor < v->count && compare_entries(&v->entries[v->cursor], key) == 0) return &v->entries[v->cursor++];
  if (!v->is_sorted) {
    Entry** grown = (Entry**)realloc((void*)v->sorted, (v->count + 1) * sizeof *grown);
    if (grown == NULL) {
      fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for %lu entries", (unsigned long)v->count);
      return NULL;
    }
    v->sorted = grown;
    for (k = 0; k < v->count; ++k) grown[k] = &v->entries[k];
    qsort((void*)grown, v->count, sizeof *grown, compare_places);
    v->is_sorted = 1;
  }
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (compare_entries(v->sorted[middle], key) < 0)
      low = middle + 1;
    else
      high = middle;
  }
  return low < v->count && compare_entries(v->sorted[low], key) == 0 ? v->sorted[low] : NULL;
}

static size_t size_of_type(char type) { return type == 'b' || type == 'c' ? 1 : type == 'w' || type == 'f' ? 4 : 8; }

static void print_field(char* to, size_t room, char type, const unsigned char* at) {
  if (type == 'b') snprintf(to, room, "%u", (unsigned)*at);
  if (type == 'c') snprintf(to, room, "%c", (int)*at);
  if (type == 'w') snprintf(to, room, "%" PRIu32, get32(at));
  if (type == 'i') snprintf(to, room, "%" PRId64, (int64_t)get64(at));
  if (type == 'q') snprintf(to, room, "%" PRIu64, get64(at));
  if (type == 'd') print_double(to, room, get_double(at), 17);
  if (type == 'f') print_double(to, room, get_float(at), 9);
  if (type == 's') {
    const size_t size = (size_t)at[0] | (size_t)at[1] << 8;
    snprintf(to, room, "\"%.*s\"", (int)(size < room - 3 ? size : room - 3), (const char*)at + 2);
  }
}

/* Names the first field in which two records differ. Both are whole records of one kind. */
static void name_differing_field(TumbleRec* rec, const Field* fields, const unsigned char* x, size_t x_size,
                                 const unsigned char* y, size_t y_size) {
  const Field* f = fields;
  const Field* again = NULL;
  size_t at = 0, round = 0;
  for (;;) {
    size_t size;
    if (f->type == '*') again = ++f, round = 1;
    if (f->type == 0) {
      if (again == NULL || at >= x_size || at >= y_size) break;
      f = again, ++round;
    }
    if (f->type == 's') {
      if (at + 2 > x_size || at + 2 > y_size) break;
      size = 2 + ((size_t)x[at] | (size_t)x[at + 1] << 8);
      if (at + size > x_size || at + 2 + ((size_t)y[at] | (size_t)y[at + 1] << 8) > y_size) break;
      if (x[at] != y[at] || x[at + 1] != y[at + 1]) size = 0;
    } else {
      size = size_of_type(f->type);
      if (at + size > x_size || at + size > y_size) break;
    }
    if (size == 0 || memcmp(x + at, y + at, size) != 0) {
      if (round > 0 && f->type == 'b')
        snprintf(rec->field_text, sizeof rec->field_text, "%s %lu", f->name, (unsigned long)(round - 1));
      else if (round > 0)
        snprintf(rec->field_text, sizeof rec->field_text, "%s of point %lu", f->name, (unsigned long)round);
      else
        name_field(rec, f->name, NULL, NULL);
      print_field(rec->earlier_text, sizeof rec->earlier_text, f->type, x + at);
      print_field(rec->now_text, sizeof rec->now_text, f->type, y + at);
      return;
    }
    at += size;
    ++f;
  }
  name_field(rec, "size in bytes", NULL, NULL);
  snprintf(rec->earlier_text, sizeof rec->earlier_text, "%lu", (unsigned long)x_size);
  snprintf(rec->now_text, sizeof rec->now_text, "%lu", (unsigned long)y_size);
}

static const Field* fields_of(int kind) {
  switch (kind) {
    case kBody:
      return kBodyFields;
    case kRemove:
      return kRemoveFields;
    case kPush:
      return kPushFields;
    case kSetVelocity:
      return kSetVelocityFields;
    case kSetGravity:
      return kGravityFields;
    case kInput:
      return kInputFields;
    case kContact:
      return kContactFields;
    case kPhase:
      return kPhaseFields;
    default:
      return kChannelFields;
  }
}

/* The name within the record of a channel; "channel" where it holds none. */
static void name_channel(TumbleRec* rec, const unsigned char* at, size_t size, const char* earlier, const char* now) {
  const size_t length = size < 8 ? 0 : (size_t)at[6] | (size_t)at[7] << 8;
  name_field(rec, "channel", earlier, now);
  if (length > 0 && length <= size - 8)
    snprintf(rec->field_text, sizeof rec->field_text, "%.*s", (int)(length < kNameMax ? length : kNameMax),
             (const char*)at + 8);
}

static const char* name_of_input(int kind) {
  static const char* const kNames[] = {"none", "body", "remove", "push", "set_velocity", "set_gravity", "input"};
  return kind >= kBody && kind <= kInput ? kNames[kind] : "none";
}

/* ---- Values. ---- */

static size_t value_bytes(int type) {
  return type == TUMBLE_REC_F32 || type == TUMBLE_REC_I32 || type == TUMBLE_REC_U32 ? 4
         : type >= TUMBLE_REC_BYTES                                                 ? 1
                                                                                    : 8;
}

static void print_value(char* to, size_t room, int type, const unsigned char* at, size_t bytes) {
  static const char kTypes[] = {'f', 'd', 'w', 'i', 'w', 'q', 'b', 0};
  if (type == TUMBLE_REC_I32)
    snprintf(to, room, "%" PRId32, (int32_t)get32(at));
  else if (type == TUMBLE_REC_TEXT)
    snprintf(to, room, "\"%.*s\"", (int)(bytes < room - 3 ? bytes : room - 3), (const char*)at);
  else
    print_field(to, room, kTypes[type], at);
}

static void name_differing_value(TumbleRec* rec, const Channel* channel, const unsigned char* x, size_t x_size,
                                 const unsigned char* y, size_t y_size) {
  const size_t each = value_bytes(channel->type), head = 25;
  size_t k = 0;
  if (x_size != y_size && channel->type != TUMBLE_REC_TEXT) {
    snprintf(rec->field_text, sizeof rec->field_text, "count of %s", channel->name);
    snprintf(rec->earlier_text, sizeof rec->earlier_text, "%lu", (unsigned long)((x_size - head) / each));
    snprintf(rec->now_text, sizeof rec->now_text, "%lu", (unsigned long)((y_size - head) / each));
    return;
  }
  if (channel->type != TUMBLE_REC_TEXT) {
    while (head + (k + 1) * each <= y_size && memcmp(x + head + k * each, y + head + k * each, each) == 0) ++k;
  }
  if (channel->type != TUMBLE_REC_TEXT && head + (k + 1) * each > y_size) { /* equal numbers */
    name_field(rec, channel->name, "a value of another type", "this type");
    return;
  }
  if (k > 0 || y_size > head + each)
    snprintf(rec->field_text, sizeof rec->field_text, "%s[%lu]", channel->name, (unsigned long)k);
  if (channel->type == TUMBLE_REC_TEXT || y_size == head + each) name_field(rec, channel->name, NULL, NULL);
  print_value(rec->earlier_text, sizeof rec->earlier_text, channel->type, x + head + k * each, x_size - head);
  print_value(rec->now_text, sizeof rec->now_text, channel->type, y + head + k * each, y_size - head);
}

/* ---- Entries: one thing told of a step. ---- */

static double state_number(const unsigned char* packed, int wide, int k) {
  return wide ? get_double(packed + 8 * k) : get_float(packed + 4 * k);
}

static void verify_state(TumbleRec* rec, const Entry* e, const Body* body, const unsigned char* now, int wide,
                         int asleep) {
  const unsigned char* p = rec->verify.frame.at + e->at;
  const uint64_t id = body->id;
  int k;
  const int was_asleep = e->kind == kSame ? body->asleep : p[8] & 1;
  for (k = 0; k < kStateDoubles; ++k) {
    const double was =
        e->kind == kSame ? state_number(body->last, body->last_wide, k) : state_number(p + 9, e->kind == kStates64, k);
    const double is = state_number(now, wide, k);
    if (bits_of(was) == bits_of(is)) continue;
    name_field(rec, kStateFields[k], NULL, NULL);
    print_double(rec->earlier_text, sizeof rec->earlier_text, was, 17);
    print_double(rec->now_text, sizeof rec->now_text, is, 17);
    set_difference(rec, kClassNames[kStates], id, 0);
    return;
  }
  if ((was_asleep != 0) == (asleep != 0)) return;
  name_field(rec, "asleep", was_asleep ? "1" : "0", asleep ? "1" : "0");
  set_difference(rec, kClassNames[kStates], id, 0);
}

/* A contact of floats as one of doubles. */
static const unsigned char* widen_contact(TumbleRec* rec, const unsigned char* was, size_t* size) {
  Bytes* wide = &rec->verify.wide;
  const size_t points = (*size - 36) / 20;
  unsigned char* to;
  size_t k;
  wide->size = 0;
  if (!reserve(rec, wide, 48 + 40 * points)) return NULL;
  memcpy(wide->at, was, 20);
  to = put_widened(wide->at + 20, was + 20, 3);
  to = put32(to, get32(was + 32));
  for (k = 0; k < points; ++k) to = put_widened(to, was + 36 + 20 * k, 5);
  *size = 48 + 40 * points;
  return wide->at;
}

static void verify_record(TumbleRec* rec, const Entry* key, const unsigned char* at, size_t size) {
  Verify* v = &rec->verify;
  Entry* e = find_entry(rec, key);
  const int is_input = key->class_ == kInputs;
  const uint64_t body = is_input ? (size >= 8 && key->kind != kSetGravity ? get64(at) : 0)
                        : key->class_ == kPhases || key->kind == kChannel ? 0
                                                                          : key->a;
  const uint64_t other = is_input || key->class_ == kPhases ? 0 : key->b;
  const unsigned char* was;
  size_t was_size;
  int was_kind;
  if (rec->status != TUMBLE_REC_OK) return;
  if (e == NULL) {
    if (key->kind == kChannel)
      name_channel(rec, at, size, "absent", "present");
    else
      name_field(rec,
                 is_input                 ? name_of_input(key->kind)
                 : key->kind == kValue    ? rec->channels[key->c].name
                 : key->class_ == kPhases ? rec->phase_names[key->a]
                                          : kClassNames[key->class_],
                 "absent", "present");
    set_difference(rec, kClassNames[key->class_], body, other);
    return;
  }
  e->seen = 1;
  was = v->frame.at + e->at;
  was_size = e->size;
  was_kind = e->kind;
  if (was_kind == kContact32) {
    was = widen_contact(rec, was, &was_size);
    was_kind = kContact;
    if (was == NULL) return;
  }
  if (was_kind != key->kind) {
    name_field(rec, "kind", name_of_input(was_kind), name_of_input(key->kind));
  } else if (was_size == size && memcmp(was, at, size) == 0) {
    return;
  } else if (key->kind == kValue) {
    if (was_size < 25) {
      fail(rec, TUMBLE_REC_BAD_STREAM, "found a short value in the earlier stream");
      return;
    }
    name_differing_value(rec, &rec->channels[key->c], was, was_size, at, size);
  } else {
    name_differing_field(rec, fields_of(key->kind), was, was_size, at, size);
    if (key->kind == kPhase) name_field(rec, rec->phase_names[key->a], NULL, NULL);
  }
  set_difference(rec, kClassNames[key->class_], body, other);
}

/* What is hashed is the entry as it is, so "same" must not be written where hashes are wanted. */
static TumbleRecStatus entry_done(TumbleRec* rec, int kind, const unsigned char* at, size_t size, uint64_t a,
                                  uint64_t b, uint32_t c) {
  Entry key;
  const int before = rec->differs;
  const unsigned char head = (unsigned char)kind;
  key.kind = (unsigned char)kind;
  key.class_ = (unsigned char)class_of(kind);
  key.a = a, key.b = b, key.c = c;
  if (rec->full) rec->hashes[key.class_] = hash64(at, size, hash64(&head, 1, rec->hashes[key.class_]));
  if (key.class_ != kStates && rec->verify.active && open_earlier(rec) && !rec->verify.by_hash) {
    verify_record(rec, &key, at, size);
  }
  if (rec->def.hashes_only) rec->frame.size = kFrameBytes + 16, rec->group = 0;
  if (rec->status != TUMBLE_REC_OK) return rec->status;
  return rec->differs != before ? TUMBLE_REC_DIFFERENT : TUMBLE_REC_OK;
}

/* The end of a step: what the earlier one had and this one has not. */
static void close_earlier(TumbleRec* rec) {
  static const char* const kText = "present";
  Verify* v = &rec->verify;
  size_t k;
  if (!v->active || !open_earlier(rec)) return;
  if (memcmp(v->frame.at + 8, rec->frame.at + kFrameBytes + 8, 8) != 0) {
    name_field(rec, "dt", NULL, NULL);
    print_double(rec->earlier_text, sizeof rec->earlier_text, get_double(v->frame.at + 8), 17);
    print_double(rec->now_text, sizeof rec->now_text, get_double(rec->frame.at + kFrameBytes + 8), 17);
    set_difference(rec, "step", 0, 0);
    return;
  }
  if (v->by_hash) {
    for (k = 0; k < kClasses && v->frame.size >= 16 + 8 * (size_t)kClasses; ++k) {
      const uint64_t was = get64(v->frame.at + 16 + 8 * k);
      if (was == rec->hashes[k]) continue;
      name_field(rec, "hash", NULL, NULL);
      snprintf(rec->earlier_text, sizeof rec->earlier_text, "%016" PRIx64, was);
      snprintf(rec->now_text, sizeof rec->now_text, "%016" PRIx64, rec->hashes[k]);
      set_difference(rec, kClassNames[k], 0, 0);
      return;
    }
  }
  for (k = 0; !v->by_hash && k < v->count; ++k) {
    const Entry* e = &v->entries[k];
    const int is_value = e->kind == kValue && e->c < rec->channel_count;
    if (e->seen || e->kind == kSame) continue;
    if (e->kind == kChannel)
      name_channel(rec, v->frame.at + e->at, e->size, kText, "absent");
    else
      name_field(rec,
                 is_value                                     ? rec->channels[e->c].name
                 : e->class_ == kInputs                       ? name_of_input(e->kind)
                 : e->class_ == kPhases && e->a < rec->phases ? rec->phase_names[e->a]
                                                              : kClassNames[e->class_],
                 kText, "absent");
    set_difference(rec, kClassNames[e->class_], e->class_ == kInputs || e->class_ == kPhases ? 0 : e->a,
                   e->class_ == kPhases ? 0 : e->b);
    return;
  }
  v->has_frame = 0;
  if (rec->started) ++v->steps;
}

/* ---- Bodies. ---- */

static size_t slot_of(const TumbleRec* rec, uint64_t id) {
  size_t slot = (size_t)(hash_round(0, id) >> 20) & (rec->slot_count - 1);
  while (rec->slots[slot] != 0 && rec->bodies[rec->slots[slot] - 1].id != id) slot = (slot + 1) & (rec->slot_count - 1);
  return slot;
}

/* Engines tell bodies in one order, so the next one is tried first. */
static Body* find_body(TumbleRec* rec, uint64_t id) {
  size_t slot;
  if (rec->hint < rec->body_count && rec->bodies[rec->hint].id == id) return &rec->bodies[rec->hint++];
  if (rec->slot_count == 0) return NULL;
  slot = rec->slots[slot_of(rec, id)];
  if (slot == 0) return NULL;
  rec->hint = slot;
  return &rec->bodies[slot - 1];
}

static int index_bodies(TumbleRec* rec, size_t count) {
  size_t k, room = rec->slot_count < 64 ? 64 : rec->slot_count;
  uint32_t* slots;
  while (room < 2 * count + 2) room *= 2;
  slots = (uint32_t*)calloc(room, sizeof *slots);
  if (slots == NULL) {
    fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for %lu bodies", (unsigned long)count);
    return 0;
  }
  free(rec->slots);
  rec->slots = slots;
  rec->slot_count = room;
  for (k = 0; k < rec->body_count; ++k) rec->slots[slot_of(rec, rec->bodies[k].id)] = (uint32_t)(k + 1);
  return 1;
}

static uint64_t* used_slot(uint64_t* used, size_t room, uint64_t id) {
  size_t slot = (size_t)(hash_round(0, id) >> 20) & (room - 1);
  while (used[slot] != 0 && used[slot] != id) slot = (slot + 1) & (room - 1);
  return &used[slot];
}

static int was_used(const TumbleRec* rec, uint64_t id) {
  return rec->used_room != 0 && *used_slot(rec->used, rec->used_room, id) == id;
}

static int remember_id(TumbleRec* rec, uint64_t id) {
  if (2 * rec->used_count + 2 > rec->used_room) {
    const size_t room = rec->used_room == 0 ? 64 : 2 * rec->used_room;
    uint64_t* used = (uint64_t*)calloc(room, sizeof *used);
    size_t k;
    if (used == NULL) {
      fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for the ids of %lu bodies", (unsigned long)room);
      return 0;
    }
    for (k = 0; k < rec->used_room; ++k) {
      if (rec->used[k] != 0) *used_slot(used, room, rec->used[k]) = rec->used[k];
    }
    free(rec->used);
    rec->used = used;
    rec->used_room = room;
  }
  *used_slot(rec->used, rec->used_room, id) = id;
  ++rec->used_count;
  return 1;
}

/* Forgets bodies whose removal no rewind can undo, but for their ids, and those that `added` after a step. */
static int drop_bodies(TumbleRec* rec, uint64_t added_max) {
  size_t k, kept = 0;
  for (k = 0; k < rec->body_count; ++k) {
    Body* body = &rec->bodies[k];
    const int is_over = body->gone && body->removed_at + rec->def.rollback_steps < rec->step;
    if (is_over ? remember_id(rec, body->id) : body->added > added_max) {
      free(body->record);
    } else {
      rec->bodies[kept++] = *body;
    }
  }
  rec->body_count = kept;
  rec->hint = 0;
  return index_bodies(rec, kept) && rec->status == TUMBLE_REC_OK;
}

static Body* new_body(TumbleRec* rec, uint64_t id) {
  Body* body;
  if (rec->body_count == rec->body_room) {
    const size_t room = rec->body_room == 0 ? 64 : 2 * rec->body_room;
    Body* grown = (Body*)realloc(rec->bodies, room * sizeof *grown);
    if (grown == NULL) {
      fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for %lu bodies", (unsigned long)room);
      return NULL;
    }
    rec->bodies = grown;
    rec->body_room = room;
  }
  if (2 * rec->body_count + 2 > rec->slot_count && !index_bodies(rec, rec->body_room)) return NULL;
  body = &rec->bodies[rec->body_count++];
  memset(body, 0, sizeof *body);
  body->id = id;
  rec->slots[slot_of(rec, id)] = (uint32_t)rec->body_count;
  return body;
}

/* The numbers of a state in the order of states64. */
typedef char StateHasNoGaps[offsetof(TumbleRecState, asleep) == 8 * kStateDoubles ? 1 : -1];
static const double* numbers_of(const TumbleRecState* state) { return (const double*)(const void*)state; }

/* As states32, where that loses no bit. */
static int pack32(unsigned char* to, const TumbleRecState* state) {
  const double* numbers = numbers_of(state);
  const double last = (double)(float)numbers[kStateDoubles - 1];
  if (bits_of(last) != bits_of(numbers[kStateDoubles - 1])) return 0; /* most states of doubles end here */
  return put_floats(to, numbers, kStateDoubles) == 0;
}
static unsigned char* put_state64(unsigned char* to, const TumbleRecState* state) {
  return put_doubles(to, numbers_of(state), kStateDoubles);
}
static size_t state_bytes(int wide) { return (wide ? 8 : 4) * (size_t)kStateDoubles; }

static int moves(const Body* body) { return !body->gone && !body->is_static && !body->asleep; }

/* Inputs come before the states of a step. */
static int may_input(TumbleRec* rec, const char* what) {
  if (!rec->after_state) return 1;
  fail(rec, TUMBLE_REC_BAD_CALL, "found %s after a state, wanted the inputs of a step before its states", what);
  return 0;
}

static Body* living(TumbleRec* rec, uint64_t id, const char* what) {
  Body* body = find_body(rec, id);
  if (body != NULL && !body->gone) return body;
  fail(rec, TUMBLE_REC_BAD_CALL, "found %s of body %" PRIu64 ", wanted the id of a body that exists", what, id);
  return NULL;
}

static int has_numbers(TumbleRec* rec, const double* v, const char* what) {
  if (v == NULL) fail(rec, TUMBLE_REC_BAD_CALL, "%s: found NULL, wanted three numbers", what);
  return v != NULL;
}

/* ---- Beginning and end. ---- */

static FILE* refuse(TumbleRec* rec, FILE* file, const char* text, const char* path) {
  fail(rec, TUMBLE_REC_BAD_CALL, text, path);
  if (file != NULL) fclose(file);
  return NULL;
}

/* A file is locked as long as it is written: a second recorder would truncate it and write between the first one's
 * steps. What is no file, as a pipe or a device, is written as it is. */
static FILE* open_for_writing(TumbleRec* rec, const char* path) {
  static const char kNoStream[] = "%s: found a file that is no stream, which is not overwritten; wanted another name";
  static const char kCannot[] = "%s: cannot be written: %s";
  unsigned char magic[kMagicBytes];
  size_t size;
#ifdef HAS_TAIL
  struct stat found;
  const int is_there = stat(path, &found) == 0;
  const int handle = is_there && !S_ISREG(found.st_mode) ? open(path, O_WRONLY | O_CLOEXEC)
                                                         : open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  FILE* file = handle < 0 ? NULL : fdopen(handle, is_there && !S_ISREG(found.st_mode) ? "w" : "r+");
  if (file == NULL) {
    if (handle >= 0) close(handle);
    return fail(rec, TUMBLE_REC_CANNOT_WRITE, kCannot, path, strerror(errno)), NULL;
  }
  setvbuf(file, NULL, _IONBF, 0); /* a frame is one write to the system */
  rec->process = (long)getpid();
  if (is_there && !S_ISREG(found.st_mode)) return file;
  if (flock(handle, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return refuse(rec, file, "%s: found that another recorder writes it now, wanted another name", path);
  size = fread(magic, 1, kMagicBytes, file);
  if (size != 0 && (size != kMagicBytes || memcmp(magic, kMagic, kMagicBytes) != 0))
    return refuse(rec, file, kNoStream, path);
  rewind(file);
  if (!remove_tail(rec, path) || ftruncate(handle, 0) != 0) {
    fail(rec, TUMBLE_REC_CANNOT_WRITE, kCannot, path, strerror(errno));
    return fclose(file), NULL;
  }
#else
  FILE* file = fopen(path, "rb");
  if (file != NULL) {
    size = fread(magic, 1, kMagicBytes, file);
    fclose(file);
    if (size != 0 && (size != kMagicBytes || memcmp(magic, kMagic, kMagicBytes) != 0))
      return refuse(rec, NULL, kNoStream, path);
  }
  file = fopen(path, "wb");
  if (file == NULL) return fail(rec, TUMBLE_REC_CANNOT_WRITE, kCannot, path, strerror(errno)), NULL;
  setvbuf(file, NULL, _IONBF, 0);
#endif
  return file;
}

static int take_phases(TumbleRec* rec, const char* names) {
  rec->phase_names = (char(*)[kNameMax + 1]) calloc(names != NULL ? kPhasesMax : 1, kNameMax + 1);
  if (rec->phase_names == NULL) return fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for phases"), 0;
  while (names != NULL && *names != 0) {
    const size_t size = strcspn(names, ",");
    uint32_t k;
    if (size == 0 || size > kNameMax || rec->phases == kPhasesMax) {
      fail(rec, TUMBLE_REC_BAD_CALL,
           "phases: found a name of %lu bytes as number %lu, wanted at most 256 of 1 to 200 bytes", (unsigned long)size,
           (unsigned long)rec->phases);
      return 0;
    }
    memcpy(rec->phase_names[rec->phases], names, size);
    for (k = 0; k < rec->phases; ++k) { /* an answer that names the phase would be of both */
      if (strcmp(rec->phase_names[k], rec->phase_names[rec->phases]) == 0)
        return fail(rec, TUMBLE_REC_BAD_CALL, "phases: found \"%s\" twice, wanted names that differ",
                    rec->phase_names[k]),
               0;
    }
    ++rec->phases;
    names += size + (names[size] == ',');
  }
  return 1;
}

static int check_def(TumbleRec* rec, const TumbleRecDef* def) {
  const char up = def->up == 0 ? 'z' : def->up;
  const char* const texts[3] = {def->engine, def->version, def->scene};
  int k;
  if (def->engine == NULL || def->engine[0] == 0)
    return fail(rec, TUMBLE_REC_BAD_CALL, "engine: found no name, wanted one"), 0;
  for (k = 0; k < 3; ++k) {
    if (texts[k] == NULL || strlen(texts[k]) <= kNameMax) continue;
    return fail(rec, TUMBLE_REC_BAD_CALL, "found a name of more than 200 bytes, wanted fewer"), 0;
  }
  if (def->precision_bits != 24 && def->precision_bits != 53) {
    return fail(rec, TUMBLE_REC_BAD_CALL, "precision_bits: found %d, wanted 24 (float) or 53 (double)",
                def->precision_bits),
           0;
  }
  if (up != 'x' && up != 'y' && up != 'z')
    return fail(rec, TUMBLE_REC_BAD_CALL, "up: found '%c', wanted x, y or z", up), 0;
  if (!(def->metres >= 0 && def->metres < 1e9)) {
    return fail(rec, TUMBLE_REC_BAD_CALL, "metres: found %g, wanted a number above 0", def->metres), 0;
  }
  if (!(def->ring_s >= 0 && def->ring_s < 1e6))
    return fail(rec, TUMBLE_REC_BAD_CALL, "ring_s: found %g, wanted seconds", def->ring_s), 0;
  if (def->path != NULL && def->path[0] == 0)
    return fail(rec, TUMBLE_REC_BAD_CALL, "path: found an empty name, wanted that of a file"), 0;
  k = (def->path != NULL) + (def->write != NULL) + (def->ring_s > 0);
  if (k > 1 || (k == 0 && def->verify == NULL)) {
    return fail(rec, TUMBLE_REC_BAD_CALL, "found %d of path, write and ring_s, wanted one, or `verify` alone", k), 0;
  }
  if (def->rollback_steps > 0 && def->ring_s > 0) {
    return fail(rec, TUMBLE_REC_BAD_CALL,
                "found rollback_steps with ring_s, wanted one of them: a ring forgets the steps to go back to"),
           0;
  }
  return 1;
}

static int make_header(TumbleRec* rec, const TumbleRecDef* def) {
  Bytes* b = &rec->head;
  const char* const texts[3] = {def->engine, def->version, def->scene};
  uint32_t k;
  unsigned char* at;
  if (!begin_frame(rec, b, 64 + 3 * (kNameMax + 2) + (size_t)rec->phases * (kNameMax + 2))) return 0;
  at = put32(b->at + b->size, (uint32_t)def->precision_bits);
  *at++ = (unsigned char)(def->up == 0 ? 'z' : def->up);
  *at++ = def->left_handed != 0, *at++ = def->ground != 0;
  *at++ = def->hashes_only != 0, *at++ = def->ring_s > 0;
  at = put_doubles(put_double(at, def->metres == 0 ? 1 : def->metres), def->gravity, 3);
  for (k = 0; k < 3; ++k) at = put_text(at, texts[k] != NULL ? texts[k] : "", texts[k] != NULL ? strlen(texts[k]) : 0);
  at = put16(at, rec->phases);
  for (k = 0; k < rec->phases; ++k) at = put_text(at, rec->phase_names[k], strlen(rec->phase_names[k]));
  b->size = (size_t)(at - b->at);
  seal(b->at, b->size, kHeader, 0, 0);
  rec->tag = get64(b->at + 16);
  return 1;
}

static int open_verify(TumbleRec* rec, const char* path) {
  Verify* v = &rec->verify;
  unsigned char prelude[kPreludeBytes];
  const unsigned char* own = rec->head.at + kFrameBytes;
  v->file = fopen(path, "rb");
  if (v->file == NULL) return fail(rec, TUMBLE_REC_BAD_STREAM, "verify: %s: cannot be opened", path), 0;
  v->tail_path = tail_path_of(path);
  if (fread(prelude, 1, kPreludeBytes, v->file) != kPreludeBytes || memcmp(prelude, kMagic, kMagicBytes) != 0) {
    return fail(rec, TUMBLE_REC_BAD_STREAM, "verify: %s: found no stream of this recorder", path), 0;
  }
  if (get32(prelude + kMagicBytes) != kMajor) {
    return fail(rec, TUMBLE_REC_BAD_STREAM, "verify: %s: found format %lu, wanted %d", path,
                (unsigned long)get32(prelude + kMagicBytes), (int)kMajor),
           0;
  }
  if (!next_earlier(rec) || v->kind != kHeader || v->frame.size < 41) {
    return fail(rec, TUMBLE_REC_BAD_STREAM, "verify: %s: found no header", path), 0;
  }
  v->active = 1;
  v->by_hash = v->frame.at[7] != 0;
  v->is_ring = v->frame.at[8] != 0;
  if (memcmp(v->frame.at, own, 7) != 0 || memcmp(v->frame.at + 9, own + 9, 32) != 0) {
    v->frame.at[7] = own[7], v->frame.at[8] = own[8]; /* how it was recorded may differ */
    name_differing_field(rec, kHeaderFields, v->frame.at, 41, own, 41);
    set_difference(rec, "start", 0, 0);
  }
  return 1;
}

TumbleRec* tumble_rec_create(const TumbleRecDef* def) {
  TumbleRec* rec = (TumbleRec*)calloc(1, sizeof *rec);
  unsigned char prelude[kPreludeBytes];
  if (rec == NULL) return NULL;
  if (def == NULL) return fail(rec, TUMBLE_REC_BAD_CALL, "found NULL, wanted a definition"), rec;
  rec->def = *def;
  memcpy(rec->gravity, def->gravity, sizeof rec->gravity);
  if (!check_def(rec, def) || !take_phases(rec, def->phases) || !make_header(rec, def)) return rec;
  if (def->verify != NULL && !open_verify(rec, def->verify)) return rec;
  rec->full = def->hashes_only || rec->verify.by_hash;
  if (def->path != NULL && (rec->file = open_for_writing(rec, def->path)) == NULL) return rec;
  memcpy(prelude, kMagic, kMagicBytes);
  put32(put32(prelude + kMagicBytes, kMajor), kMinor);
  rec->frames = 1;
  if (def->ring_s > 0) {
    rec->ring_count = 1; /* the first part begins with the start */
    if (!reserve(rec, &rec->header, kPreludeBytes + rec->head.size)) return rec;
    memcpy(rec->header.at, prelude, kPreludeBytes);
    memcpy(rec->header.at + kPreludeBytes, rec->head.at, rec->head.size);
    rec->header.size = kPreludeBytes + rec->head.size;
  } else if (give_away(rec, prelude, kPreludeBytes) && give_away(rec, rec->head.at, rec->head.size) &&
             rec->file != NULL) {
    open_tail(rec, def->path);
  }
  if (rec->status == TUMBLE_REC_OK) begin_step_frame(rec);
  return rec;
}

static TumbleRecStatus end_frame(TumbleRec* rec, uint32_t kind) {
  const int before = rec->differs;
  unsigned char* at;
  size_t k;
  if (rec->def.hashes_only) {
    if (!reserve(rec, &rec->frame, 8 * kClasses)) return rec->status;
    at = rec->frame.at + rec->frame.size;
    for (k = 0; k < kClasses; ++k) at = put64(at, rec->hashes[k]);
    rec->frame.size += 8 * kClasses;
  }
  close_earlier(rec);
  if (rec->status == TUMBLE_REC_OK) write_frame(rec, rec->def.hashes_only ? kHashes : kind, &rec->frame);
  if (rec->status != TUMBLE_REC_OK) return rec->status;
  return rec->differs != before ? TUMBLE_REC_DIFFERENT : TUMBLE_REC_OK;
}

/* ---- The ring. ---- */

/* A part begins with all bodies as they are, and so can be read by itself. */
static int begin_part(TumbleRec* rec) {
  Bytes* b = &rec->head;
  size_t k;
  uint32_t c;
  unsigned char* at;
  if (!begin_frame(rec, b, 16 + 28)) return 0;
  at = put_double(put64(b->at + b->size, rec->step), 0);
  at = put_doubles(put32(at, kSetGravity | 24u << 8), rec->gravity, 3);
  b->size = (size_t)(at - b->at);
  for (c = 0; c < rec->channel_count; ++c) {
    const size_t name = strlen(rec->channels[c].name);
    if (!reserve(rec, b, 12 + name)) return 0;
    at = put32(put32(b->at + b->size, kChannel | (uint32_t)(8 + name) << 8), c);
    *at++ = rec->channels[c].scope, *at++ = rec->channels[c].type;
    put_text(at, rec->channels[c].name, name);
    b->size += 12 + name;
  }
  if (!append(rec, b, rec->meshes.at, rec->meshes.size)) return 0;
  for (k = 0; k < rec->body_count; ++k) {
    const Body* body = &rec->bodies[k];
    if (body->gone) continue;
    if (!reserve(rec, b, 4 + body->record_size)) return 0;
    at = put32(b->at + b->size, kBody | (uint32_t)body->record_size << 8);
    memcpy(at, body->record, body->record_size);
    at[8] = (unsigned char)(body->is_static | body->asleep << 1);
    if (body->last_wide)
      memcpy(at + 9, body->last, 8 * kStateDoubles);
    else
      put_widened(at + 9, body->last, kStateDoubles);
    b->size += 4 + body->record_size;
  }
  return write_frame(rec, kStart, b);
}

/* After a step: a new part where the last one is long enough, and the oldest goes where the others are. */
static int turn_ring(TumbleRec* rec, double dt_s) {
  double others = 0;
  size_t k;
  Part oldest;
  rec->ring[rec->ring_count - 1].seconds += dt_s;
  if (rec->ring[rec->ring_count - 1].seconds < rec->def.ring_s / kRingParts) return 1;
  for (k = 1; k < rec->ring_count; ++k) others += rec->ring[k].seconds;
  if (others >= rec->def.ring_s || rec->ring_count == kRingParts + 2) {
    oldest = rec->ring[0];
    memmove(rec->ring, rec->ring + 1, (rec->ring_count - 1) * sizeof *rec->ring);
    oldest.bytes.size = 0;
    oldest.seconds = 0;
    rec->ring[--rec->ring_count] = oldest; /* its memory serves again */
  }
  ++rec->ring_count;
  return begin_part(rec);
}

TumbleRecStatus tumble_rec_dump_to(TumbleRec* rec, TumbleRecWrite write, void* user) {
  unsigned char end[kFrameBytes + 9];
  size_t k;
  if (rec == NULL || write == NULL) return TUMBLE_REC_BAD_CALL;
  if (rec->ring_count == 0 || !rec->started) return TUMBLE_REC_BAD_CALL;
  *put64(end + kFrameBytes, rec->step) = 1;
  seal(end, sizeof end, kEnd, rec->frames, rec->tag);
  if (write(user, rec->header.at, rec->header.size) != 0) return TUMBLE_REC_CANNOT_WRITE;
  for (k = 0; k < rec->ring_count; ++k) {
    if (write(user, rec->ring[k].bytes.at, rec->ring[k].bytes.size) != 0) return TUMBLE_REC_CANNOT_WRITE;
  }
  return write(user, end, sizeof end) != 0 ? TUMBLE_REC_CANNOT_WRITE : TUMBLE_REC_OK;
}

static int write_to_file(void* user, const void* bytes, size_t size) {
  return fwrite(bytes, 1, size, (FILE*)user) == size ? 0 : 1;
}

TumbleRecStatus tumble_rec_dump(TumbleRec* rec, const char* path) {
  TumbleRecStatus status;
  FILE* file;
  if (!enter(rec, &status)) return status;
  if (path == NULL || rec->ring_count == 0 || !rec->started) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found nothing to dump, wanted a path, ring_s and a step"));
  }
  file = open_for_writing(rec, path);
  if (file == NULL) return leave(rec, rec->status);
  status = tumble_rec_dump_to(rec, write_to_file, file);
  if (fclose(file) != 0) status = TUMBLE_REC_CANNOT_WRITE;
  if (status != TUMBLE_REC_OK) fail(rec, status, "%s: cannot be written; is the disk full?", path);
  return leave(rec, status);
}

/* ---- Inputs. ---- */

TumbleRecStatus tumble_rec_body(TumbleRec* rec, const TumbleRecBody* body) {
  TumbleRecStatus status;
  unsigned char* at;
  unsigned char* begin;
  Body* kept;
  size_t name, size;
  if (!enter(rec, &status)) return status;
  if (!may_input(rec, "a body")) return leave(rec, rec->status);
  if (body == NULL) return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found NULL, wanted a body"));
  name = body->name != NULL ? strlen(body->name) : 0;
  if (body->id == 0 || body->id > ID_MAX || find_body(rec, body->id) != NULL || was_used(rec, body->id)) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found body %" PRIu64 ", wanted an id of 1 to 2^53 - 1 that no body had", body->id));
  }
  if (name > kNameMax || (unsigned)body->shape > TUMBLE_REC_MESH) {
    return leave(
        rec, fail(rec, TUMBLE_REC_BAD_CALL,
                  "body %" PRIu64 ": found a name of %lu bytes and shape %d, wanted at most 200 and a TumbleRecShape",
                  body->id, (unsigned long)name, (int)body->shape));
  }
  size = 8 + 1 + 8 * kStateDoubles + 1 + 24 + 8 + 24 + 2 + name;
  kept = new_body(rec, body->id);
  at = kept != NULL ? add(rec, kBody, size, 0) : NULL;
  if (at == NULL) return leave(rec, rec->status);
  kept->is_static = body->is_static != 0;
  kept->asleep = body->state.asleep != 0;
  kept->added = rec->started ? rec->step + 1 : 0;
  kept->last_known = 1;
  kept->last_wide = (unsigned char)!pack32(kept->last, &body->state);
  if (kept->last_wide) put_state64(kept->last, &body->state);
  begin = at;
  at = put64(at, body->id);
  *at++ = (unsigned char)(kept->is_static | kept->asleep << 1);
  at = put_state64(at, &body->state);
  *at++ = (unsigned char)body->shape;
  at = put64(put_doubles(at, body->size, 3), body->mesh_hash);
  at = put_double(put_double(put_double(at, body->mass), body->friction), body->restitution);
  put_text(at, body->name, name);
  if (rec->def.ring_s > 0) {
    kept->record = (unsigned char*)malloc(size);
    if (kept->record == NULL) return leave(rec, fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for a body"));
    memcpy(kept->record, begin, size);
    kept->record_size = size;
  }
  rec->moving += (size_t)moves(kept);
  return leave(rec, entry_done(rec, kBody, begin, size, rec->inputs_told++, 0, 0));
}

TumbleRecStatus tumble_rec_mesh(TumbleRec* rec, uint64_t mesh_hash, const double* points, uint32_t point_count,
                                const uint32_t* triangles, uint32_t triangle_count) {
  TumbleRecStatus status;
  unsigned char* at;
  unsigned char* begin;
  uint32_t k;
  const uint32_t corners = triangles != NULL ? 3 * triangle_count : 0;
  const size_t size = 16 + 24 * (size_t)point_count + 4 * (size_t)corners;
  if (!enter(rec, &status)) return status;
  if (points == NULL || point_count < 3 || point_count > kMeshMax || triangle_count > kMeshMax) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a mesh of %lu points and %lu triangles, wanted 3 to 100000 points and at most 100000",
                           (unsigned long)point_count, (unsigned long)triangle_count));
  }
  for (k = 0; k < corners; ++k) {
    if (triangles[k] >= point_count)
      return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a triangle with point %lu, wanted one of %lu",
                             (unsigned long)triangles[k], (unsigned long)point_count));
  }
  if (rec->def.hashes_only) return leave(rec, TUMBLE_REC_OK);
  begin = add(rec, kMesh, size, 0);
  if (begin == NULL) return leave(rec, rec->status);
  at = put_doubles(put32(put32(put64(begin, mesh_hash), point_count), corners), points, (int)(3 * point_count));
  for (k = 0; k < corners; ++k) at = put32(at, triangles[k]);
  if (rec->def.ring_s > 0) append(rec, &rec->meshes, begin - 4, size + 4);
  return leave(rec, rec->status);
}

/* The start is all that was told so far; what comes next is of step 1. */
static TumbleRecStatus end_start(TumbleRec* rec) {
  TumbleRecStatus status;
  if (rec->started) return TUMBLE_REC_OK;
  status = end_frame(rec, kStart);
  rec->started = 1;
  if (rec->status == TUMBLE_REC_OK) begin_step_frame(rec);
  return rec->status != TUMBLE_REC_OK ? rec->status : status;
}

/* An input of one body: a removal without vectors, a push of u, a velocity u with a spin v. */
static TumbleRecStatus input_of(TumbleRec* rec, int kind, const char* what, uint64_t id, const double* u,
                                const double* v) {
  TumbleRecStatus status, start;
  unsigned char* at;
  Body* body;
  const size_t size = 8 + (kind == kRemove ? 0u : kind == kPush ? 24u : 48u);
  if (!enter(rec, &status)) return status;
  if ((kind != kRemove && !has_numbers(rec, u, what)) || (kind == kSetVelocity && !has_numbers(rec, v, what)))
    return leave(rec, rec->status);
  if (!may_input(rec, what) || (body = living(rec, id, what)) == NULL) return leave(rec, rec->status);
  start = end_start(rec);
  at = rec->status == TUMBLE_REC_OK ? add(rec, kind, size, 0) : NULL;
  if (at == NULL) return leave(rec, rec->status);
  put64(at, id);
  if (kind != kRemove) put_doubles(at + 8, u, 3);
  if (kind == kSetVelocity) put_doubles(at + 32, v, 3);
  if (kind == kRemove) {
    rec->moving -= (size_t)moves(body);
    body->gone = 1;
    body->removed_at = rec->step + 1;
  } else if (body->asleep && !body->is_static) { /* it wakes */
    body->asleep = 0;
    ++rec->moving;
  }
  status = entry_done(rec, kind, at, size, rec->inputs_told++, 0, 0);
  return leave(rec, status == TUMBLE_REC_OK ? start : status);
}

TumbleRecStatus tumble_rec_remove(TumbleRec* rec, uint64_t id) {
  return input_of(rec, kRemove, "a removal", id, NULL, NULL);
}

TumbleRecStatus tumble_rec_push(TumbleRec* rec, uint64_t id, const double impulse[3]) {
  return input_of(rec, kPush, "a push", id, impulse, NULL);
}

TumbleRecStatus tumble_rec_set_velocity(TumbleRec* rec, uint64_t id, const double velocity[3], const double spin[3]) {
  return input_of(rec, kSetVelocity, "a velocity", id, velocity, spin);
}

TumbleRecStatus tumble_rec_set_gravity(TumbleRec* rec, const double gravity[3]) {
  TumbleRecStatus status;
  unsigned char* at;
  if (!enter(rec, &status)) return status;
  if (!has_numbers(rec, gravity, "a gravity") || !may_input(rec, "a gravity") ||
      (at = add(rec, kSetGravity, 24, 0)) == NULL)
    return leave(rec, rec->status);
  put_doubles(at, gravity, 3);
  memcpy(rec->gravity, gravity, sizeof rec->gravity);
  return leave(rec, entry_done(rec, kSetGravity, at, 24, rec->inputs_told++, 0, 0));
}

TumbleRecStatus tumble_rec_input(TumbleRec* rec, const char* name, uint64_t body, const void* bytes, size_t size) {
  TumbleRecStatus status;
  unsigned char* at;
  const size_t length = name != NULL ? strlen(name) : 0;
  if (!enter(rec, &status)) return status;
  if (!may_input(rec, "an input") || (body != 0 && living(rec, body, "an input") == NULL))
    return leave(rec, rec->status);
  if (length == 0 || length > kNameMax || (bytes == NULL && size > 0) || size > kRecordMax) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found an input without a name or bytes or of more than 16 MiB, wanted a name of 1 to 200 "
                           "bytes"));
  }
  at = add(rec, kInput, 10 + length + size, 0);
  if (at == NULL) return leave(rec, rec->status);
  if (size > 0)
    memcpy(put_text(put64(at, body), name, length), bytes, size);
  else
    put_text(put64(at, body), name, length);
  return leave(rec, entry_done(rec, kInput, at, 10 + length + size, rec->inputs_told++, 0, 0));
}

/* ---- Steps. ---- */

TumbleRecStatus tumble_rec_step_begin(TumbleRec* rec, double dt_s) {
  TumbleRecStatus status, start;
  if (!enter(rec, &status)) return status;
  if (rec->in_step)
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found step_begin twice, wanted step_end between"));
  if (!(dt_s >= 1e-7 && dt_s <= 1)) /* what a log can hold */
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a dt of %g s, wanted 1e-07 to 1 s", dt_s));
  start = end_start(rec);
  if (rec->status != TUMBLE_REC_OK) return leave(rec, rec->status);
  put_double(rec->frame.at + kFrameBytes + 8, dt_s);
  rec->in_step = 1;
  rec->moving_told = rec->woken = rec->slept = 0;
  rec->hint = 0;
  ++rec->serial, rec->told_count = 0;
  return leave(rec, start);
}

static void verify_told(TumbleRec* rec, const Body* body, const unsigned char* now, int wide, int asleep, int kind) {
  Entry key;
  Entry* e;
  memset(&key, 0, sizeof key);
  key.class_ = kStates;
  key.a = body->id;
  e = find_entry(rec, &key);
  if (e != NULL) {
    e->seen = 1;
    verify_state(rec, e, body, now, wide, asleep);
  } else if (rec->status == TUMBLE_REC_OK && kind != kSame) {
    name_field(rec, "state", "absent", "present");
    set_difference(rec, kClassNames[kStates], body->id, 0);
  }
}

/* A state is written as the last one, as floats or as doubles: the first that loses nothing. */
TumbleRecStatus tumble_rec_state(TumbleRec* rec, uint64_t id, const TumbleRecState* state) {
  TumbleRecStatus status;
  unsigned char now[8 * kStateDoubles];
  unsigned char* at;
  Body* body;
  size_t size;
  int kind, asleep, wide, before;
  if (!enter(rec, &status)) return status;
  if (!rec->in_step || state == NULL) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a state of body %" PRIu64 " outside a step, wanted step_begin before", id));
  }
  body = living(rec, id, "a state");
  if (body == NULL) return leave(rec, rec->status);
  if (body->told == rec->serial)
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found two states of body %" PRIu64 " in a step, wanted one", id));
  before = rec->differs;
  asleep = state->asleep != 0 && !body->is_static;
  wide = rec->full || !pack32(now, state);
  if (wide) put_state64(now, state);
  kind = wide ? kStates64 : kStates32;
  if (!rec->full && body->last_known && asleep == body->asleep && wide == body->last_wide &&
      (wide ? memcmp(body->last, now, state_bytes(1)) : memcmp(body->last, now, state_bytes(0))) == 0) {
    kind = kSame;
  }
  size = kind == kSame ? 8 : kind == kStates32 ? 9 + 4 * kStateDoubles : 9 + 8 * kStateDoubles;
  at = add(rec, kind, size, 1);
  if (at == NULL) return leave(rec, rec->status);
  put64(at, id);
  if (kind != kSame) at[8] = (unsigned char)asleep;
  if (kind == kStates32) memcpy(at + 9, now, state_bytes(0));
  if (kind == kStates64) memcpy(at + 9, now, state_bytes(1));
  if (rec->verify.active && open_earlier(rec) && !rec->verify.by_hash) {
    verify_told(rec, body, now, wide, asleep, kind);
  }
  if (rec->full) entry_done(rec, kind, at, size, id, 0, 0);
  rec->moving_told += (size_t)moves(body);
  rec->woken += (size_t)(body->asleep && !asleep), rec->slept += (size_t)(asleep && !body->asleep);
  body->told = rec->serial;
  body->asleep = (unsigned char)asleep;
  body->last_known = 1;
  body->last_wide = (unsigned char)wide;
  if (kind == kStates32) memcpy(body->last, now, state_bytes(0));
  if (kind == kStates64) memcpy(body->last, now, state_bytes(1));
  rec->after_state = 1;
  return leave(rec, rec->differs != before ? TUMBLE_REC_DIFFERENT : TUMBLE_REC_OK);
}

static void put_contact64(unsigned char* to, const TumbleRecContact* contact) {
  uint32_t k;
  to = put32(put64(put64(to, contact->a), contact->b), contact->part);
  to = put32(put_doubles(to, contact->normal, 3), contact->point_count);
  for (k = 0; k < contact->point_count; ++k) {
    to = put_doubles(to, contact->points[k].position, 3);
    to = put_double(put_double(to, contact->points[k].depth), contact->points[k].impulse);
  }
}

/* In half the bytes, over the room of the whole contact. 0: that would lose bits, and the room holds neither. */
typedef char PointIsFiveDoubles[sizeof(TumbleRecPoint) == 40 ? 1 : -1];
static int put_contact32(TumbleRec* rec, unsigned char* begin, const TumbleRecContact* contact) {
  const size_t numbers = 5 * (size_t)contact->point_count;
  unsigned char* to = put32(put64(put64(begin, contact->a), contact->b), contact->part);
  if (put_floats(to, contact->normal, 3) != 0) return 0;
  to = put32(to + 12, contact->point_count);
  if (numbers > 0 && put_floats(to, (const double*)(const void*)contact->points, numbers) != 0) return 0;
  to += 4 * numbers;
  put32(begin - 4, kContact32 | (uint32_t)(to - begin) << 8);
  rec->frame.size = (size_t)(to - rec->frame.at);
  return 1;
}

TumbleRecStatus tumble_rec_contact(TumbleRec* rec, const TumbleRecContact* contact) {
  TumbleRecStatus status;
  unsigned char* begin;
  size_t size;
  if (!enter(rec, &status)) return status;
  status = TUMBLE_REC_OK;
  if (contact == NULL || (contact->points == NULL && contact->point_count > 0) || contact->point_count > kPointsMax) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a contact without points, wanted at most 4096"));
  }
  if (rec->started && !rec->in_step)
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a contact between steps, wanted step_begin before"));
  if (contact->a == 0)
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a contact of body 0 as a, wanted a body; b is the ground"));
  if (living(rec, contact->a, "a contact") == NULL) return leave(rec, rec->status);
  if (contact->b != 0 && living(rec, contact->b, "a contact") == NULL) return leave(rec, rec->status);
  if (contact->a == contact->b) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a contact of body %" PRIu64 " with itself, wanted another",
                           contact->a));
  }
  size = 48 + 40 * (size_t)contact->point_count;
  begin = add(rec, kContact, size, 0);
  if (begin == NULL) return leave(rec, rec->status);
  if (rec->full || rec->verify.active) {
    put_contact64(begin, contact);
    status = entry_done(rec, kContact, begin, size, contact->a, contact->b, contact->part);
  }
  if (!rec->full && !put_contact32(rec, begin, contact)) put_contact64(begin, contact);
  return leave(rec, status);
}

TumbleRecStatus tumble_rec_phase_hash(TumbleRec* rec, uint32_t phase, uint64_t hash) {
  TumbleRecStatus status;
  unsigned char* at;
  uint32_t row;
  if (!enter(rec, &status)) return status;
  if (!rec->in_step || phase >= rec->phases || rec->phase_rows[phase] == kRowsMax) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a hash of phase %lu, wanted one of %lu phases, in a step, at most 16 times",
                           (unsigned long)phase, (unsigned long)rec->phases));
  }
  at = add(rec, kPhase, 16, 0);
  if (at == NULL) return leave(rec, rec->status);
  row = rec->phase_rows[phase]++;
  put64(put32(put32(at, phase), row), hash);
  return leave(rec, entry_done(rec, kPhase, at, 16, phase, row, 0));
}

TumbleRecStatus tumble_rec_step_end(TumbleRec* rec) {
  TumbleRecStatus status;
  size_t k;
  double dt;
  if (!enter(rec, &status)) return status;
  if (!rec->in_step) return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found step_end without step_begin"));
  for (k = 0; k < rec->body_count && rec->moving_told != rec->moving; ++k) {
    if (!moves(&rec->bodies[k]) || rec->bodies[k].told == rec->serial) continue;
    return leave(rec,
                 fail(rec, TUMBLE_REC_BAD_CALL,
                      "found no state of body %" PRIu64 ", wanted one of every body that is neither static nor asleep",
                      rec->bodies[k].id));
  }
  dt = get_double(rec->frame.at + kFrameBytes + 8);
  status = end_frame(rec, kStep);
  if (rec->status != TUMBLE_REC_OK) return leave(rec, rec->status);
  rec->in_step = 0;
  ++rec->step;
  rec->moving = rec->moving + rec->woken - rec->slept;
  if (rec->body_count > 64 && rec->step % 256 == 0 && !drop_bodies(rec, UINT64_MAX)) return leave(rec, rec->status);
  if (rec->def.ring_s > 0 && !turn_ring(rec, dt)) return leave(rec, rec->status);
  begin_step_frame(rec);
  return leave(rec, status);
}

/* ---- Channels, notes, snapshots. ---- */

TumbleRecStatus tumble_rec_channel(TumbleRec* rec, const char* name, TumbleRecScope scope, TumbleRecType type,
                                   uint32_t* channel) {
  TumbleRecStatus status;
  unsigned char* at;
  Channel* made;
  const size_t length = name != NULL ? strlen(name) : 0;
  uint32_t k;
  if (!enter(rec, &status)) return status;
  if (length == 0 || length > kNameMax || (unsigned)scope > TUMBLE_REC_OF_PAIR || (unsigned)type > TUMBLE_REC_TEXT ||
      channel == NULL) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a channel of a wrong scope, type or name, wanted a name of 1 to 200 bytes"));
  }
  for (k = 0; k < length; ++k) {
    if ((unsigned char)name[k] >= 32 && name[k] != '=' && name[k] != 127) continue;
    return leave(
        rec, fail(rec, TUMBLE_REC_BAD_CALL, "channel \"%s\": found a '=' or a control character, wanted none", name));
  }
  for (k = 0; k < rec->channel_count; ++k) {
    if (strcmp(rec->channels[k].name, name) == 0)
      return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found channel \"%s\" twice, wanted one of a name", name));
  }
  if (rec->in_step || rec->channel_count == kChannelsMax) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a new channel in a step or 4096 of them, wanted fewer, between steps"));
  }
  if (rec->channel_count == rec->channel_room) {
    const uint32_t room = rec->channel_room == 0 ? 16 : 2 * rec->channel_room;
    made = (Channel*)realloc(rec->channels, room * sizeof *made);
    if (made == NULL) return leave(rec, fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for channels"));
    rec->channels = made;
    rec->channel_room = room;
  }
  at = add(rec, kChannel, 8 + length, 0);
  if (at == NULL) return leave(rec, rec->status);
  made = &rec->channels[rec->channel_count];
  memcpy(made->name, name, length + 1);
  made->scope = (unsigned char)scope, made->type = (unsigned char)type;
  put32(at, rec->channel_count);
  at[4] = made->scope, at[5] = made->type;
  put_text(at + 6, name, length);
  *channel = rec->channel_count++;
  return leave(rec, entry_done(rec, kChannel, at, 8 + length, *channel, 0, UINT32_MAX));
}

/* The place of a value in `told`: its own, or a free one. */
static Told* told_place(const TumbleRec* rec, uint32_t channel, uint64_t a, uint64_t b) {
  const uint64_t mixed = (a * 0x9e3779b97f4a7c15U ^ b * 0xc2b2ae3d27d4eb4fU ^ channel * 0x165667b19e3779f9U);
  size_t k = (size_t)(mixed >> 20) & (rec->told_room - 1);
  for (;; k = (k + 1) & (rec->told_room - 1)) {
    Told* told = &rec->told[k];
    if (told->serial != rec->serial + 1) return told;
    if (told->channel == channel && told->a == a && told->b == b) return told;
  }
}

/* Notes that a value was told in this step. 0: it was before, or there is no memory. */
static int tell_once(TumbleRec* rec, uint32_t channel, uint64_t a, uint64_t b) {
  Told* told;
  if (2 * rec->told_count >= rec->told_room) {
    Told* old = rec->told;
    const size_t old_room = rec->told_room;
    size_t k;
    rec->told_room = old_room == 0 ? 64 : 2 * old_room;
    rec->told = (Told*)calloc(rec->told_room, sizeof *rec->told);
    if (rec->told == NULL) {
      rec->told = old, rec->told_room = old_room;
      fail(rec, TUMBLE_REC_NO_MEMORY, "found no memory for values");
      return 0;
    }
    for (k = 0; k < old_room; ++k) {
      if (old[k].serial == rec->serial + 1) *told_place(rec, old[k].channel, old[k].a, old[k].b) = old[k];
    }
    free(old);
  }
  told = told_place(rec, channel, a, b);
  if (told->serial == rec->serial + 1) {
    fail(rec, TUMBLE_REC_BAD_CALL,
         "channel \"%s\": found a second value of bodies %" PRIu64 " and %" PRIu64 " in a step, wanted one",
         rec->channels[channel].name, a, b);
    return 0;
  }
  told->a = a, told->b = b, told->channel = channel, told->serial = rec->serial + 1;
  ++rec->told_count;
  return 1;
}

/* The numbers of a channel, little-endian. */
static void put_values(unsigned char* to, int type, const void* values, uint32_t count) {
  uint32_t k;
  if (type >= TUMBLE_REC_BYTES && count > 0) memcpy(to, values, count);
  for (k = 0; k < count && type < TUMBLE_REC_BYTES; ++k) {
    if (value_bytes(type) == 4) {
      uint32_t bits;
      memcpy(&bits, (const char*)values + 4 * (size_t)k, 4);
      to = put32(to, bits);
    } else {
      uint64_t bits;
      memcpy(&bits, (const char*)values + 8 * (size_t)k, 8);
      to = put64(to, bits);
    }
  }
}

TumbleRecStatus tumble_rec_value(TumbleRec* rec, uint32_t channel, uint64_t a, uint64_t b, const void* values,
                                 uint32_t count) {
  TumbleRecStatus status;
  unsigned char* at;
  int scope, type;
  size_t size;
  if (!enter(rec, &status)) return status;
  if (channel >= rec->channel_count || (values == NULL && count > 0)) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a value of channel %lu, wanted one of %lu",
                           (unsigned long)channel, (unsigned long)rec->channel_count));
  }
  if (rec->started && !rec->in_step)
    return leave(
        rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a value of channel \"%s\" between steps, wanted step_begin before",
                  rec->channels[channel].name));
  scope = rec->channels[channel].scope, type = rec->channels[channel].type;
  if ((scope == TUMBLE_REC_WORLD) != (a == 0) || (b != 0) != (scope == TUMBLE_REC_OF_PAIR) || (a != 0 && a == b)) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "channel \"%s\": found bodies %" PRIu64 " and %" PRIu64 ", wanted those of its scope",
                           rec->channels[channel].name, a, b));
  }
  if ((a != 0 && living(rec, a, "a value") == NULL) || (b != 0 && living(rec, b, "a value") == NULL))
    return leave(rec, rec->status);
  if (!tell_once(rec, channel, a, b)) return leave(rec, rec->status);
  size = 25 + value_bytes(type) * (size_t)count;
  at = add(rec, kValue, size, 0);
  if (at == NULL) return leave(rec, rec->status);
  put64(put64(put32(at, channel), a), b);
  at[20] = (unsigned char)type;
  put32(at + 21, count);
  put_values(at + 25, type, values, count);
  return leave(rec, entry_done(rec, kValue, at, size, a, b, channel));
}

static TumbleRecStatus one_value(TumbleRec* rec, uint32_t channel, TumbleRecType type, uint64_t a, const void* value,
                                 uint32_t count) {
  if (rec != NULL && channel < rec->channel_count && rec->channels[channel].type != (unsigned char)type) {
    TumbleRecStatus status;
    if (!enter(rec, &status)) return status;
    return leave(
        rec, fail(rec, TUMBLE_REC_BAD_CALL, "channel \"%s\": found a value of another type than it was declared with",
                  rec->channels[channel].name));
  }
  return tumble_rec_value(rec, channel, a, 0, value, count);
}

TumbleRecStatus tumble_rec_f64(TumbleRec* rec, uint32_t channel, uint64_t a, double value) {
  return one_value(rec, channel, TUMBLE_REC_F64, a, &value, 1);
}

TumbleRecStatus tumble_rec_i64(TumbleRec* rec, uint32_t channel, uint64_t a, int64_t value) {
  return one_value(rec, channel, TUMBLE_REC_I64, a, &value, 1);
}

TumbleRecStatus tumble_rec_text(TumbleRec* rec, uint32_t channel, uint64_t a, const char* value) {
  return one_value(rec, channel, TUMBLE_REC_TEXT, a, value, value != NULL ? (uint32_t)strlen(value) : 0);
}

TumbleRecStatus tumble_rec_note(TumbleRec* rec, const char* text) {
  TumbleRecStatus status;
  unsigned char* at;
  const size_t size = text != NULL ? strlen(text) : 0;
  if (!enter(rec, &status)) return status;
  if (size == 0 || size > kTextMax)
    return leave(rec,
                 fail(rec, TUMBLE_REC_BAD_CALL, "found a note of %lu bytes, wanted 1 to 65535", (unsigned long)size));
  if (rec->def.hashes_only) return leave(rec, TUMBLE_REC_OK);
  at = add(rec, kNote, size, 0);
  if (at != NULL) memcpy(at, text, size), rec->notes_told = 1;
  return leave(rec, rec->status);
}

TumbleRecStatus tumble_rec_snapshot(TumbleRec* rec, const char* name, const void* bytes, size_t size) {
  TumbleRecStatus status;
  const size_t length = name != NULL ? strlen(name) : 0;
  Bytes* b;
  if (!enter(rec, &status)) return status;
  if (rec->in_step || !rec->started || length > kNameMax || (bytes == NULL && size > 0) || size > FRAME_MAX) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a snapshot in a step, before the first or of more than 256 MiB, wanted it between "
                           "steps"));
  }
  if (name != NULL && strcmp(name, kRefusedName) == 0)
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a snapshot called \"%s\", wanted another name", name));
  b = &rec->head;
  if (rec->def.hashes_only) return leave(rec, TUMBLE_REC_OK);
  if (!begin_frame(rec, b, 10 + length + size)) return leave(rec, rec->status);
  put_text(put64(b->at + kFrameBytes, rec->step), name, length);
  if (size > 0) memcpy(b->at + kFrameBytes + 10 + length, bytes, size);
  b->size += 10 + length + size;
  write_frame(rec, kSnapshot, b);
  return leave(rec, rec->status);
}

TumbleRecStatus tumble_rec_rewind(TumbleRec* rec, uint64_t step) {
  TumbleRecStatus status;
  const int before = rec != NULL ? rec->differs : 0;
  size_t k;
  if (!enter(rec, &status)) return status;
  if (rec->in_step || !rec->started || step > rec->step || rec->step - step > rec->def.rollback_steps) {
    return leave(rec, fail(rec, TUMBLE_REC_BAD_CALL,
                           "found a rewind to step %" PRIu64
                           ", wanted a step at most rollback_steps (%lu) before, between steps",
                           step, (unsigned long)rec->def.rollback_steps));
  }
  if (rec->inputs_told > 0)
    return leave(
        rec, fail(rec, TUMBLE_REC_BAD_CALL, "found a rewind after inputs of the coming step, wanted it before them"));
  if (rec->verify.active) {
    if (!next_earlier(rec)) {
      rec->verify.active = 0;
    } else if (rec->verify.kind != kRewind || rec->verify.frame.size < 8 || get64(rec->verify.frame.at) != step) {
      name_field(rec, "what comes next", rec->verify.kind == kRewind ? "a rewind to another step" : "a step",
                 "a rewind");
      set_difference(rec, "order", 0, 0);
    }
  }
  if (!begin_frame(rec, &rec->head, 8)) return leave(rec, rec->status);
  put64(rec->head.at + kFrameBytes, step);
  rec->head.size += 8;
  if (!write_frame(rec, kRewind, &rec->head)) return leave(rec, rec->status);
  rec->step = step;
  if (!drop_bodies(rec, step)) return leave(rec, rec->status);
  for (rec->moving = 0, k = 0; k < rec->body_count; ++k) { /* every body tells its state again */
    Body* body = &rec->bodies[k];
    if (body->gone && body->removed_at > step) body->gone = 0;
    body->last_known = 0; /* "same" would be as a step that is taken back */
    body->asleep = 0;
    rec->moving += (size_t)moves(body);
  }
  begin_step_frame(rec);
  return leave(rec, rec->status != TUMBLE_REC_OK ? rec->status
                    : rec->differs != before     ? TUMBLE_REC_DIFFERENT
                                                 : TUMBLE_REC_OK);
}

/* ---- What there is to ask, and the end. ---- */

uint64_t tumble_rec_step(const TumbleRec* rec) { return rec != NULL ? rec->step : 0; }
uint64_t tumble_rec_steps_verified(const TumbleRec* rec) { return rec != NULL ? rec->verify.steps : 0; }
const char* tumble_rec_message(const TumbleRec* rec) {
  const void* user;
  if (rec == NULL) return "found NULL, wanted a recorder";
  user = LOAD((void**)&rec->user_thread); /* another thread may write the message now */
  return user == NULL || user == &thread_mark ? rec->message : kTwoThreads;
}
const TumbleRecDifference* tumble_rec_difference(const TumbleRec* rec) {
  return rec != NULL && rec->differs ? &rec->difference : NULL;
}

TumbleRecStatus tumble_rec_flush(TumbleRec* rec) {
  TumbleRecStatus status;
  if (!enter(rec, &status)) return status;
  flush(rec);
  return leave(rec, rec->status);
}

TumbleRecStatus tumble_rec_finish(TumbleRec* rec) {
  TumbleRecStatus status;
  int is_whole;
  if (rec != NULL && rec->finished && rec->status == TUMBLE_REC_OK)
    return rec->differs ? TUMBLE_REC_DIFFERENT : TUMBLE_REC_OK;
  if (!enter(rec, &status)) return status;
  if (rec->in_step || rec->inputs_told > 0) {
    if (rec->started) fail(rec, TUMBLE_REC_BAD_CALL, "was begun but not ended, wanted step_end before the end");
  }
  if (!rec->started && rec->status == TUMBLE_REC_OK) {
    end_frame(rec, kStart);
    rec->started = 1;
  }
  is_whole = rec->status == TUMBLE_REC_OK && rec->def.ring_s == 0;
  if (is_whole && rec->notes_told)
    fail(rec, TUMBLE_REC_BAD_CALL, "found a note after the last step, wanted it before step_end");
  if (rec->status != TUMBLE_REC_OK) tell_refusal(rec);
  if (is_whole && begin_frame(rec, &rec->head, 9)) {
    *put64(rec->head.at + kFrameBytes, rec->step) = 0;
    rec->head.size += 9;
    write_frame(rec, kEnd, &rec->head);
  }
  rec->is_closed = 1;
  flush(rec);
  if (rec->file != NULL && fclose(rec->file) != 0)
    fail(rec, TUMBLE_REC_CANNOT_WRITE, "found that the file cannot be closed; is the disk full?");
  rec->file = NULL;
  close_tail(rec);
  if (rec->status == TUMBLE_REC_OK) rec->finished = 1;
  return leave(rec, rec->differs ? TUMBLE_REC_DIFFERENT : TUMBLE_REC_OK);
}

TumbleRecStatus tumble_rec_close(TumbleRec* rec) {
  TumbleRecStatus status;
  size_t k;
  if (rec == NULL) return TUMBLE_REC_OK;
  status = tumble_rec_finish(rec);
  if (rec->file != NULL) fclose(rec->file);
  if (rec->verify.file != NULL) fclose(rec->verify.file);
  for (k = 0; k < rec->body_count; ++k) free(rec->bodies[k].record);
  for (k = 0; k < kRingParts + 2; ++k) free(rec->ring[k].bytes.at);
  free(rec->bodies), free(rec->slots), free(rec->used), free(rec->channels), free(rec->told), free(rec->phase_names);
  close_tail(rec);
  free(rec->frame.at), free(rec->head.at), free(rec->header.at), free(rec->pending.at), free(rec->meshes.at);
  free(rec->tail.path), free(rec->verify.tail_path);
  free(rec->verify.frame.at), free(rec->verify.wide.at), free(rec->verify.entries), free((void*)rec->verify.sorted);
  free(rec);
  return status;
}
