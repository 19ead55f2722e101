#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "replay/live/live_frame.h"
#include "replay/live/live_logs.h"
#include "replay/live/live_pacer.h"
#include "replay/live/live_stepper.h"
#include "tumble/replay/extras.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// A session that is played: steps in real time on a thread of its own, takes inputs while it runs, and logs each input
/// as it is applied. Whoever draws takes the newest state; the session never waits for a picture, and no bit of it
/// depends on when pictures are drawn.
///
/// Before every step the session checks its thread's floating-point environment, because a graphics driver in the same
/// process may change it. Where it is not the default, the session restores it and counts that; where it cannot be
/// restored, the session ends as with a step that fails.
///
/// A step that fails ends the session: its log is complete up to the step before, and the frame says why. back() and
/// again() go on from there.
///
/// All members may be called from any thread, finish() and the destructor from any but the session's own.
class LiveSession {
 public:
  /// Opens the log and begins to step. Errors: options.begin's.
  static Result<std::unique_ptr<LiveSession>> start(LiveOptions options);
  ~LiveSession();  ///< finish()
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  /// Gives an input to the next step, behind those posted before. The session chooses the id of a thrown box. A
  /// SetDt sets the length that the clock asks for. While the session is paused, inputs wait. Returns the number of
  /// inputs posted so far: LiveFrame::inputs_done reaches it with the first state that has this one.
  std::uint64_t post(sim::Command input);

  void set(const Pace& pace);
  [[nodiscard]] Pace pace() const;
  void step_once();             ///< takes one step of a paused session, as long as its pace asks for
  void back(double seconds);    ///< LiveLogs::back
  void again();                 ///< LiveLogs::again
  void show_contacts(bool on);  ///< from the next step on: markers of the contacts in the frames

  /// Logs what a picture showed, with the next step: the state after the step before, from this camera. Call before the
  /// picture is drawn. Later steps have moved on, so a view that comes late is logged a step late. Views that come
  /// after the last step of a log are not in it.
  void see(const View& view);

  /// Replaces `mine` by the newest frame if that is newer. Keeps the memory of `mine` for a later frame.
  bool take(LiveFrame& mine);
  /// Waits until there is a frame newer than `serial`, at most that long.
  bool wait_for_newer(std::uint64_t serial, double seconds);

  /// Ends the session and completes its log. Returns the logs, the earliest first. Later calls return the same. Errors:
  /// a log that could not be written or completed.
  Result<std::vector<SavedLog>> finish();

 private:
  struct Requests;
  struct Parts;
  explicit LiveSession(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace tumble::replay
