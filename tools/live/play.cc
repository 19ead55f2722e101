#include "tools/live/play.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "replay/live/live_session.h"
#include "src/process/interrupt.h"
#include "tools/arguments/render_options.h"
#include "tools/live/hand.h"
#include "tools/live/measurement.h"
#include "tools/live/panel.h"
#include "tools/live/screen.h"
#include "tools/live/start.h"
#include "tools/live/window.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

constexpr double kIdleWait = 0.1;   // s, between pictures of a paused session that nobody touches
constexpr double kIdleAfter = 0.5;  // s without mouse and keyboard

// Xlib ends the program by exit() when the display goes away. The log is then completed from here.
replay::LiveSession*& session_at_exit() {
  static replay::LiveSession* session = nullptr;
  return session;
}
void complete_at_exit() {
  if (session_at_exit() == nullptr) return;
  const Result<std::vector<replay::SavedLog>> logs = session_at_exit()->finish();
  const std::string saved = logs.ok() ? logs->back().path + " is complete" : logs.error().message;
  std::cerr << "tumble live: the display went away; " << saved << '\n';
  std::_Exit(static_cast<int>(Exit::kCannotFinish));
}

// The loop of the window: mouse and keyboard, the newest state, a picture.
class Player {
 public:
  Player(Window& window, replay::LiveSession& session, const LiveStart& start, ViewState view,
         std::optional<double> measure)
      : window_(window),
        session_(session),
        view_(std::move(view)),
        screen_(window),
        hand_(window, session, view_, start.camera) {
    if (measure) measurement_.emplace(*measure);
  }

  Status run() {
    began_ = last_ = Window::now();
    const process::InterruptGuard guard;
    while (!is_over()) {
      await();
      if (window_.width() == 0 || window_.height() == 0) continue;  // minimised
      // A large scene takes a while until its first state.
      if (frames_ == 0) began_ = Window::now();
      const double now = Window::now() - began_;
      if (measurement_) measurement_->play(hand_, view_, now);
      hand_.look_at(frame_);
      log_view(now);
      if (Status ok = draw(); !ok.ok()) return ok;
      if (measurement_) measurement_->count(frame_, screen_.seconds(), Window::now() - began_);
    }
    return {};
  }

  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] const Screen& screen() const { return screen_; }
  [[nodiscard]] std::optional<Json> measured() const {
    return measurement_ ? std::optional(measurement_->json(hand_)) : std::nullopt;
  }

 private:
  [[nodiscard]] bool is_over() const {
    return window_.wants_to_close() || hand_.wants_to_close() || process::InterruptGuard::interrupted() ||
           (measurement_ && measurement_->is_over(Window::now() - began_));
  }

  // A picture needs a new state, or a person who moves the camera over an old one.
  void await() {
    if (session_.pace().paused && Window::now() - window_.touched() > kIdleAfter) {
      window_.wait(kIdleWait);
    } else {
      window_.poll();
    }
    const double patience = std::clamp(2 * frame_.scene_dt, 0.005, 0.05);
    if (session_.take(frame_)) return await_input(patience);
    if (!session_.pace().paused && frame_.ended.empty()) session_.wait_for_newer(frame_.serial, patience);
    session_.take(frame_);
  }

  // An input that was given before the last picture belongs into this one: a newer state may still lack it.
  void await_input(double patience) {
    const double end = Window::now() + patience;
    while (!session_.pace().paused && frame_.ended.empty() && frame_.inputs_done < hand_.awaited()) {
      const double left = end - Window::now();
      if (left <= 0 || !session_.wait_for_newer(frame_.serial, left)) return;
      session_.take(frame_);
    }
  }

  // Only what changed since the last picture: a session that rests adds nothing to its log.
  void log_view(double now) {
    replay::View view;
    view.part = 0;  // the state before the step that it is logged with
    view.wall_time = now;
    view.camera = view_.camera;
    view.effects = render::to_string(view_.effects);
    view.follow = view_.follow.value_or(0);
    const bool is_new = frame_.step != seen_step_ || view.camera != seen_.camera || view.effects != seen_.effects ||
                        view.follow != seen_.follow;
    if (!is_new) return;
    seen_step_ = frame_.step;
    seen_ = view;
    session_.see(view);
  }

  Status draw() {
    if (Status ok = screen_.draw(frame_, view_); !ok.ok()) return ok;
    window_.begin_panel();
    draw_over(frame_, figures_, screen_, hand_, session_, view_);
    window_.draw_panel();
    window_.present();
    ++frames_;
    hand_.presented(frame_);
    const double now = Window::now();
    figures_.seconds += 0.1 * (now - last_ - figures_.seconds);
    figures_.frames_per_second = figures_.seconds > 0 ? 1 / figures_.seconds : 0;
    last_ = now;
    return {};
  }

  Window& window_;
  replay::LiveSession& session_;
  ViewState view_;
  Screen screen_;
  Hand hand_;
  WindowFigures figures_;
  replay::LiveFrame frame_;
  replay::View seen_;  // logged last
  std::optional<std::uint64_t> seen_step_;
  std::optional<Measurement> measurement_;
  double began_ = 0, last_ = 0;
  std::uint64_t frames_ = 0;
};

Json log_json(const replay::SavedLog& log) {
  Json json;
  json["log"] = log.path;
  json["first_state"] = log.first_state;
  json["steps"] = log.summary.steps;
  json["bytes"] = log.summary.bytes;
  json["final_hash"] = to_string(log.summary.final_hash);
  return json;
}

void report(const std::vector<replay::SavedLog>& logs, const Player& player, const std::string& driver, bool as_json) {
  if (as_json) {
    Json json;
    json["logs"] = Json::array();
    for (const replay::SavedLog& log : logs) json["logs"].push_back(log_json(log));
    json["frames"] = player.frames();
    json["driver"] = driver;
    json["measured"] = player.measured().value_or(nullptr);
    return print_json("live", json);
  }
  Listing listing;
  for (const replay::SavedLog& log : logs) {
    listing.add("log", printable(log.path));
    listing.add("steps", std::to_string(log.summary.steps));
    listing.add("final hash", to_string(log.summary.final_hash));
  }
  listing.add("frames", std::to_string(player.frames()));
  listing.add("drawn with", printable(driver));
  listing.print();
  if (const std::optional<Json> measured = player.measured()) std::cout << measured->dump(2) << '\n';
}

}  // namespace

Result<Exit> play(const LiveArguments& arguments) {
  render::Settings settings;
  if (Status ok = read_size(arguments.size, settings); !ok.ok()) return ok.error();
  const Result<render::Effects> effects = render::parse_effects(arguments.effects);
  if (!effects.ok()) return effects.error();
  Result<LiveStart> start = read_live_start(arguments);
  if (!start.ok()) return start.error();
  const Result<std::unique_ptr<Window>> window =
      Window::open("tumble live: " + start->name, settings.width, settings.height);
  if (!window.ok()) return window.error();
  const Result<std::unique_ptr<replay::LiveSession>> session = replay::LiveSession::start(start->options);
  if (!session.ok()) return session.error();
  session_at_exit() = session->get();
  std::atexit(complete_at_exit);

  ViewState view;
  view.camera = start->camera;
  view.effects = *effects;
  view.samples = static_cast<int>(arguments.samples.value_or(1));
  Player player(**window, **session, *start, view, arguments.measure);
  const Status played = player.run();
  const Result<std::vector<replay::SavedLog>> logs = (*session)->finish();
  session_at_exit() = nullptr;
  if (!played.ok() && !logs.ok()) {
    return Error{logs.error().kind, played.error().message + "; and " + logs.error().message};
  }
  if (!played.ok()) return played.error();
  if (!logs.ok()) return logs.error();
  const render::Renderer* renderer = player.screen().renderer();
  report(*logs, player, renderer == nullptr ? "nothing" : renderer->driver(), arguments.json);
  return start->verdict;
}

}  // namespace tumble::tools
