#pragma once

#include <string>

namespace tumble::golden {

/// Where a result comes from: the program, its build, the machine and the time. Decides no verdict.
struct Provenance {
  std::string version;   ///< of the program
  std::string commit;    ///< that the program was linked at; empty: not known
  std::string tree;      ///< "clean" or "changed": whether the sources were those of the commit; empty: not known
  std::string compiler;  ///< and its version
  std::string flags;     ///< of the build
  std::string machine;   ///< its class: processor's instructions, system
  std::string date;      ///< UTC, "2026-11-22T15:04:05Z"
  double seconds = 0;    ///< of wall time that the run took
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

/// "tumble 0.1.0, commit 1234abcd5678 (sources changed since), g++ 12.2.0, -O3, x86 with AVX-512, Linux x86_64,
/// 2026-11-22T15:04:05Z, 0.35 s". Says "not known" of a commit that is not known. A golden of a program that wrote no
/// provenance says so.
std::string describe(const Provenance& provenance);

/// The class of this processor, on which the speed and a software driver's last bits may depend: "x86 with AVX-512".
std::string processor_class();

/// UTC, "2026-11-22T15:04:05Z".
std::string utc_now();

/// This program, here and now.
Provenance this_program();

}  // namespace tumble::golden
