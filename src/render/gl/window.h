#pragma once

/// The parts of a window that the renderer needs. Whoever opens the window makes its context.
namespace tumble::render {

/// A function of OpenGL, and the look-up of one by its name in the current context, as glfwGetProcAddress does.
using GlFunction = void (*)();
using FindGlFunction = GlFunction (*)(const char* name);

/// A rectangle of a framebuffer, in pixels. x, y: its lower left corner. Framebuffer 0 is the window's.
struct Target {
  unsigned framebuffer = 0;
  int x = 0, y = 0;
  int width = 640, height = 480;
};

}  // namespace tumble::render
