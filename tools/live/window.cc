#include "tools/live/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

#include "src/base/text.h"

namespace tumble::tools {
namespace {

std::string& last_problem() {
  static std::string text;
  return text;
}

Error no_window(const std::string& doing) {
  const std::string& why = last_problem();
  return cannot_finish(doing + (why.empty() ? "" : " (" + printable(why) + ")") +
                       "; 'tumble view LOG -o FILE.html' shows a recorded session in a browser");
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const std::string& title, int width, int height) {
  glfwSetErrorCallback([](int, const char* text) { last_problem() = text; });
  if (glfwInit() == GLFW_FALSE) return no_window("no display to open a window on");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  // The picture is drawn into framebuffers of the renderer's own; the window's needs nothing but colour.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  GLFWwindow* handle = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (handle == nullptr) {
    const Error error = no_window("the display has no OpenGL 3.3 for a window");
    glfwTerminate();
    return error;
  }
  glfwMakeContextCurrent(handle);
  glfwSwapInterval(1);
  std::unique_ptr<Window> window(new Window(handle));
  window->listen();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leave no files behind
  ImGui::StyleColorsDark();
  ImGui_ImplGlfw_InitForOpenGL(handle, true);  // keeps our callbacks and calls them first
  ImGui_ImplOpenGL3_Init("#version 330 core");
  return window;
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(handle_);
  glfwTerminate();
}

Window& Window::touched(GLFWwindow* handle) {
  Window& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  window.touched_ = now();
  return window;
}

void Window::listen() {
  glfwSetWindowUserPointer(handle_, this);
  glfwGetCursorPos(handle_, &last_x_, &last_y_);
  glfwSetKeyCallback(handle_, [](GLFWwindow* handle, int key, int, int action, int mods) {
    Window& window = touched(handle);
    if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput || !window.on_key) return;
    window.on_key(key, (mods & GLFW_MOD_CONTROL) != 0);
  });
  glfwSetMouseButtonCallback(handle_, [](GLFWwindow* handle, int button, int action, int) {
    Window& window = touched(handle);
    if (action == GLFW_PRESS && over_panel()) return;
    if (window.on_button) window.on_button(button, action == GLFW_PRESS);
  });
  glfwSetCursorPosCallback(handle_, [](GLFWwindow* handle, double x, double y) {
    Window& window = touched(handle);
    int width = 1, height = 1;
    glfwGetWindowSize(handle, &width, &height);
    const double dx = x - window.last_x_, dy = y - window.last_y_;
    window.last_x_ = x;
    window.last_y_ = y;
    if (window.on_move) window.on_move(dx / std::max(height, 1), dy / std::max(height, 1));
  });
  glfwSetScrollCallback(handle_, [](GLFWwindow* handle, double, double steps) {
    Window& window = touched(handle);
    if (!over_panel() && window.on_wheel) window.on_wheel(steps);
  });
}

void Window::poll() { glfwPollEvents(); }
void Window::wait(double seconds) { glfwWaitEventsTimeout(seconds); }
bool Window::wants_to_close() const { return glfwWindowShouldClose(handle_) != GLFW_FALSE; }

int Window::width() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(handle_, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(handle_, &width, &height);
  return height;
}

Window::Point Window::pointer() const {
  int width = 1, height = 1;
  glfwGetWindowSize(handle_, &width, &height);
  return {last_x_ / std::max(width, 1), last_y_ / std::max(height, 1)};
}

bool Window::over_panel() { return ImGui::GetIO().WantCaptureMouse; }
double Window::now() { return glfwGetTime(); }
render::FindGlFunction Window::find_function() { return glfwGetProcAddress; }

void Window::begin_panel() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::draw_panel() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::present() { glfwSwapBuffers(handle_); }

}  // namespace tumble::tools
