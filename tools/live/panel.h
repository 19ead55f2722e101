#pragma once

#include "replay/live/live_session.h"
#include "tools/live/hand.h"
#include "tools/live/screen.h"
#include "tools/live/view_state.h"

namespace tumble::tools {

/// Figures of the window itself.
struct WindowFigures {
  double frames_per_second = 0;
  double seconds = 0;  ///< of a whole frame, from one to the next
};

/// Everything that lies over the picture: the panel, the bar of a held throw, the list of keys, messages. Calls of Dear
/// ImGui, between Window::begin_panel() and draw_panel(). Changes `view`, and asks the session for what is clicked.
void draw_over(const replay::LiveFrame& frame, const WindowFigures& figures, const Screen& screen, Hand& hand,
               replay::LiveSession& session, ViewState& view);

}  // namespace tumble::tools
