#pragma once

#include <cstddef>
#include <cstdint>

#include "src/math/lane_width.h"

namespace tumble::sim {

/// Free flight of the bodies of rows [begin, end) for which `flies` is 1.
struct FlightWork {
  std::size_t begin = 0, end = 0;
  const std::uint8_t* flies = nullptr;
  double *position[3] = {}, *orientation[4] = {}, *velocity[3] = {}, *spin[3] = {};
  const double* inertia[3] = {};
  double fall[3] = {};  ///< m/s, what gravity adds in dt_s, on its grid
  double slower = 1;    ///< 1 + air drag · dt_s
  double dt_s = 0;
};

/// The boxes of rows [begin, end) where they stand.
struct FrameWork {
  std::size_t begin = 0, end = 0;
  const double *position[3] = {}, *orientation[4] = {}, *half_extent[3] = {};
  double* frames = nullptr;            ///< rows of BoxFrame
  double *low[3] = {}, *high[3] = {};  ///< written: their AABBs
};

/// AABBs of rows [begin, end), widened to where the boxes may come within dt_s.
struct ReachWork {
  std::size_t begin = 0, end = 0;
  const double *velocity[3] = {}, *spin[3] = {}, *half_extent[3] = {};
  double around = 0;  ///< m, what all of them reach beyond their motion
  double dt_s = 0;
  double* turning = nullptr;           ///< written: m, how far corners may come by turning
  double *low[3] = {}, *high[3] = {};  ///< read and written
};

/// Bodies of rows [begin, end) that are finite and within limits: see check_body.
struct CheckWork {
  std::size_t begin = 0, end = 0;
  const double *position[3] = {}, *orientation[4] = {}, *velocity[3] = {}, *spin[3] = {};
  double position_max = 0, speed_max = 0, norm_tolerance = 0;
};

/// What is done to each body by itself, in lanes; compiled once for each width. Each does as many rows as fill whole
/// vectors and returns where it stopped: the code for one body is what does the rest, and all with one lane.
struct BodyKernels {
  /// Bodies whose moments of inertia differ are left as they are, and counted in `uneven`.
  std::size_t (*fly)(const FlightWork& work, std::size_t& uneven);
  std::size_t (*frame)(const FrameWork& work);
  std::size_t (*reach_out)(const ReachWork& work);
  /// Stops at the beginning if any of the rows is wrong.
  std::size_t (*check)(const CheckWork& work);
};

/// Null with one lane, and where this machine or this build does not run the width.
const BodyKernels* body_kernels(LaneWidth width);

// Each is defined where the compiler makes that width, and null elsewhere.
const BodyKernels* body_kernels_two();
const BodyKernels* body_kernels_four();
const BodyKernels* body_kernels_eight();

}  // namespace tumble::sim
