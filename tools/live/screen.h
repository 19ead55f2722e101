#pragma once

#include <memory>

#include "replay/live/live_frame.h"
#include "tools/live/view_state.h"
#include "tools/live/window.h"
#include "tumble/render/renderer.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Draws frames into a window by the six passes.
class Screen {
 public:
  explicit Screen(Window& window) : window_(window) {}

  /// Draws the bodies of a frame as `view` wants them seen. The renderer is made again when the window's size or the
  /// quality changes. Errors: Renderer's.
  Status draw(const replay::LiveFrame& frame, const ViewState& view);

  [[nodiscard]] double seconds() const { return seconds_; }  ///< that the last picture took
  [[nodiscard]] const render::Renderer* renderer() const { return renderer_.get(); }

 private:
  Status fit(const ViewState& view);

  Window& window_;
  std::unique_ptr<render::Renderer> renderer_;
  render::Snapshot shown_;
  double seconds_ = 0;
};

}  // namespace tumble::tools
