// Makes the static page of a check livelier: plots, trajectories and pictures of the failed cases. Without it the page
// still says everything in words. Each case is drawn when it comes into view, and not before. Draws the page of
// `tumble view` too, by the same viewer.
import uplot_style from "uplot/dist/uPlot.min.css";
import style from "./style.css";
import session_style from "./session/session.css";
import { draw_plots } from "./plots.js";
import { make_picture_viewer } from "./pictures.js";
import { make_overview } from "./table.js";
import { make_trajectories } from "./trajectories.js";
import { open_session } from "./session/session.js";
import { watch_theme } from "./theme.js";

function draw_case(place) {
  const data = JSON.parse(place.querySelector("script").textContent);
  place.replaceChildren();
  const first = place.dataset.first === undefined ? null : Number(place.dataset.first);
  const groups = (place.dataset.groups ?? "").split(" ");
  const plots = draw_plots(place, data, { first, groups });
  const trajectories = make_trajectories(place, data, plots.show_step);
  watch_theme(() => {
    plots.redraw();
    trajectories?.redraw();
  });
  const watcher = new ResizeObserver(() => {
    plots.resize();
    trajectories?.resize();
  });
  watcher.observe(place);
}

function once_visible(element, action) {
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    action(element);
  }, { rootMargin: "200px" });
  observer.observe(element);
}

// A broken drawing must not look like one that has nothing to show.
function guarded(action) {
  return (element) => {
    try {
      action(element);
    } catch (error) {
      const words = document.createElement("p");
      words.textContent = `This cannot be drawn: ${error.message}`;
      element.append(words);
      throw error;
    }
  };
}

const sheet = document.createElement("style");
sheet.textContent = uplot_style + style + session_style;
document.head.append(sheet);
for (const table of document.querySelectorAll("table.glance")) guarded(make_overview)(table);
for (const place of document.querySelectorAll(".drawing")) {
  place.querySelector("p").textContent = "Plots and trajectories are drawn once they are in view.";  // there is JavaScript
  once_visible(place, guarded(draw_case));
}
for (const place of document.querySelectorAll(".pictures")) guarded(make_picture_viewer)(place);
const session = document.getElementById("session");
if (session) open_session(session);
