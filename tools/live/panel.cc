#include "tools/live/panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "tumble/sim/limits.h"
#include "tumble/sim/scene.h"

namespace tumble::tools {
namespace {

constexpr float kWidth = 270;  // pixels
const ImVec4 kWarning = {1.0F, 0.75F, 0.2F, 1.0F};

constexpr const char* kKeys =
    "left button    hold, let go: use the tool\n"
    "right button   turn the camera\n"
    "middle button  shift the camera\n"
    "wheel          nearer, farther\n"
    "1 2 3 4 5      throw push remove wake follow\n"
    "Space          pause, go on\n"
    "N              one step, while paused\n"
    "- =            slower, faster\n"
    "B              back ten seconds, into a new log\n"
    "R              begin again, into a new log\n"
    "C              the scene's camera\n"
    "Esc            follow no more\n"
    "H F1           hide the panel, these keys\n"
    "Ctrl+Q         close; the log is complete";

void draw_time(const replay::LiveFrame& frame, Hand& hand, replay::LiveSession& session) {
  replay::Pace pace = session.pace();
  ImGui::Text("step %llu   %.2f s", static_cast<unsigned long long>(frame.step), frame.time);
  if (ImGui::Button(pace.paused ? "go on" : "pause")) hand.toggle_pause();
  ImGui::SameLine();
  ImGui::BeginDisabled(!pace.paused);
  if (ImGui::Button("step")) session.step_once();
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("back 10 s")) session.back(kBackSeconds);
  ImGui::SameLine();
  if (ImGui::Button("again")) session.again();
  ImGui::Text("speed 1/%.0f", 1 / pace.speed);
  ImGui::SameLine();
  if (ImGui::Button("slower")) hand.set_speed(0.5);
  ImGui::SameLine();
  if (ImGui::Button("faster")) hand.set_speed(2);
  if (ImGui::Checkbox("steps of equal length", &pace.even)) session.set(pace);
}

void draw_hand(ViewState& view) {
  int tool = static_cast<int>(view.tool);
  for (int k = 0; k < kToolCount; ++k) {
    ImGui::RadioButton(kToolNames[k], &tool, k);
    if (k % 3 != 2 && k + 1 < kToolCount) ImGui::SameLine();
  }
  view.tool = static_cast<Tool>(tool);
  if (view.tool == Tool::kPush) ImGui::SliderFloat("m/s at most", &view.strongest, 0.5F, 100, "%.1f");
  if (view.tool != Tool::kThrow) return;
  constexpr ImGuiSliderFlags kLog = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;
  ImGui::SliderFloat("m/s at most", &view.fastest, 1, 200, "%.0f", kLog);
  ImGui::SliderFloat("edge, m", &view.edge, 0.05F, 10, "%.2f", kLog);
  float mass = view.density * view.edge * view.edge * view.edge;
  if (ImGui::SliderFloat("mass, kg", &mass, 0.01F, 1e6F, "%.3g", kLog)) {
    view.density = mass / (view.edge * view.edge * view.edge);
  }
  ImGui::SliderFloat("friction", &view.friction, 0, 2, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("bounce", &view.restitution, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::Combo("texture", &view.texture, sim::kTextureNames.data(), static_cast<int>(sim::kTextureNames.size()));
}

void draw_world(const replay::LiveFrame& frame, replay::LiveSession& session) {
  constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;
  auto down = static_cast<float>(-frame.gravity.z());
  if (ImGui::SliderFloat("gravity, m/s2", &down, -20, 30, "%.2f", kClamp)) {
    session.post(sim::SetGravity{{frame.gravity.x(), frame.gravity.y(), -static_cast<double>(down)}});
  }
  auto rate = static_cast<float>(1 / frame.scene_dt);
  if (ImGui::SliderFloat("steps a second", &rate, 10, 600, "%.0f", kClamp | ImGuiSliderFlags_Logarithmic)) {
    session.post(sim::SetDt{1 / static_cast<double>(rate)});
  }
}

void draw_looks(replay::LiveSession& session, ViewState& view) {
  const std::array<std::pair<const char*, bool*>, 10> switches = {{{"shadow", &view.effects.shadow},
                                                                   {"specular", &view.effects.specular},
                                                                   {"bloom", &view.effects.bloom},
                                                                   {"depth of field", &view.effects.dof},
                                                                   {"motion blur", &view.effects.motion},
                                                                   {"light by vertex", &view.effects.vertex},
                                                                   {"frozen bodies", &view.freezing},
                                                                   {"velocities", &view.velocities},
                                                                   {"contacts", &view.contacts},
                                                                   {"bounds", &view.bounds}}};
  for (std::size_t k = 0; k < switches.size(); ++k) {
    if (k % 2 == 1) ImGui::SameLine(kWidth / 2);
    ImGui::Checkbox(switches[k].first, switches[k].second);
  }
  session.show_contacts(view.contacts);
  ImGui::SliderInt("samples", &view.samples, 1, 2);
  auto percent = static_cast<int>(view.scale * 100);
  if (ImGui::SliderInt("pixels, %", &percent, 25, 100)) view.scale = percent / 100.0;
}

void draw_figures(const replay::LiveFrame& frame, const WindowFigures& figures, const Screen& screen) {
  ImGui::Text("%.1f frames/s  draw %.1f ms", figures.frames_per_second, screen.seconds() * 1e3);
  ImGui::Text("step %.2f ms of %.1f ms", frame.step_seconds * 1e3, frame.dt * 1e3);
  ImGui::Text("%zu bodies, %llu move", frame.is_moving.size(), static_cast<unsigned long long>(frame.moving));
  if (!ImGui::TreeNode("step by phase, ms")) return;
  const auto most = frame.phase_seconds.empty() ? 0 : *std::ranges::max_element(frame.phase_seconds);
  const auto line = [&](const char* name, double seconds) {
    ImGui::ProgressBar(static_cast<float>(seconds / std::max(most, 1e-9)), ImVec2(36, 8), "");
    ImGui::SameLine();
    ImGui::Text("%6.3f %s", seconds * 1e3, name);
  };
  double rest = frame.step_seconds - frame.hash_seconds;
  for (std::size_t k = 0; k < frame.phase_names.size() && k < frame.phase_seconds.size(); ++k) {
    line(frame.phase_names[k], frame.phase_seconds[k]);
    rest -= frame.phase_seconds[k];
  }
  line("hashes", frame.hash_seconds);
  line("inputs, log", std::max(rest, 0.0));
  ImGui::TreePop();
}

void draw_messages(const replay::LiveFrame& frame) {
  ImGui::TextWrapped("%s", frame.log.c_str());
  if (!frame.notice.empty()) ImGui::TextWrapped("%s", frame.notice.c_str());
  if (frame.restored > 0) {
    ImGui::TextColored(kWarning, "floating point restored %llu times", static_cast<unsigned long long>(frame.restored));
  }
}

void begin_fixed(const char* name, const ImVec2& at, const ImVec2& size) {
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoSavedSettings);
}

void draw_panel(const replay::LiveFrame& frame, const WindowFigures& figures, const Screen& screen, Hand& hand,
                replay::LiveSession& session, ViewState& view) {
  begin_fixed("panel", {0, 0}, {kWidth, ImGui::GetIO().DisplaySize.y});
  ImGui::PushItemWidth(kWidth * 0.5F);
  draw_figures(frame, figures, screen);
  draw_time(frame, hand, session);
  ImGui::Separator();
  draw_hand(view);
  if (ImGui::CollapsingHeader("world")) draw_world(frame, session);
  if (ImGui::CollapsingHeader("picture")) draw_looks(session, view);
  ImGui::Separator();
  draw_messages(frame);
  ImGui::TextDisabled("F1: keys   H: hide");
  ImGui::PopItemWidth();
  ImGui::End();
}

// The bar at the pointer, and the body that a tool would act on.
void draw_pointer(const Hand& hand, const ViewState& view) {
  const double part = hand.held();
  if (part > 0 && (view.tool == Tool::kThrow || view.tool == Tool::kPush)) {
    const double most = view.tool == Tool::kThrow ? view.fastest : view.strongest;
    ImGui::SetTooltip("%.1f m/s", part * most);
  } else if (hand.pointed()) {
    ImGui::SetTooltip("%s body %llu", kToolNames[static_cast<int>(view.tool)],
                      static_cast<unsigned long long>(hand.pointed()->id));
  }
}

}  // namespace

void draw_over(const replay::LiveFrame& frame, const WindowFigures& figures, const Screen& screen, Hand& hand,
               replay::LiveSession& session, ViewState& view) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  if (view.panel) draw_panel(frame, figures, screen, hand, session, view);
  if (view.keys) {
    ImGui::SetNextWindowPos({size.x - 10, 10}, ImGuiCond_Always, {1, 0});
    ImGui::Begin("keys", &view.keys, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextUnformatted(kKeys);
    ImGui::End();
  }
  if (!frame.ended.empty()) {
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(size.x * 0.6F, 500.0F), 0});
    ImGui::Begin("the session ended", nullptr, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    ImGui::TextWrapped("%s", frame.ended.c_str());
    ImGui::TextWrapped("Its log is complete up to the step before. B goes back ten seconds, R begins again.");
    ImGui::End();
  }
  draw_pointer(hand, view);
}

}  // namespace tumble::tools
