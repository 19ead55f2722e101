#pragma once

#include <array>
#include <memory>
#include <string>

#include "src/base/result.h"
#include "src/render/gl/context.h"
#include "src/render/passes/effects.h"
#include "src/render/picture/image.h"
#include "src/render/scene/snapshot.h"

namespace tumble::render {

inline constexpr int kSamplesMax = 4;

struct Settings {
  int width = 640;
  int height = 480;
  int samples = 2;  ///< the base image is this many times as wide and high: 1 is quick, 2 has smooth edges
  Effects effects;
};

/// What can be looked at, in the order it is made. `kFinal` is the picture.
enum class Stage {
  kDepth,    ///< pass 1: distance from the light, near is dark; as large as the depth map
  kBase,     ///< pass 2
  kMasks,    ///< pass 2: depth and motion masks, its alpha
  kShrunk,   ///< pass 3; this and what follows a quarter as large
  kHdr,      ///< pass 3: HDR mask, its alpha
  kBlurX,    ///< pass 4
  kBlurred,  ///< pass 5
  kGlow,     ///< pass 5: spread HDR mask, its alpha
  kFinal,    ///< pass 6
};

/// "depth", "base", "masks", "shrunk", "hdr", "blur_x", "blurred", "glow", "final". Errors (kBadInput): anything else.
Result<Stage> parse_stage(const std::string& word);

/// Draws snapshots, always with the same settings: six passes (thesis IV.F). Equal snapshots and settings give equal
/// pixels in every process, with either backend, whatever the number of threads that draw. One thread at a time.
class Renderer {
 public:
  /// Errors: no OpenGL (Context::open), a size out of limits or beyond the driver's (kBadInput).
  static Result<std::unique_ptr<Renderer>> create(const Settings& settings, Backend backend = Backend::kAuto);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Errors (kCannotFinish): the driver's.
  Result<Image> draw(const Snapshot& snapshot, Stage stage = Stage::kFinal);

  [[nodiscard]] const Context& context() const;

  /// Seconds of processor time, over all threads that draw, that each of the six passes of the last draw() took, in
  /// order. Measured if switched on, at the price of waiting for each.
  void measure_passes(bool on);
  [[nodiscard]] const std::array<double, 6>& pass_seconds() const;

 private:
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace tumble::render
