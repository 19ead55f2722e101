#include "tests/support/faulty_files.h"

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>

namespace {

using tumble::test::FileFaults;
using tumble::test::kNever;

// Set while no other thread runs; the counters are also the log writer's thread's.
FileFaults faults;
std::atomic<int> writes;
std::atomic<int> reads;
std::atomic<int> syncs;
std::atomic<int> calls;
std::atomic<int> interruptions;

bool fails(int error) {
  if (error != 0) errno = error;
  return error != 0;
}

bool interrupted() {
  if (faults.interrupt_every == kNever || (++calls % faults.interrupt_every) != 0) return false;
  ++interruptions;
  errno = EINTR;
  return true;
}

}  // namespace

// The linker's --wrap gives these names to the calls and to what they would have called; the labels keep them out of
// our code.
extern "C" {
int real_open(const char* path, int flags, mode_t mode) __asm__("__real_open");
ssize_t real_write(int file, const void* bytes, size_t count) __asm__("__real_write");
ssize_t real_pread(int file, void* bytes, size_t count, off_t offset) __asm__("__real_pread");
int real_fdatasync(int file) __asm__("__real_fdatasync");
int real_ftruncate(int file, off_t size) __asm__("__real_ftruncate");
int real_rename(const char* from, const char* to) __asm__("__real_rename");

int faulty_open(const char* path, int flags, mode_t mode) __asm__("__wrap_open");
ssize_t faulty_write(int file, const void* bytes, size_t count) __asm__("__wrap_write");
ssize_t faulty_pread(int file, void* bytes, size_t count, off_t offset) __asm__("__wrap_pread");
int faulty_fdatasync(int file) __asm__("__wrap_fdatasync");
int faulty_ftruncate(int file, off_t size) __asm__("__wrap_ftruncate");
int faulty_rename(const char* from, const char* to) __asm__("__wrap_rename");

int faulty_open(const char* path, int flags, mode_t mode) {
  const bool writing = (flags & (O_WRONLY | O_RDWR)) != 0;
  return writing && fails(faults.open_error) ? -1 : real_open(path, flags, mode);
}

ssize_t faulty_write(int file, const void* bytes, size_t count) {
  if (interrupted()) return -1;
  if (writes++ >= faults.write_fails_at && fails(faults.write_error)) return -1;
  return real_write(file, bytes, std::min(count, faults.write_max));
}

ssize_t faulty_pread(int file, void* bytes, size_t count, off_t offset) {
  if (interrupted()) return -1;
  if (reads++ >= faults.read_fails_at && fails(faults.read_error)) return -1;
  return real_pread(file, bytes, std::min(count, faults.write_max), offset);
}

int faulty_fdatasync(int file) {
  if (interrupted()) return -1;
  return syncs++ >= faults.sync_fails_at && fails(faults.sync_error) ? -1 : real_fdatasync(file);
}

int faulty_ftruncate(int file, off_t size) { return fails(faults.truncate_error) ? -1 : real_ftruncate(file, size); }

int faulty_rename(const char* from, const char* to) { return fails(faults.rename_error) ? -1 : real_rename(from, to); }
}

namespace tumble::test {

FaultyFiles::FaultyFiles(const FileFaults& wanted) {
  faults = wanted;
  ::writes = ::reads = syncs = calls = ::interruptions = 0;
}
FaultyFiles::~FaultyFiles() { faults = {}; }

int FaultyFiles::writes() { return ::writes; }
int FaultyFiles::reads() { return ::reads; }
int FaultyFiles::interruptions() { return ::interruptions; }

}  // namespace tumble::test
