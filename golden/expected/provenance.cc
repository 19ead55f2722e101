#include "tumble/golden/provenance.h"

#include <sys/utsname.h>

#include <array>
#include <ctime>
#include <string_view>

#include "src/base/text.h"
#include "tumble/replay/step_record.h"

// "1234abcd… clean", as the build writes it when it links the program; a test or a fuzzer has none. A function of its
// own in a file of its own, so that a new commit compiles nothing anew (cmake/build_commit.cmake).
extern "C" [[gnu::weak]] const char* tumble_build_commit() { return ""; }
extern "C" [[gnu::weak]] const char* tumble_build_flags() { return ""; }

namespace tumble::golden {
namespace {

std::string machine_class() {
  std::string machine = processor_class();
  utsname system = {};
  if (::uname(&system) == 0) machine += std::string(", ") + system.sysname + ' ' + system.machine;
  return machine;
}

std::string commit_text(const Provenance& provenance) {
  if (provenance.commit.empty()) return "commit not known";
  const std::string commit = "commit " + provenance.commit.substr(0, 12);
  if (provenance.tree == "changed") return commit + " (sources changed since)";
  return provenance.tree.empty() ? commit + " (not known whether the sources were changed)" : commit;
}

}  // namespace

std::string describe(const Provenance& provenance) {
  const std::string program = "tumble " + (provenance.version.empty() ? "of unknown version" : provenance.version);
  if (provenance.date.empty()) return program + "; no more is known: it wrote no provenance";
  std::string text = program + ", " + commit_text(provenance);
  for (const std::string& part : {provenance.compiler, provenance.flags, provenance.machine, provenance.date}) {
    if (!part.empty()) text += ", " + part;
  }
  return text + ", " + seconds_text(provenance.seconds);
}

std::string processor_class() {
#if defined(__x86_64__) || defined(__i386__)
  if (__builtin_cpu_supports("avx512f") != 0) return "x86 with AVX-512";
  return __builtin_cpu_supports("avx2") != 0 ? "x86 with AVX2" : "x86 with SSE2";
#else
  return "not x86";
#endif
}

std::string utc_now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc = {};
  ::gmtime_r(&time, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

Provenance this_program() {
  Provenance here;
  here.version = TUMBLE_VERSION;
  const std::string_view built = tumble_build_commit();
  const std::size_t blank = built.find(' ');
  here.commit = built.substr(0, blank);
  if (blank != std::string_view::npos) here.tree = built.substr(blank + 1);
  here.compiler = replay::header_for({}).tool_build;
  here.flags = tumble_build_flags();
  here.machine = machine_class();
  here.date = utc_now();
  return here;
}

}  // namespace tumble::golden
