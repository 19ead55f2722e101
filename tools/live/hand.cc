#include "tools/live/hand.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "src/render/scene/camera_moves.h"

namespace tumble::tools {
namespace {

using sim::Vec3;

constexpr double kTurnDegrees = 180;  // for a drag over one height of the window
constexpr double kWheelStep = 0.9;

const render::BoxLook* find_box(const render::Snapshot& snapshot, std::uint64_t id) {
  const auto found = std::ranges::lower_bound(snapshot.boxes, id, {}, &render::BoxLook::id);
  return found != snapshot.boxes.end() && found->id == id ? &*found : nullptr;
}

}  // namespace

double held_part(double seconds) { return std::clamp(seconds / kHoldSeconds, kHoldLeast, 1.0); }

Hand::Hand(Window& window, replay::LiveSession& session, ViewState& view, const sim::Camera& home)
    : window_(window), session_(session), view_(view), home_(home) {
  window_.on_key = [this](int key, bool control) { press(key, control); };
  window_.on_button = [this](int which, bool down) { button(which, down); };
  window_.on_move = [this](double x, double y) { move(x, y); };
  window_.on_wheel = [this](double steps) { render::zoom(view_.camera, std::pow(kWheelStep, steps)); };
}

double Hand::held() const { return pressed_ ? held_part(Window::now() - *pressed_) : 0; }

void Hand::toggle_pause() {
  replay::Pace pace = session_.pace();
  pace.paused = !pace.paused;
  session_.set(pace);
}

void Hand::set_speed(double factor) {
  replay::Pace pace = session_.pace();
  pace.speed = std::clamp(pace.speed * factor, replay::kSpeedLeast, 1.0);
  session_.set(pace);
}

void Hand::go_home() {
  view_.camera = home_;
  view_.follow.reset();
}

// NOLINTNEXTLINE(readability-function-size): one line for each key
void Hand::press(int key, bool control) {
  if (control) {
    closes_ = closes_ || key == GLFW_KEY_Q;
    return;
  }
  if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + kToolCount) view_.tool = static_cast<Tool>(key - GLFW_KEY_1);
  if (key == GLFW_KEY_SPACE) toggle_pause();
  if (key == GLFW_KEY_N) session_.step_once();
  if (key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT) set_speed(0.5);
  if (key == GLFW_KEY_EQUAL || key == GLFW_KEY_KP_ADD) set_speed(2);
  if (key == GLFW_KEY_B) session_.back(kBackSeconds);
  if (key == GLFW_KEY_R) session_.again();
  if (key == GLFW_KEY_C) go_home();
  if (key == GLFW_KEY_ESCAPE) view_.follow.reset();
  if (key == GLFW_KEY_H) view_.panel = !view_.panel;
  if (key == GLFW_KEY_F1) view_.keys = !view_.keys;
}

void Hand::button(int which, bool down) {
  if (which == GLFW_MOUSE_BUTTON_RIGHT) turns_ = down;
  if (which == GLFW_MOUSE_BUTTON_MIDDLE) shifts_ = down;
  if (which != GLFW_MOUSE_BUTTON_LEFT) return;
  if (down) {
    pressed_ = Window::now();
  } else if (pressed_) {
    const double part = held();
    pressed_.reset();
    act(window_.pointer(), part);
  }
}

void Hand::move(double x, double y) {
  if (turns_)
    render::orbit(view_.camera, -x * kTurnDegrees, y * kTurnDegrees, frame_ == nullptr || frame_->snapshot.ground);
  if (shifts_) render::pan(view_.camera, -x, y);
}

render::Ray Hand::ray_at(const Window::Point& at) const {
  return render::ray_through(render::camera_view(view_.camera, window_.width(), window_.height()), at.x, at.y);
}

std::optional<render::Hit> Hand::hit_at(const Window::Point& at) const {
  if (frame_ == nullptr) return std::nullopt;
  return render::pick(frame_->snapshot, ray_at(at));
}

void Hand::post(const sim::Command& command) { pending_.push_back({session_.post(command), presented_}); }

void Hand::act(const Window::Point& at, double part) {
  const render::Ray ray = ray_at(at);
  if (view_.tool == Tool::kThrow) return throw_box(ray, part);
  const std::optional<render::Hit> hit = hit_at(at);
  if (!hit) {
    if (view_.tool == Tool::kFollow) view_.follow.reset();
    return;
  }
  if (view_.tool == Tool::kPush) push(ray, *hit, part);
  if (view_.tool == Tool::kRemove) post(sim::Remove{hit->id});
  if (view_.tool == Tool::kWake) post(sim::Wake{hit->id});
  if (view_.tool == Tool::kFollow) {
    view_.follow = hit->id;
    followed_.reset();
  }
}

void Hand::throw_box(const render::Ray& ray, double part) {
  const double edge = view_.edge;
  sim::BoxDef box;
  box.size = {edge, edge, edge};
  box.mass = view_.density * (edge * edge * edge);
  box.position = ray.from + ray.direction * (2 * edge);  // in sight, and not inside the eye
  box.velocity = ray.direction * (view_.fastest * part);
  box.material.friction = box.material.friction_dynamic = view_.friction;
  box.material.restitution = view_.restitution;
  box.material.texture = static_cast<sim::Texture>(view_.texture);
  box.origin.kind = sim::Origin::Kind::kInput;
  post(sim::Throw{box});
}

// The impulse that would give the body this speed if it went through its centre of mass.
void Hand::push(const render::Ray& ray, const render::Hit& hit, double part) {
  const auto at = static_cast<std::size_t>(find_box(frame_->snapshot, hit.id) - frame_->snapshot.boxes.data());
  const double impulse = frame_->mass[at] * view_.strongest * part;
  post(sim::Push{hit.id, Vec3(ray.direction * impulse), false, hit.point});
}

void Hand::look_at(const replay::LiveFrame& frame) {
  frame_ = &frame;
  if (view_.follow) {
    const render::BoxLook* box = find_box(frame.snapshot, *view_.follow);
    if (box == nullptr) {
      view_.follow.reset();
    } else {
      render::shift(view_.camera, Vec3(box->centre - followed_.value_or(view_.camera.target)));
      followed_ = box->centre;
    }
  }
  if (!view_.follow) followed_.reset();
  pointed_ = view_.tool == Tool::kThrow || Window::over_panel() ? std::nullopt : hit_at(window_.pointer());
}

void Hand::presented(const replay::LiveFrame& frame) {
  ++presented_;
  while (!pending_.empty() && pending_.front().input <= frame.inputs_done) {
    const std::uint64_t frames = presented_ - pending_.front().frame;
    pending_.pop_front();
    ++delay_.inputs;
    delay_.frames += frames;
    delay_.most = std::max(delay_.most, frames);
  }
}

}  // namespace tumble::tools
