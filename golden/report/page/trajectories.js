// The trajectories of one case: a view in three dimensions with a scrubber over the frames that the golden's coarse
// track has. The words under it say what the view shows.
import { distances, kApartMm, make_scene, numbers_of } from "./scene3d.js";
import { colours, element, metres } from "./theme.js";

const kFrameMs = 150;
const kTurn = 0.12;  // radians a key press
const kDrag = 0.008;  // radians a pixel

const key = (drawing, words) => {
  const item = element("span", { className: "key" });
  item.innerHTML = `<svg viewBox="0 0 36 16" aria-hidden="true" fill="none" stroke-width="2">${drawing}</svg>`;
  item.append(words);
  return item;
};

function keys() {
  return element("p", {},
    key(`<path d="M0 8H36" stroke="var(--actual)"/><rect x="12" y="2" width="12" height="12" fill="var(--actual)"/>`,
      "this run"),
    key(`<path d="M0 8H36" stroke="var(--expected)" stroke-dasharray="5 4"/>
      <path d="M18 1l7 7-7 7-7-7z" stroke="var(--expected)"/>`, "expected, if to be seen elsewhere"),
    key(`<path d="M0 8H36" stroke="var(--bad)"/>`, "from one to the other"));
}

function words_of(data, apart, frame) {
  const known = apart[frame].map((value, i) => ({ value, id: data.bodies.id[i] })).filter(({ value }) => value !== null);
  const step = `step ${data.frames.step[frame]}`;
  const lost = data.bodies.id.filter((_, i) => !numbers_of(data.frames.actual_mm[frame], i));
  const without = lost.length === 0 ? "" : `; body ${lost[0]}${lost.length > 1 ? ` and ${lost.length - 1} more` : ""} without a place (gone, or not finite)`;
  if (known.length === 0) return `${step}: nothing to compare here${without}`;
  const worst = known.reduce((a, b) => (b.value > a.value ? b : a));
  const astray = known.filter(({ value }) => value > kApartMm).length;
  if (astray === 0) return `${step}: every body within ${kApartMm} mm of where it was expected${without}`;
  return `${step}: ${astray} of ${known.length} bodies elsewhere, the furthest is body ${worst.id}, ` +
    `${metres(worst.value / 1000)} away${without}`;
}

/// Turning and zooming by pointer, wheel and keys. The wheel only when the view has the focus: pages scroll.
function listen(canvas, scene) {
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons !== 0) scene.turn(-kDrag * event.movementX, kDrag * event.movementY);
  });
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    scene.zoom(Math.exp(event.deltaY / 800));
  }, { passive: false });
  const actions = {
    ArrowLeft: () => scene.turn(-kTurn, 0), ArrowRight: () => scene.turn(kTurn, 0),
    ArrowUp: () => scene.turn(0, kTurn), ArrowDown: () => scene.turn(0, -kTurn),
    "+": () => scene.zoom(0.85), "=": () => scene.zoom(0.85), "-": () => scene.zoom(1 / 0.85),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
  });
}

/// Holds the view only while it is to be seen: browsers keep but a few WebGL contexts.
class View {
  constructor(place, data) {
    this.place = place;
    this.data = data;
    this.frame = 0;
    this.scene = null;
    this.last_view = null;
    new IntersectionObserver((entries) => {
      if (entries.at(-1).isIntersecting) this.open();
      else this.close();
    }, { rootMargin: "100px" }).observe(place);
  }

  open() {
    if (this.scene) return;
    const canvas = element("canvas", { tabIndex: 0 });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The bodies in three dimensions. Arrow keys turn the view, + and - zoom.");
    this.place.replaceChildren(canvas);
    try {
      this.scene = make_scene(canvas, this.data, colours());
    } catch {
      this.place.textContent = "This browser has no WebGL, so there is no view; the words below say the same.";
      return;
    }
    if (this.last_view) Object.assign(this.scene.view, this.last_view);
    listen(canvas, this.scene);
    this.resize();
    this.scene.show(this.frame);
  }

  close() {
    if (!this.scene) return;
    this.last_view = { ...this.scene.view };
    this.scene.dispose();
    this.scene = null;
    this.place.replaceChildren();
  }

  show(frame) {
    this.frame = frame;
    this.scene?.show(frame);
  }

  resize() {
    const { clientWidth, clientHeight } = this.place;
    if (clientWidth > 0) this.scene?.resize(clientWidth, clientHeight);
  }
}

/// A button that runs the scrubber to its end, and stops when pressed again.
function play_button(slider, last, show) {
  const button = element("button", { type: "button", textContent: "Play", className: "play" });
  let timer = null;
  const stop = () => {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  };
  button.addEventListener("click", () => {
    if (timer !== null) return stop();
    let frame = Number(slider.value) >= last ? 0 : Number(slider.value);
    button.textContent = "Pause";
    timer = setInterval(() => {
      show(frame);
      if (frame++ >= last) stop();
    }, kFrameMs);
  });
  return { button, stop };
}

/// Puts the view into a case's section. tell_step: called with the step shown. Null where there is no frame.
export function make_trajectories(section, data, tell_step) {
  const last = data.frames.step.length - 1;
  if (last < 0 || data.bodies.id.length === 0) return null;
  const apart = distances(data);
  const place = element("div", { className: "view3d" });
  const slider = element("input", { type: "range", min: 0, max: last, value: 0, className: "scrubber" });
  slider.setAttribute("aria-label", "step shown");
  const said = element("output");
  const view = new View(place, data);
  const show = (frame) => {
    const words = words_of(data, apart, frame);
    slider.value = frame;
    slider.setAttribute("aria-valuetext", words);
    said.value = words;
    view.show(frame);
    tell_step(data.frames.step[frame]);
  };
  const { button, stop } = play_button(slider, last, show);
  slider.addEventListener("input", () => {
    stop();
    show(Number(slider.value));
  });
  section.append(
    element("h3", { textContent: "Where the bodies went" }), keys(), place,
    element("div", { className: "controls" }, button, slider, said),
    element("p", { className: "soft", textContent: "Drag or use the arrow keys to turn, + and - to zoom. " +
      "Lines: the ways of the bodies that went furthest astray." }));
  // Begins where there is most to see.
  const worst = apart.map((frame) => Math.max(...frame.map((value) => value ?? 0)));
  show(worst.indexOf(Math.max(...worst)));
  return {
    resize: () => view.resize(),
    redraw() {
      view.close();
      view.open();
    },
  };
}
