#include "tumble_probe.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The file: 8 bytes of magic, then records of one letter and little-endian numbers. docs/zoom.md specifies it. */
static const char kMagic[8] = {'T', 'M', 'B', 'L', 'P', 'R', 'B', '1'};

enum { kTextMax = 1000, kProbesMax = 50000000 };

TumbleProbes tumble_probes = {0, 0, UINT64_MAX, 0, 0, 0, NULL, 0};

/* Of the next file; files are opened by one thread. */
static uint32_t next_generation = 1;

static void lock(TumbleProbes* probes) {
#if defined(__GNUC__)
  while (__atomic_exchange_n(&probes->lock, 1, __ATOMIC_ACQUIRE) != 0) {
  }
#else
  (void)probes;
#endif
}

static void unlock(TumbleProbes* probes) {
#if defined(__GNUC__)
  __atomic_store_n(&probes->lock, 0, __ATOMIC_RELEASE);
#else
  (void)probes;
#endif
}

static void put(unsigned char** to, uint64_t value, int bytes) {
  int i;
  for (i = 0; i < bytes; ++i) *(*to)++ = (unsigned char)(value >> (8 * i));
}

static void write_bytes(TumbleProbes* probes, const void* bytes, size_t size) {
  if (fwrite(bytes, 1, size, (FILE*)probes->file) != size) probes->failed = 1;
}

static void write_number(TumbleProbes* probes, char letter, uint64_t value) {
  unsigned char record[9];
  unsigned char* at = record;
  put(&at, (unsigned char)letter, 1);
  put(&at, value, 8);
  write_bytes(probes, record, sizeof record);
}

static void write_site(TumbleProbes* probes, TumbleProbeSite* site) {
  unsigned char record[13];
  unsigned char* at = record;
  size_t name = strlen(site->name), file = strlen(site->file);
  if (name > kTextMax) name = kTextMax;
  if (file > kTextMax) file = kTextMax;
  site->number = probes->site_count++;
  site->generation = probes->generation;
  put(&at, 'S', 1);
  put(&at, site->number, 4);
  put(&at, site->line, 4);
  put(&at, name, 2);
  put(&at, file, 2);
  write_bytes(probes, record, sizeof record);
  write_bytes(probes, site->name, name);
  write_bytes(probes, site->file, file);
}

uint64_t tumble_probe_bits(double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

void tumble_probes_write(TumbleProbes* probes, TumbleProbeSite* site, int kind, uint64_t a, uint64_t b, uint64_t bits) {
  unsigned char record[30];
  unsigned char* at = record;
  lock(probes);
  if (probes->file != NULL && ++probes->count <= kProbesMax) {
    if (site->generation != probes->generation) write_site(probes, site);
    put(&at, 'P', 1);
    put(&at, site->number, 4);
    put(&at, (uint64_t)kind, 1);
    put(&at, a, 8);
    if (kind & TUMBLE_PROBE_OF_PAIR) put(&at, b, 8);
    put(&at, bits, 8);
    write_bytes(probes, record, (size_t)(at - record));
  }
  unlock(probes);
}

int tumble_probes_open(TumbleProbes* probes, const char* path, uint64_t step) {
  memset(probes, 0, sizeof *probes);
  probes->wanted = UINT64_MAX;
  probes->file = fopen(path, "wb");
  if (probes->file == NULL) return -1;
  probes->wanted = step;
  probes->generation = next_generation++;
  write_bytes(probes, kMagic, sizeof kMagic);
  return probes->failed ? -1 : 0;
}

int tumble_probes_from_environment(TumbleProbes* probes) {
  const char* path = getenv("TUMBLE_PROBE_FILE");
  const char* step = getenv("TUMBLE_PROBE_STEP");
  if (path == NULL || step == NULL) return 0;
  return tumble_probes_open(probes, path, (uint64_t)strtoull(step, NULL, 10));
}

static void end_step(TumbleProbes* probes) {
  if (!probes->on) return;
  probes->on = 0;
  write_number(probes, 'E', probes->count);
  if (fflush((FILE*)probes->file) != 0) probes->failed = 1;
}

void tumble_probes_step(TumbleProbes* probes, uint64_t step) {
  if (probes->file == NULL) return;
  end_step(probes);
  if (step != probes->wanted) return;
  probes->count = 0;
  write_number(probes, 'B', step);
  probes->on = 1;
}

int tumble_probes_close(TumbleProbes* probes) {
  int failed;
  if (probes->file == NULL) return 0;
  end_step(probes);
  failed = probes->failed;
  if (fclose((FILE*)probes->file) != 0) failed = 1;
  probes->file = NULL;
  probes->wanted = UINT64_MAX;
  return failed ? -1 : 0;
}
