// Everything that tools/scripts/checks/check_disassembly.sh is there to find, so that a test can see it find them.
// Compiled with contraction on for a machine that can fuse; never linked.
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace tumble::machine_dependent {

double fused(double a, double b, double c) { return a * b + c; }
long double eighty_bits(long double a, long double b) { return a * b; }
double from_libm(double a) { return std::sin(a); }
double clock_ticks() { return static_cast<double>(std::chrono::steady_clock::now().time_since_epoch().count()); }
int random_number() { return std::rand(); }
const char* environment() { return std::getenv("HOME"); }

}  // namespace tumble::machine_dependent
