// The timeline under the view: a lane for each quantity, marks for inputs, gaps, the first difference and what a search
// found, and a cursor. The words of each lane say its value at the step shown.
import { element } from "../theme.js";

const kLaneHeight = 30;
const kMarksHeight = 22;

const canvas_of = (height) => {
  const canvas = element("canvas", {});
  canvas.setAttribute("aria-hidden", "true");
  canvas.style.height = `${height}px`;
  return canvas;
};

function prepared(canvas) {
  const scale = Math.min(devicePixelRatio, 2);
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * scale) || canvas.height !== Math.round(height * scale)) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
  }
  const context = canvas.getContext("2d", { willReadFrequently: true });  // not by the GPU: small pictures, seldom drawn
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

/// Lowest and highest value of each pixel column; none: whether a row without a value lies there, over which no line goes.
function columns_of(rows, lane, x_of, width) {
  const low = new Float64Array(Math.ceil(width) + 1).fill(Infinity);
  const high = new Float64Array(Math.ceil(width) + 1).fill(-Infinity);
  const none = new Uint8Array(low.length);
  for (let i = 0; i < rows.count; ++i) {
    const value = lane.of(rows, i);
    const x = Math.min(low.length - 1, Math.max(0, Math.round(x_of(rows.step[i]))));
    if (value === null || value === undefined || !Number.isFinite(value)) {
      if (lane.parts || rows.read[i] === 0) none[x] = 1;
      continue;
    }
    if (value < low[x]) low[x] = value;
    if (value > high[x]) high[x] = value;
  }
  return { low, high, none };
}

/// Runs of pixel columns without one between them that has rows and no value: the columns of each that have a value.
function runs_of({ high, none }) {
  const runs = [];
  let open = false;
  for (let x = 0; x < high.length; ++x) {
    if (high[x] === -Infinity) {
      if (none[x]) open = false;
      continue;
    }
    if (!open) runs.push([]);
    open = true;
    runs.at(-1).push(x);
  }
  return runs;
}

function range_of({ low, high }, lane, rows) {
  let bottom = Infinity;
  let top = -Infinity;
  for (let x = 0; x < low.length; ++x) {
    if (low[x] < bottom) bottom = low[x];
    if (high[x] > top) top = high[x];
  }
  if (bottom === Infinity) return null;
  if (lane.top) top = lane.top(rows);
  if (!lane.fit && !lane.log) bottom = Math.min(0, bottom);
  if (lane.log) bottom = Math.max(bottom, 1e-18);
  if (top <= bottom) top = bottom + (bottom === 0 ? 1 : Math.abs(bottom));
  return { bottom, top };
}

function draw_lane(canvas, lane, rows, x_of, colour, hue) {
  const { context, width, height } = prepared(canvas);
  const found = columns_of(rows, lane, x_of, width);
  const range = range_of(found, lane, rows);
  if (!range) return false;
  const scaled = lane.log ? (value) => Math.log(Math.max(value, 1e-18)) : (value) => value;
  const [bottom, top] = [scaled(range.bottom), scaled(range.top)];
  const y_of = (value) => height - 2 - (height - 5) * (scaled(value) - bottom) / Math.max(top - bottom, 1e-300);
  context.fillStyle = context.strokeStyle = colour;
  if (lane.broken) {
    context.fillStyle = hue.bad;
    for (let i = 0; i < rows.count; ++i) if (lane.broken(rows, i)) context.fillRect(x_of(rows.step[i]), height - 4, 2, 4);
    context.fillStyle = colour;
  }
  if (lane.kind === "bars") {
    for (let x = 0; x < found.high.length; ++x) {
      if (found.high[x] > 0) context.fillRect(x, y_of(found.high[x]), 1.2, height - 1 - y_of(found.high[x]));
    }
    return true;
  }
  context.lineWidth = 1.4;
  context.lineJoin = "round";
  for (const run of runs_of(found)) {
    context.beginPath();
    context.moveTo(run[0], y_of(found.high[run[0]]));
    for (const x of run) {
      context.lineTo(x, y_of(found.high[x]));
      if (found.low[x] !== found.high[x]) context.lineTo(x, y_of(found.low[x]));
    }
    if (run.length === 1) context.lineTo(run[0] + 1.4, y_of(found.low[run[0]]));  // one state alone is a point
    context.stroke();
    if (lane.kind !== "area") continue;
    context.lineTo(run.at(-1), height);
    context.lineTo(run[0], height);
    context.globalAlpha = 0.25;
    context.fill();
    context.globalAlpha = 1;
  }
  return true;
}

/// One session's timeline. range(): {first, last}. seek(step): called when a place is pressed. marks(): {gaps, inputs,
/// hits, first_difference, thin_steps}. hues(): as theme.js has them.
export function make_timeline({ rows, range, seek, marks, hues }) {
  const place = element("div", { className: "timeline", role: "group", ariaLabel: "timeline: values at the step shown" });
  const cursor = element("div", { className: "cursor" });
  const marks_canvas = canvas_of(kMarksHeight);
  const marks_words = element("span", { className: "value" });
  let lanes = [];
  let step = 0;
  const x_of = (width) => (one) => (one - range().first) / Math.max(1, range().last - range().first) * (width - 1);

  const lane_row = (name, value, canvas, title = "") => element("div", { className: "lane", title },
    element("div", { className: "label" }, element("span", { textContent: name }), value), canvas);
  const set_lanes = (wanted) => {
    lanes = wanted.map((lane) => {
      const canvas = canvas_of(kLaneHeight);
      const value = element("span", { className: "value" });
      return { lane, canvas, value, row: lane_row(lane.name, value, canvas, lane.title ?? "") };
    });
    place.replaceChildren(lane_row("events", marks_words, marks_canvas), ...lanes.map(({ row }) => row), cursor);
  };

  const draw_marks = () => {
    const { context, width, height } = prepared(marks_canvas);
    const hue = hues();
    const { gaps, inputs, hits, first_difference } = marks();
    const x = x_of(width);
    context.fillStyle = hue.line;
    context.fillRect(0, height / 2 - 1, width, 2);
    for (const [first, last] of gaps) {
      context.fillStyle = hue.bad;
      context.globalAlpha = 0.35;
      context.fillRect(x(first), 2, Math.max(2, x(last) - x(first)), height - 4);
      context.globalAlpha = 1;
    }
    context.fillStyle = hue.select;
    for (const run of hits) context.fillRect(x(run.first), height - 7, Math.max(2, x(run.last) - x(run.first)), 6);
    context.fillStyle = hue.ink;
    for (const { step: at } of inputs) {
      const left = x(at);
      context.beginPath();
      context.moveTo(left - 4, 1);
      context.lineTo(left + 4, 1);
      context.lineTo(left, 9);
      context.fill();
    }
    if (first_difference !== null) {
      context.fillStyle = hue.bad;
      context.fillRect(x(first_difference) - 1, 0, 2, height);
      context.beginPath();
      context.moveTo(x(first_difference) + 1, 0);
      context.lineTo(x(first_difference) + 9, 4);
      context.lineTo(x(first_difference) + 1, 8);
      context.fill();
    }
  };
  const say = () => {
    const found = rows.index(step);
    const i = rows.reaches(step) ? found : -1;  // the timeline may not be read that far yet
    for (const { lane, value } of lanes) value.textContent = i < 0 || rows.step[i] === undefined ? "–" : lane.words(rows, i);
    const inputs = marks().inputs.filter((one) => one.step === step);
    marks_words.textContent = inputs.length > 0 ? inputs.map(({ kind, body }) => `${kind}${body ? ` ${body}` : ""}`).join(", ")
      : `${marks().inputs.length} input${marks().inputs.length === 1 ? "" : "s"}`;
    const at = marks_canvas.offsetLeft + x_of(marks_canvas.clientWidth)(step);
    cursor.style.transform = `translateX(${at}px)`;
  };
  const draw = () => {
    if (marks_canvas.clientWidth === 0) return;
    const hue = hues();
    draw_marks();
    lanes.forEach(({ lane, canvas, row }, k) => {
      const any = draw_lane(canvas, lane, rows, x_of(canvas.clientWidth), lane.bad ? hue.bad : hue.lanes[k % hue.lanes.length], hue);
      row.hidden = !any && (lane.only_if_any || lane.late);
    });
    say();
  };

  const press = (event) => {
    if (event.buttons === 0) return;
    const box = marks_canvas.getBoundingClientRect();
    const share = Math.min(1, Math.max(0, (event.clientX - box.left) / Math.max(1, box.width - 1)));
    seek(Math.round(range().first + share * (range().last - range().first)));
  };
  place.addEventListener("pointerdown", (event) => {
    if (event.target.tagName !== "CANVAS") return;
    place.setPointerCapture(event.pointerId);
    press(event);
  });
  place.addEventListener("pointermove", press);
  new ResizeObserver(draw).observe(place);
  return {
    place, draw, set_lanes,
    show(wanted) {
      step = wanted;
      say();
    },
  };
}
