#pragma once

#include <array>
#include <optional>

namespace tumble::tools {

/// One time of the thesis's Table I: CPU seconds for 5 s of the comparison scene on a 1.8 GHz AMD processor. `failed`
/// is its 'F'; no value is its 'N/A', where 3ds Max had not enough memory.
struct TableTime {
  std::optional<double> seconds;
  bool failed = false;
};

inline constexpr std::array<int, 7> kTableCubes = {36, 100, 225, 400, 1600, 3600, 6400};
inline constexpr std::array<int, 5> kTableSubsteps = {1, 4, 10, 40, 200};

/// Rows by substeps, columns by cubes.
using TableTimes = std::array<std::array<TableTime, kTableCubes.size()>, kTableSubsteps.size()>;

namespace table1_detail {
inline constexpr TableTime kNone = {std::nullopt, false};
constexpr TableTime ok(double seconds) { return {seconds, false}; }
constexpr TableTime failed(double seconds) { return {seconds, true}; }
}  // namespace table1_detail

/// Table I (a) and (b) of C. Yuksel, Real-time Impulse-based Rigid Body Simulation and Rendering, 2007.
struct TableHalf {
  double dt;         ///< s, as the scene is given it
  const char* name;  ///< as the thesis writes it
  TableTimes thesis;
  TableTimes havok;
};

inline const std::array<TableHalf, 2>& thesis_table1() {
  using table1_detail::failed;
  using table1_detail::kNone;
  using table1_detail::ok;
  static constexpr std::array<TableHalf, 2> kTable = {{
      {1.0 / 30,
       "0.0333",
       {{{ok(0.14), ok(0.30), ok(0.73), ok(1.55), ok(11.98), ok(41.35), ok(120.17)},
         {ok(0.16), ok(0.41), ok(0.79), ok(2.30), ok(12.17), ok(43.97), ok(124.85)},
         {ok(0.20), ok(0.85), ok(3.62), ok(5.94), ok(60.15), ok(167.91), ok(2777.54)},
         {ok(0.25), ok(0.92), ok(6.76), ok(20.16), ok(94.14), ok(663.94), ok(1694.44)},
         {ok(0.32), ok(1.18), ok(20.16), ok(33.58), ok(461.14), ok(870.12), ok(3915.67)}}},
       {{{ok(5.13), failed(5.38), failed(7.01), failed(13.23), failed(91.13), kNone, kNone},
         {ok(4.94), ok(5.45), failed(10.78), failed(36.88), failed(323.16), kNone, kNone},
         {ok(5.14), ok(5.57), ok(13.18), failed(53.14), failed(796.13), kNone, kNone},
         {ok(5.19), ok(10.47), ok(24.31), ok(73.72), ok(1156.16), kNone, kNone},
         {ok(10.53), ok(33.81), ok(91.94), ok(231.24), ok(2045.12), kNone, kNone}}}},
      {1.0 / 300,
       "0.0033",
       {{{ok(1.54), ok(2.12), ok(8.41), ok(23.44), ok(183.53), ok(608.56), ok(1763.18)},
         {ok(1.67), ok(2.24), ok(10.16), ok(30.30), ok(381.71), ok(1323.53), ok(4472.28)},
         {ok(1.73), ok(2.81), ok(15.12), ok(45.81), ok(658.69), ok(2658.39), ok(7458.24)},
         {ok(1.86), ok(3.61), ok(17.71), ok(49.21), ok(1271.32), ok(5061.96), ok(20157.72)},
         {ok(1.88), ok(4.94), ok(27.58), ok(86.31), ok(1922.57), ok(9951.07), ok(38309.41)}}},
       {{{ok(5.32), ok(6.70), ok(16.89), failed(57.68), failed(829.22), kNone, kNone},
         {ok(6.01), ok(13.16), ok(30.86), ok(78.37), ok(822.75), kNone, kNone},
         {ok(8.97), ok(24.40), ok(57.64), ok(131.50), ok(918.96), kNone, kNone},
         {ok(23.80), ok(70.77), ok(208.34), ok(455.96), ok(2153.03), kNone, kNone},
         {ok(69.18), ok(303.34), ok(1002.17), ok(2054.16), ok(12815.12), kNone, kNone}}}},
  }};
  return kTable;
}

}  // namespace tumble::tools
