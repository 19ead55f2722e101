#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "replay/live/live_session.h"
#include "src/render/scene/pick.h"
#include "tools/live/view_state.h"
#include "tools/live/window.h"

namespace tumble::tools {

/// Turns mouse and keyboard into inputs of the session and movements of the camera.
class Hand {
 public:
  /// All must outlive this object. Listens to the window from now on.
  Hand(Window& window, replay::LiveSession& session, ViewState& view, const sim::Camera& home);

  /// Call with each frame that is going to be drawn: the camera follows its body, and the pointer points into it.
  void look_at(const replay::LiveFrame& frame);

  /// The body under the pointer, in the frame looked at.
  [[nodiscard]] const std::optional<render::Hit>& pointed() const { return pointed_; }
  /// While the left button is held: the part of full speed that letting go would give. 0: not held.
  [[nodiscard]] double held() const;
  [[nodiscard]] bool wants_to_close() const { return closes_; }

  /// Does at a point of the picture what letting go of the left button does.
  void act(const Window::Point& at, double part);
  void set_speed(double factor);  ///< multiplies it, within the limits
  void toggle_pause();
  void go_home();  ///< the camera as the scene has it

  /// The number of the oldest input that no presented frame has; 0: none.
  [[nodiscard]] std::uint64_t awaited() const { return pending_.empty() ? 0 : pending_.front().input; }
  /// Call after a frame is presented. Counts how many frames inputs took to be seen: 1 is the first frame that was
  /// drawn after the input was read.
  void presented(const replay::LiveFrame& frame);
  struct Delay {
    std::uint64_t inputs = 0;
    std::uint64_t frames = 0;  ///< of all inputs together
    std::uint64_t most = 0;
  };
  [[nodiscard]] const Delay& delay() const { return delay_; }

 private:
  void press(int key, bool control);
  void button(int which, bool down);
  void move(double x, double y);
  void post(const sim::Command& command);
  [[nodiscard]] render::Ray ray_at(const Window::Point& at) const;
  [[nodiscard]] std::optional<render::Hit> hit_at(const Window::Point& at) const;
  void throw_box(const render::Ray& ray, double part);
  void push(const render::Ray& ray, const render::Hit& hit, double part);

  struct Pending {
    std::uint64_t input = 0, frame = 0;
  };

  Window& window_;
  replay::LiveSession& session_;
  ViewState& view_;
  sim::Camera home_;
  const replay::LiveFrame* frame_ = nullptr;
  std::optional<render::Hit> pointed_;
  std::optional<double> pressed_;  // s, when the left button went down
  bool turns_ = false, shifts_ = false, closes_ = false;
  std::optional<sim::Vec3> followed_;  // where the followed body was
  std::deque<Pending> pending_;
  std::uint64_t presented_ = 0;  // frames
  Delay delay_;
};

}  // namespace tumble::tools
