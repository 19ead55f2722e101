// Expected and actual picture in one place: a slider that uncovers one from under the other, and a blink that shows
// both in turn, the eye's own way to find a difference.
import { element } from "./theme.js";

const kBlinkMs = 700;  // slow enough for those whom flicker harms

const copy_of = (figure, name) => element("img", { src: figure.querySelector("img").src, alt: `${name} picture` });

/// place: the three figures of a picture. One without a golden has nothing to compare.
export function make_picture_viewer(place) {
  const figure = (kind) => place.querySelector(`figure[data-kind="${kind}"]`);
  if (!figure("expected") || !figure("actual")) return;
  const under = copy_of(figure("expected"), "expected");
  const over = copy_of(figure("actual"), "actual");
  const map = figure("difference") ? copy_of(figure("difference"), "difference") : null;
  over.className = "over";
  const edge = element("div", { className: "edge" });
  const left = element("span", { className: "tag", textContent: "expected" });
  const right = element("span", { className: "tag right", textContent: "actual" });
  const stack = element("div", { className: "stack" }, under, over, edge, left, right);
  const slider = element("input", { type: "range", min: 0, max: 100, value: 50, className: "picture-slider" });
  slider.setAttribute("aria-label", `step ${place.dataset.step}: expected to the left of the edge, actual to the right`);
  const said = element("output");
  const blink = element("button", { type: "button", textContent: "Blink", className: "picture-blink" });
  const difference = element("button", { type: "button", textContent: "Difference" });
  if (map) {
    map.className = "over";
    stack.append(map);
  }

  let timer = null;
  let shows_map = false;
  const show = (share) => {  // of the width, per cent, that shows the expected picture
    over.style.clipPath = `inset(0 0 0 ${share}%)`;
    edge.style.left = `${share}%`;
    edge.hidden = share <= 0 || share >= 100 || shows_map;
    left.hidden = share <= 0 || shows_map;
    right.hidden = share >= 100 || shows_map;
    if (map) map.hidden = !shows_map;
    if (shows_map) said.value = "difference: the brighter, the further apart";
    else if (share >= 100) said.value = "expected";
    else if (share <= 0) said.value = "actual";
    else said.value = `left of the edge expected, right of it actual`;
  };
  const stop_blink = () => {
    clearInterval(timer);
    timer = null;
    blink.setAttribute("aria-pressed", "false");
  };
  const set_map = (on) => {
    shows_map = on;
    difference.setAttribute("aria-pressed", String(on));
  };
  slider.addEventListener("input", () => {
    stop_blink();
    set_map(false);
    show(Number(slider.value));
  });
  blink.addEventListener("click", () => {
    const was_on = timer !== null;
    stop_blink();
    set_map(false);
    if (was_on) return show(Number(slider.value));
    let expected = true;
    blink.setAttribute("aria-pressed", "true");
    show(100);
    timer = setInterval(() => {
      expected = !expected;
      show(expected ? 100 : 0);
    }, kBlinkMs);
  });
  difference.addEventListener("click", () => {
    stop_blink();
    set_map(!shows_map);
    show(Number(slider.value));
  });
  stop_blink();
  set_map(false);
  show(50);
  const controls = element("div", { className: "controls" }, slider, blink,
    ...(map ? [difference] : []), said);
  place.prepend(element("div", { className: "viewer" }, stack, controls));
}
