#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include "tumble/render/image.h"

/// A display without a screen, and a hand: Xvfb, and xdotool's real events of mouse and keyboard.
namespace tumble::test {

class Display {
 public:
  /// Null where Xvfb or xdotool is not installed; `why` then names the package.
  static std::unique_ptr<Display> open(const std::string& folder, std::string& why);
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< ":7"
  void close();                                                    ///< takes the display away from its programs

  /// Runs xdotool with these words; true if it succeeded.
  [[nodiscard]] bool tool(const std::vector<std::string>& words) const;
  /// Waits until a window of this title is shown, and gives it the keyboard. False after a minute without one.
  [[nodiscard]] bool wait_for_window(const std::string& title) const;
  void move(int x, int y) const;                ///< the pointer, in pixels from the upper left corner
  void hold(int button, double seconds) const;  ///< presses a button and lets go
  void turn(int x, int y) const { drag(3, x, y); }
  void drag(int button, int x, int y) const;  ///< presses, moves from where the pointer is by pixels, lets go
  void key(const std::string& key) const;

  /// What the upper left width × height pixels of the screen show.
  [[nodiscard]] render::Image picture(int width, int height) const;

 private:
  Display() = default;
  pid_t server_ = 0;
  std::string name_, folder_;
};

/// Waits.
void sleep_for(double seconds);

}  // namespace tumble::test
