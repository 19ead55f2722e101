#pragma once

#include <array>
#include <memory>
#include <string>

#include "tumble/render/backend.h"
#include "tumble/render/effects.h"
#include "tumble/render/image.h"
#include "tumble/render/snapshot.h"
#include "tumble/render/window.h"
#include "tumble/sim/result.h"

namespace tumble::render {

class Context;

inline constexpr int kSamplesMax = 4;

struct Settings {
  int width = 640;
  int height = 480;
  int samples = 2;  ///< the base image is this many times wider and higher: 1 is fast, 2 has smooth edges
  Effects effects;
};

/// The images that the passes write, in their order. `kFinal` is the picture.
enum class Stage {
  kDepth,    ///< pass 1: distance from the light, near is dark; has the size of the depth map
  kBase,     ///< pass 2
  kMasks,    ///< pass 2: depth and motion masks, from alpha
  kShrunk,   ///< pass 3; from here on a quarter of the width and height
  kHdr,      ///< pass 3: HDR mask, from alpha
  kBlurX,    ///< pass 4
  kBlurred,  ///< pass 5
  kGlow,     ///< pass 5: spread HDR mask, from alpha
  kFinal,    ///< pass 6
};

/// "depth", "base", "masks", "shrunk", "hdr", "blur_x", "blurred", "glow", "final". Errors (kBadInput): anything else.
Result<Stage> parse_stage(const std::string& word);

/// Draws snapshots with fixed settings, in six passes (thesis IV.F). Equal snapshots and settings give equal pixels in
/// every process, with either backend and any number of drawing threads. Not for use by two threads at once.
class Renderer {
 public:
  /// Errors. kBadInput: a size beyond the limits or beyond the driver. kCannotFinish: the machine has no library that
  /// gives an OpenGL context; the message names the package to install.
  static Result<std::unique_ptr<Renderer>> create(const Settings& settings, Backend backend = Backend::kAuto);
  /// Draws in the context that is current on this thread, a window's, instead of one without a window. That context
  /// must be current in every call and when the renderer is destroyed. Errors: as create().
  static Result<std::unique_ptr<Renderer>> create_in_current(const Settings& settings, FindGlFunction find);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Errors (kCannotFinish): the driver reports one.
  Result<Image> draw(const Snapshot& snapshot, Stage stage = Stage::kFinal);

  /// Draws as draw() does and puts the picture into `target`, scaled where the sizes differ. Pixels of the picture and
  /// of the target are equal where the sizes are. Leaves that framebuffer bound, and no depth test, for what else the
  /// window shows. Errors (kCannotFinish): the driver reports one.
  Status show(const Snapshot& snapshot, const Target& target);

  /// Replaces the effects of the settings from the next picture on.
  void use(const Effects& effects);
  [[nodiscard]] const Settings& settings() const;

  [[nodiscard]] const char* backend_name() const;  ///< "OSMesa", "EGL" or "window"
  /// Driver and machine class, for reports: "llvmpipe (LLVM 15.0.6, 256 bits), 3.3 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string driver() const;

  /// Switches the measurement of passes on or off. Measuring waits for the end of each pass, which costs time.
  /// pass_seconds(): processor time in s of each pass of the last draw(), summed over all drawing threads.
  void measure_passes(bool on);
  [[nodiscard]] const std::array<double, 6>& pass_seconds() const;

 private:
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts);
  static Result<std::unique_ptr<Renderer>> create_with(const Settings& settings,
                                                       Result<std::unique_ptr<Context>> context);
  std::unique_ptr<Parts> parts_;
};

}  // namespace tumble::render
