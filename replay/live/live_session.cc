#include "replay/live/live_session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "replay/live/live_stepper.h"

namespace tumble::replay {

// What others ask of the session's thread besides inputs. Taken under the lock, then done without it.
struct LiveSession::Requests {
  std::optional<Pace> pace;
  std::optional<double> back;
  bool again = false;
  bool step = false;
  bool stop = false;

  [[nodiscard]] bool any() const { return pace || back || again || step || stop; }
};

struct LiveSession::Parts {
  LiveStepper stepper;  // of the session's thread
  std::thread thread;

  // Shared, under the lock.
  std::mutex lock;
  std::condition_variable asked, handed_over;
  Requests requests;
  std::vector<sim::Command> inputs;  // for the next step
  std::vector<View> views;           // likewise
  std::uint64_t posted = 0;
  Pace wanted;
  LiveFrame newest;
  std::mutex finishing;  // of the one who ends the thread, before `lock`
  std::optional<Result<std::vector<SavedLog>>> finished;

  std::atomic<bool> wants_contacts = false;

  explicit Parts(LiveOptions options) : stepper(std::move(options)) {}
  void run();
  Requests next_requests();
  void apply(const Requests& taken);
  void step();
  void hand_over();
};

// Waits for a request, or for a step that is due. Inputs alone do not wake the thread: they go with the next step.
LiveSession::Requests LiveSession::Parts::next_requests() {
  std::unique_lock held(lock);
  const auto any = [&] { return requests.any(); };
  if (stepper.is_waiting()) {
    asked.wait(held, any);
  } else {
    asked.wait_until(held, stepper.due(), any);
  }
  return std::exchange(requests, {});
}

void LiveSession::Parts::run() {
  stepper.begin();
  hand_over();
  for (Requests taken = next_requests(); !taken.stop; taken = next_requests()) {
    if (taken.pace || taken.back || taken.again) apply(taken);
    const bool is_due = !stepper.is_waiting() && std::chrono::steady_clock::now() >= stepper.due();
    if (is_due || (taken.step && stepper.is_paused() && stepper.can_step())) step();
  }
}

void LiveSession::Parts::apply(const Requests& taken) {
  if (taken.back) stepper.back(*taken.back);
  if (taken.again) stepper.again();
  if (taken.pace) stepper.set(*taken.pace);
  hand_over();
}

void LiveSession::Parts::step() {
  std::vector<sim::Command> taken;
  std::vector<View> seen;
  {
    const std::lock_guard held(lock);
    taken.swap(inputs);
    seen.swap(views);
  }
  stepper.show_contacts(wants_contacts);
  stepper.step(std::move(taken), seen);
  hand_over();
}

void LiveSession::Parts::hand_over() {
  const LiveFrame& frame = stepper.frame();
  const std::lock_guard held(lock);
  newest = frame;
  handed_over.notify_all();
}

LiveSession::LiveSession(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {
  parts_->thread = std::thread([this] { parts_->run(); });
}

Result<std::unique_ptr<LiveSession>> LiveSession::start(LiveOptions options) {
  const Pace pace = options.pace;
  auto parts = std::make_unique<Parts>(std::move(options));
  parts->wanted = pace;
  if (Status ok = parts->stepper.open(); !ok.ok()) return ok.error();
  return std::unique_ptr<LiveSession>(new LiveSession(std::move(parts)));
}

LiveSession::~LiveSession() { static_cast<void>(finish()); }

std::uint64_t LiveSession::post(sim::Command input) {
  const std::lock_guard held(parts_->lock);
  parts_->inputs.push_back(std::move(input));
  return ++parts_->posted;
}

void LiveSession::see(const View& view) {
  const std::lock_guard held(parts_->lock);
  parts_->views.push_back(view);
}

void LiveSession::set(const Pace& pace) {
  const std::lock_guard held(parts_->lock);
  parts_->requests.pace = parts_->wanted = pace;
  parts_->asked.notify_all();
}

Pace LiveSession::pace() const {
  const std::lock_guard held(parts_->lock);
  return parts_->wanted;
}

void LiveSession::step_once() {
  const std::lock_guard held(parts_->lock);
  parts_->requests.step = true;
  parts_->asked.notify_all();
}

void LiveSession::back(double seconds) {
  const std::lock_guard held(parts_->lock);
  parts_->requests.back = seconds;
  parts_->asked.notify_all();
}

void LiveSession::again() {
  const std::lock_guard held(parts_->lock);
  parts_->requests.again = true;
  parts_->asked.notify_all();
}

void LiveSession::show_contacts(bool on) { parts_->wants_contacts = on; }

bool LiveSession::take(LiveFrame& mine) {
  const std::lock_guard held(parts_->lock);
  if (parts_->newest.serial <= mine.serial) return false;
  std::swap(mine, parts_->newest);
  parts_->newest.serial = 0;
  return true;
}

bool LiveSession::wait_for_newer(std::uint64_t serial, double seconds) {
  std::unique_lock held(parts_->lock);
  return parts_->handed_over.wait_for(held, std::chrono::duration<double>(seconds),
                                      [&] { return parts_->newest.serial > serial; });
}

Result<std::vector<SavedLog>> LiveSession::finish() {
  const std::lock_guard alone(parts_->finishing);
  if (parts_->finished) return *parts_->finished;
  {
    const std::lock_guard held(parts_->lock);
    parts_->requests.stop = true;
    parts_->asked.notify_all();
  }
  parts_->thread.join();
  const Status completed = parts_->stepper.finish();
  if (completed.ok()) {
    parts_->finished.emplace(parts_->stepper.saved());
  } else {
    parts_->finished.emplace(completed.error());
  }
  return *parts_->finished;
}

}  // namespace tumble::replay
