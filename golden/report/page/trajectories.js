// The trajectories of one case of a check: the viewer over the frames that the golden's coarse track has, boxes where
// this run has the bodies, diamonds where they were expected. The words under it say what the view shows.
import { turns_of } from "./viewer/bodies.js";
import { make_player, Steps } from "./viewer/player.js";
import { box_around, listen } from "./viewer/pointer.js";
import { make_stage } from "./viewer/stage.js";
import { colours, element, largest, metres } from "./theme.js";

export const kApartMm = 2;  // nearer than this, millimetres alone can make the difference
const kSeenShare = 0.05;    // of a body's smallest edge, or of the session's largest distance if that is less
const kWaysMax = 40;        // more lines hide what they show
const kPlay_s = 0.15;       // a frame, played at ×1

/// A row's coordinates of body i, m; null where any of them is unknown or not finite.
const place_of = (row, i) => {
  const numbers = row === null ? [null] : row.slice(3 * i, 3 * i + 3);
  return numbers.includes(null) ? null : numbers.map((value) => value / 1000);
};

/// How far each body of each frame is from where it was expected, mm; null where that is not known.
function distances(data) {
  const { actual_mm, expected_mm } = data.frames;
  return actual_mm.map((actual, f) => data.bodies.id.map((_, i) => {
    const a = place_of(actual, i);
    const b = place_of(expected_mm[f], i);
    return a && b ? 1000 * Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) : null;
  }));
}

/// From how far apart a body gets a diamond, mm: what cannot be seen would only hide what can.
function seen_from(data, apart) {
  const worst = largest([0, ...apart.flat()]);
  return data.bodies.id.map((_, i) => {
    const edge = 1000 * Math.min(...data.bodies.size.slice(3 * i, 3 * i + 3));
    return Math.max(kApartMm, kSeenShare * Math.min(worst, edge > 0 ? edge : worst));
  });
}

/// One row of places and turns as the stage takes a frame.
function frame_of(data, row, turn) {
  const rows = data.bodies.id.length;
  const frame = { rows, x: new Float32Array(rows), y: new Float32Array(rows), z: new Float32Array(rows),
    mark: new Uint8Array(rows), turn: turns_of(rows, (i) => {
      const parts = turn?.slice(4 * i, 4 * i + 4) ?? [];
      return parts.length === 4 && !parts.includes(null) ? parts : [1, 0, 0, 0];
    }) };
  for (let i = 0; i < rows; ++i) {
    const place = place_of(row, i);
    if (!place) continue;
    [frame.x[i], frame.y[i], frame.z[i]] = place;
    frame.mark[i] = 1;
  }
  return frame;
}

/// From frame to frame, for the bodies that went furthest from where they were expected.
function ways_of(data, rows, apart) {
  const worst = data.bodies.id.map((_, i) => largest(apart.map((frame) => frame[i] ?? 0)));
  const chosen = worst.map((_, i) => i).sort((a, b) => worst[b] - worst[a]).slice(0, kWaysMax);
  const points = [];
  for (const i of chosen) {
    for (let f = 1; f < rows.length; ++f) {
      const from = place_of(rows[f - 1], i);
      const to = place_of(rows[f], i);
      if (from && to) points.push(...from, ...to);
    }
  }
  return points;
}

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
  const lost = data.bodies.id.filter((_, i) => !place_of(data.frames.actual_mm[frame], i));
  const without = lost.length === 0 ? "" : `; body ${lost[0]}${lost.length > 1 ? ` and ${lost.length - 1} more` : ""} without a place (gone, or not finite)`;
  if (known.length === 0) return `${step}: nothing to compare here${without}`;
  const worst = known.reduce((a, b) => (b.value > a.value ? b : a));
  const astray = known.filter(({ value }) => value > kApartMm).length;
  if (astray === 0) return `${step}: every body within ${kApartMm} mm of where it was expected${without}`;
  return `${step}: ${astray} of ${known.length} bodies elsewhere, the furthest is body ${worst.id}, ` +
    `${metres(worst.value / 1000)} away${without}`;
}

function table_of(data) {
  return { count: data.bodies.id.length, body: (i) => ({ shape: "box", size: data.bodies.size.slice(3 * i, 3 * i + 3) }) };
}

function box_of(data) {
  const rows = [...data.frames.actual_mm, ...data.frames.expected_mm].filter((row) => row !== null);
  const places = [0, 1, 2].map((c) => rows.flatMap((row) => row.filter((value, k) => k % 3 === c && value !== null))
    .map((value) => value / 1000));
  return box_around(places, largest([...data.bodies.size, 0.1]));
}

/// Holds the view only while it is to be seen: browsers keep but a few WebGL contexts.
class View {
  constructor(place, data, apart) {
    Object.assign(this, { place, data, apart, frame: 0, stage: null, last_view: null });
    this.limits = seen_from(data, apart);
    new IntersectionObserver((entries) => {
      if (entries.at(-1).isIntersecting) this.open();
      else this.close();
    }, { rootMargin: "100px" }).observe(place);
  }

  open() {
    if (this.stage) return;
    const canvas = element("canvas", { tabIndex: 0 });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The bodies in three dimensions. Arrow keys turn the view, with Shift they move it, + and - zoom.");
    this.place.replaceChildren(canvas);
    const hue = colours();
    const box = box_of(this.data);
    try {
      this.stage = make_stage(canvas, { hue, box });
    } catch {
      this.place.textContent = "This browser has no WebGL, so there is no view; the words below say the same.";
      return;
    }
    if (this.last_view) Object.assign(this.stage.view, this.last_view);
    this.actual = this.stage.add_session("solid", hue.actual);
    this.expected = this.stage.add_session("marks", hue.expected);
    for (const session of [this.actual, this.expected]) session.describe(table_of(this.data));
    this.stage.set_lines("actual", { points: ways_of(this.data, this.data.frames.actual_mm, this.apart), colour: hue.actual });
    this.stage.set_lines("expected", { points: ways_of(this.data, this.data.frames.expected_mm, this.apart),
      colour: hue.expected, dash: box.radius / 40 });
    listen(canvas, this.stage);
    this.resize();
    this.show(this.frame);
  }

  close() {
    if (!this.stage) return;
    this.last_view = { ...this.stage.view };
    this.stage.dispose();
    this.stage = null;
    this.place.replaceChildren();
  }

  show(f) {
    this.frame = f;
    if (!this.stage) return;
    const { frames, bodies } = this.data;
    const near = (i) => this.apart[f][i] !== null && this.apart[f][i] <= this.limits[i];
    this.actual.show(frame_of(this.data, frames.actual_mm[f], frames.actual_turn[f]),
      { colour: (row, tone) => tone.offsetHSL(0, 0, 0.035 * (row % 5 - 2)) });
    this.expected.show(frame_of(this.data, frames.expected_mm[f], null), { hidden: near });
    const links = bodies.id.flatMap((_, i) => {
      const from = place_of(frames.actual_mm[f], i);
      const to = place_of(frames.expected_mm[f], i);
      return from && to && !near(i) ? [...from, ...to] : [];
    });
    this.stage.set_lines("links", { points: links, colour: colours().bad, on_top: true });
    this.stage.draw_now();
  }

  resize() {
    const { clientWidth, clientHeight } = this.place;
    if (clientWidth > 0) this.stage?.resize(clientWidth, clientHeight);
  }
}

/// Puts the view into a case's section. tell_step: called with the step shown. Null where there is no frame.
export function make_trajectories(section, data, tell_step) {
  const last = data.frames.step.length - 1;
  if (last < 0 || data.bodies.id.length === 0) return null;
  const apart = distances(data);
  const place = element("div", { className: "view3d" });
  const said = element("output");
  const view = new View(place, data, apart);
  const player = make_player({ steps: new Steps(0, last), dt: () => kPlay_s, full: false, show: (frame) => {
    const words = words_of(data, apart, frame);
    player.slider.setAttribute("aria-valuetext", words);
    said.value = words;
    view.show(frame);
    tell_step(data.frames.step[frame]);
  } });
  section.append(
    element("h3", { textContent: "Where the bodies went" }), keys(), place,
    element("div", { className: "controls" }, player.bar, said),
    element("p", { className: "soft", textContent: "Drag or use the arrow keys to turn, + and - to zoom. " +
      `Lines: the ways of ${data.bodies.id.length > kWaysMax ? `the ${kWaysMax} of ${data.bodies.id.length} bodies that went furthest astray` : "the bodies"}.` }));
  // Begins where there is most to see.
  const worst = apart.map((frame) => largest(frame.map((value) => value ?? 0)));
  player.seek(worst.indexOf(largest(worst)));
  player.refresh();
  return {
    resize: () => view.resize(),
    redraw() {
      view.close();
      view.open();
    },
  };
}
