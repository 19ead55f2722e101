#pragma once

#include <cstdint>
#include <vector>

/// The physics of the toy engine.
namespace tumble::toy {

inline constexpr double kDt = 1.0 / 64;  // s

struct Body {
  std::uint64_t id = 0;
  double x = 0, z = 0;    // m
  double vx = 0, vz = 0;  // m/s
};

struct Contact {
  std::size_t a = 0, b = 0;  // rows of the lower and the upper body; kGround below the first
  double depth = 0;          // m
  double mass = 0;           // kg, effective
  double bias = 0;           // m/s
  double lambda = 0;         // N s
};

struct Solver {
  static constexpr std::size_t kGround = ~std::size_t{0};

  std::vector<Body> bodies;
  double gravity = 9.81;  // m/s²
  int fault = 0;          // 1 … 10: the line that computes another number; 0: none
  bool reverse = false;   // solves the pairs from the top

  void step(std::uint64_t k);

 private:
  void find_contacts();
  void solve();
  /// The value of line n, wrong by a relative 1e-9 where that line has the fault.
  [[nodiscard]] double line(int n, double value) const { return fault == n ? value * (1 + 1e-9) : value; }

  std::vector<Contact> contacts_;
};

}  // namespace tumble::toy
