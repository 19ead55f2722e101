// Buttons, scrubber and keys that move through the steps of a session, both ways and at any speed.
import { element } from "../theme.js";

const kFrameMs = 1000 / 30;
const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8, 16];

const kIcons = {
  first: "M5 4v12M16 4l-8 6 8 6z", back: "M15 4l-9 6 9 6z", less: "M12 5l-6 5 6 5", more: "M8 5l6 5-6 5",
  play: "M6 4l9 6-9 6z", last: "M15 4v12M4 4l8 6-8 6z", pause: "M6 4v12M13 4v12",
};

function icon(name) {
  const holder = document.createElement("span");
  holder.className = "icon";
  holder.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true" fill="none" stroke="currentColor" stroke-width="2" ` +
    `stroke-linejoin="round" stroke-linecap="round"><path d="${kIcons[name]}"/></svg>`;
  return holder;
}

function button(name, label, action) {
  const made = element("button", { type: "button", className: name, title: label }, icon(name));
  made.setAttribute("aria-label", label);
  made.addEventListener("click", action);
  return made;
}

/// The steps that can be shown, ascending: all of first … last, or a list.
export class Steps {
  constructor(first, last, list = null) {
    this.first = first;
    this.last = last;
    this.list = list;
  }

  /// The last one that can be shown at or before a step.
  at_or_before(step) {
    const inside = Math.min(this.last, Math.max(this.first, Math.round(step)));
    if (!this.list) return inside;
    return this.list[Math.max(0, this.rank(inside))];
  }

  rank(step) {
    let low = 0;
    let high = this.list.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.list[middle] <= step) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /// `count` further on or back.
  beside(step, count) {
    if (!this.list) return this.at_or_before(step + count);
    return this.list[Math.min(this.list.length - 1, Math.max(0, this.rank(step) + count))];
  }
}

/// steps: Steps. dt(): s a step. show(step): shows it; may be called often. full: with all buttons.
/// played(direction): playing has begun (1, -1) or ended (0).
export function make_player({ steps, dt, show, label = "step shown", full = true, played = () => {} }) {
  let step = steps.first;
  let timer = null;
  let direction = 0;
  let exact = step;  // where playing has got to
  let asked = performance.now();
  const slider = element("input", { type: "range", className: "scrubber", min: steps.first, max: steps.last, value: step });
  slider.setAttribute("aria-label", label);
  const speed = element("select", { className: "speed" }, ...kSpeeds.map((value) =>
    element("option", { value, textContent: `×${value}`, selected: value === 1 })));
  speed.setAttribute("aria-label", "speed of playing");
  const number = element("input", { type: "number", className: "step", min: steps.first, max: steps.last, value: step });
  number.setAttribute("aria-label", "step");

  const tell = () => {
    slider.value = step;
    if (document.activeElement !== number) number.value = step;
    show(step);
  };
  const stop = () => {
    clearInterval(timer);
    timer = null;
    const played_before = direction !== 0;
    direction = 0;
    mark();
    if (played_before) played(0);
  };
  const go = (wanted) => {
    const found = steps.at_or_before(wanted);
    if (found === step) {
      slider.value = step;
      return;
    }
    step = found;
    tell();
  };
  const seek = (wanted) => {
    stop();
    go(wanted);
  };
  const tick = () => {
    const now = performance.now();
    exact += direction * Number(speed.value) * Math.min(0.25, (now - asked) / 1000) / Math.max(dt(), 1e-9);
    asked = now;
    go(exact);
    if (direction > 0 ? exact >= steps.last : exact <= steps.first) stop();
  };
  const play = (way) => {
    if (direction === way) return stop();
    stop();
    direction = way;
    if (way > 0 && step >= steps.at_or_before(steps.last)) go(steps.first);
    if (way < 0 && step <= steps.first) go(steps.last);
    exact = step;
    asked = performance.now();
    timer = setInterval(tick, kFrameMs);
    mark();
    played(way);
  };
  const forward = button("play", "play", () => play(1));
  const back = button("back", "play backwards", () => play(-1));
  function mark() {
    for (const [made, way, name, words] of [[forward, 1, "play", "play"], [back, -1, "back", "play backwards"]]) {
      const runs = direction === way;
      made.replaceChildren(icon(runs ? "pause" : name));
      made.setAttribute("aria-label", runs ? "pause" : words);
      made.title = runs ? "pause" : words;
    }
  }
  const move = (count) => {
    stop();
    go(steps.beside(step, count));
  };
  slider.addEventListener("input", () => seek(Number(slider.value)));
  slider.addEventListener("keydown", (event) => {
    // Where only some steps are there, the browser's own step of one would stay on the spot.
    const count = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
    if (count === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    move(event.shiftKey ? 10 * count : count);
  });
  number.addEventListener("change", () => {
    seek(Number(number.value));
    number.value = step;
  });
  const bar = full
    ? element("div", { className: "player" }, button("first", "first step", () => seek(steps.first)), back,
      button("less", "one step back", () => move(-1)), button("more", "one step on", () => move(1)), forward,
      button("last", "last step", () => seek(steps.last)), speed, slider, number)
    : element("div", { className: "player" }, back, button("less", "one step back", () => move(-1)),
      button("more", "one step on", () => move(1)), forward, slider);
  return {
    bar, slider, seek, move, play, stop,
    get step() { return step; },
    get direction() { return direction; },
    get stride() { return Math.max(1, Number(speed.value) * kFrameMs / 1000 / Math.max(dt(), 1e-9)); },
    set_last(last) {
      const follows = step === steps.last;
      steps.last = last;
      slider.max = number.max = last;
      return follows;
    },
    refresh: tell,
  };
}
