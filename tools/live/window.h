#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tumble/render/window.h"
#include "tumble/sim/result.h"

struct GLFWwindow;

namespace tumble::tools {

/// A window with an OpenGL 3.3 core context, current on the thread that opened it, and Dear ImGui in it.
class Window {
 public:
  /// Errors (kCannotFinish): no display, or no OpenGL 3.3 on it; the message names `tumble view`.
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Hands out what was done with mouse and keyboard since the last call, by the calls below.
  void poll();
  /// Waits for mouse or keyboard, at most that long, and then does as poll().
  void wait(double seconds);
  [[nodiscard]] bool wants_to_close() const;

  /// The size that can be drawn into, in pixels; 0 × 0 while the window is minimised.
  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  /// The pointer, in shares of width and height from the upper left corner.
  struct Point {
    double x = 0, y = 0;
  };
  [[nodiscard]] Point pointer() const;
  [[nodiscard]] double touched() const { return touched_; }  ///< when mouse or keyboard were last used, as now()
  [[nodiscard]] static bool over_panel();                    ///< the pointer is over something of Dear ImGui
  [[nodiscard]] static double now();                         ///< s, of a clock that never goes back
  [[nodiscard]] static render::FindGlFunction find_function();

  /// Between these two, Dear ImGui's calls say what lies over the picture.
  void begin_panel();
  void draw_panel();
  void present();  ///< shows what was drawn

  // GLFW's codes of keys and buttons, without those that Dear ImGui takes for itself.
  std::function<void(int key, bool control)> on_key;
  std::function<void(int button, bool down)> on_button;
  std::function<void(double x, double y)> on_move;  ///< of the pointer, in heights of the window since the last call
  std::function<void(double steps)> on_wheel;

 private:
  explicit Window(GLFWwindow* handle) : handle_(handle) {}
  void listen();
  static Window& touched(GLFWwindow* handle);  // notes the time
  GLFWwindow* handle_;
  double last_x_ = 0, last_y_ = 0;
  double touched_ = 0;
};

}  // namespace tumble::tools
