#include "tools/live/screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "replay/picture/picture_markers.h"
#include "replay/picture/picture_source.h"

namespace tumble::tools {
namespace {

int scaled(int pixels, double scale) {
  return std::clamp(static_cast<int>(std::lround(pixels * scale)), render::kSizeMin, render::kSizeMax);
}

}  // namespace

Status Screen::fit(const ViewState& view) {
  render::Settings wanted;
  wanted.width = scaled(window_.width(), view.scale);
  wanted.height = scaled(window_.height(), view.scale);
  wanted.samples = view.samples;
  wanted.effects = view.effects;
  if (renderer_ != nullptr) {
    const render::Settings& now = renderer_->settings();
    if (now.width == wanted.width && now.height == wanted.height && now.samples == wanted.samples) {
      renderer_->use(wanted.effects);
      return {};
    }
    renderer_.reset();  // before the new one, so that both need not fit into memory
  }
  auto made = render::Renderer::create_in_current(wanted, Window::find_function());
  if (!made.ok()) return made.error();
  renderer_ = *std::move(made);
  return {};
}

Status Screen::draw(const replay::LiveFrame& frame, const ViewState& view) {
  const double start = Window::now();
  if (Status ok = fit(view); !ok.ok()) return ok;
  shown_ = frame.snapshot;
  shown_.camera = view.camera;
  for (std::size_t i = 0; view.freezing && i < shown_.boxes.size(); ++i) {
    if (frame.is_moving[i] != 0) shown_.boxes[i].texture = sim::Texture::kWhite;
  }
  if (view.bounds) replay::add_bounds_markers(shown_);
  if (view.velocities) replay::add_velocity_markers(shown_, replay::kArrowSeconds);
  Status drawn = renderer_->show(shown_, {0, 0, 0, window_.width(), window_.height()});
  seconds_ = Window::now() - start;
  return drawn;
}

}  // namespace tumble::tools
