// Where a page that was sent has its sessions from: from itself, unpacked.
import { kAbsent } from "../viewer/bodies.js";
import { BodyTable } from "./bodies_table.js";
import { TimelineRows } from "./timeline_rows.js";

const bytes_of = (id) => {
  const text = document.getElementById(id).textContent;
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
};

async function inflated(id) {
  if (!("DecompressionStream" in window)) throw new Error("this browser is too old to unpack the page (no DecompressionStream)");
  const stream = new Blob([bytes_of(id)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

const json_in = async (id) => JSON.parse(new TextDecoder().decode(await inflated(id)));

const unzigzag = (word) => (word >>> 1) ^ -(word & 1);

/// Undoes replay/view/packed_states.h: columns of F frames, frame after frame, N rows each.
function unpack(bytes, frames, rows, quantum) {
  const cells = frames * rows;
  const columns = { place: [], turn: new Int16Array(4 * cells), mark: new Uint8Array(cells) };
  let at = 0;
  for (let axis = 0; axis < 3; ++axis) {
    const out = new Float32Array(cells);
    for (let row = 0, cell = 0; row < rows; ++row) {
      let one = 0;
      let two = 0;
      for (let f = 0; f < frames; ++f, ++cell) {
        const p = at + cell;
        const word = bytes[p] | bytes[p + cells] << 8 | bytes[p + 2 * cells] << 16 | bytes[p + 3 * cells] << 24;
        const value = (unzigzag(word) + 2 * one - two) | 0;
        two = one;
        one = value;
        out[f * rows + row] = value * quantum;
      }
    }
    columns.place.push(out);
    at += 4 * cells;
  }
  for (let part = 0; part < 4; ++part) {
    for (let row = 0, cell = 0; row < rows; ++row) {
      let one = 0;
      let two = 0;
      for (let f = 0; f < frames; ++f, ++cell) {
        const word = bytes[at + cell] | bytes[at + cells + cell] << 8;
        const value = (unzigzag(word) + 2 * one - two) << 16 >> 16;
        two = one;
        one = value;
        columns.turn[(4 * f + part) * rows + row] = value;
      }
    }
    at += 2 * cells;
  }
  for (let row = 0, cell = 0; row < rows; ++row) {
    for (let f = 0; f < frames; ++f, ++cell) columns.mark[f * rows + row] = bytes[at + cell];
  }
  return columns;
}

class SentSession {
  constructor(head, details, packed) {
    this.head = head;
    this.thin = head.thin;
    this.bodies = new BodyTable(details.bodies);
    this.rows = new TimelineRows(head.channels, !head.ours);
    this.rows.append(details.timeline);
    this.rows.events = details.inputs;
    this.rows.begun = details.timeline.begun.length > 0 ? [0, ...details.timeline.begun] : [];
    this.rows.begun_why_not = details.timeline.begun_why_not;
    this.contacts = details.contacts;
    this.steps = head.thin.steps;
    this.columns = unpack(new Uint8Array(packed), this.steps.length, this.bodies.count, head.thin.quantum);
    this.index = new Map(this.steps.map((step, f) => [step, f]));
    this.timeline_done = true;
  }

  /// [first, last, why] of steps that are not there: those that the log lacks, and those that could not be read.
  gaps() {
    const known = this.head.gaps;
    return [...known, ...this.rows.unread().filter(([first]) => !known.some(([low, high]) => first >= low && first <= high))];
  }

  gap_at(step) { return this.gaps().find(([first, last]) => step >= first && step <= last) ?? null; }

  frame(step) {
    const f = this.index.get(step);
    if (f === undefined) return null;
    const rows = this.bodies.count;
    const part = (column) => column.subarray(f * rows, (f + 1) * rows);
    const [x, y, z] = this.columns.place.map(part);
    return { step, status: 0, rows, x, y, z, turn: this.columns.turn.subarray(4 * f * rows, 4 * (f + 1) * rows),
      mark: part(this.columns.mark), speed: this.speeds(f, x, y, z) };
  }

  /// About: from the places of this state and the one before.
  speeds(f, ...now) {
    const rows = this.bodies.count;
    const speed = new Float32Array(rows);
    const [from, to] = f > 0 ? [f - 1, f] : [f, f + 1];
    if (to >= this.steps.length) return speed;
    const seconds = this.time_of(this.steps[to]) - this.time_of(this.steps[from]);
    const other = this.columns.place.map((column) => column.subarray((f > 0 ? from : to) * rows));
    const mark = this.columns.mark.subarray((f > 0 ? from : to) * rows);
    for (let row = 0; row < rows; ++row) {
      if (mark[row] === kAbsent) continue;
      speed[row] = Math.hypot(...now.map((axis, c) => axis[row] - other[c][row])) / Math.max(seconds, 1e-9);
    }
    return speed;
  }

  time_of(step) {
    const i = this.rows.index(step);
    return i < 0 ? 0 : this.rows.time[i] + (step - this.rows.step[i]) * this.head.dt;
  }

  async frame_soon(step) { return this.frame(step); }
  prefetch() {}

  async contacts_at(step) {
    const rows = this.contacts[step];
    if (rows) return { step, rows };
    return { step, why_not: this.rows.why_no_contacts(step), near: this.near_contacts(step) };
  }

  near_contacts(step) {
    const known = Object.keys(this.contacts).map(Number);
    if (known.length === 0) return null;
    return known.reduce((best, one) => (Math.abs(one - step) < Math.abs(best - step) ? one : best));
  }

  async way(id) {
    const row = this.bodies.row(id);
    const rows = this.bodies.count;
    const step = [];
    const at = [];
    this.steps.forEach((one, f) => {
      const mark = this.columns.mark[f * rows + row];
      step.push(one);
      for (const column of this.columns.place) at.push(mark === 1 || mark === 2 ? column[f * rows + row] : null);
    });
    return { id, step, at };
  }

  /// As of a served page, for the states that this page has; speeds are those of speeds().
  async history(id) {
    const row = this.bodies.row(id);
    const history = { id, step: [], x: [], y: [], z: [], speed: [], asleep: [] };
    for (const step of row === undefined ? [] : this.steps) {
      const frame = this.frame(step);
      const there = frame.mark[row] === 1 || frame.mark[row] === 2;
      history.step.push(step);
      for (const axis of ["x", "y", "z", "speed"]) history[axis].push(there ? frame[axis][row] : null);
      history.asleep.push(there ? Number(frame.mark[row] === 2) : null);
    }
    return history;
  }

  async body_at(step, id) {
    const row = this.bodies.row(id);
    const frame = this.frame(step);
    if (!frame || row === undefined || frame.mark[row] === kAbsent) return { why_not: "not there in this state", absent: true };
    if (frame.mark[row] === 3) return { why_not: "a value of its state is no number" };
    const unit = 32767;
    const turn = ["w", "x", "y", "z"].map((axis, c) => ({ field: `orientation.${axis}`,
      value: Number((frame.turn[c * frame.rows + row] / unit).toFixed(4)) }));
    return { id, step, frozen: frame.mark[row] === 2, rounded: true, fields: [
      ...["x", "y", "z"].map((axis) => ({ field: `position.${axis}`, value: Number(frame[axis][row].toFixed(4)) })), ...turn,
      { field: "speed, about", value: Number(frame.speed[row].toPrecision(3)) }] };
  }
}

/// Resolves to {sessions, difference: null or the finished comparison, follow()}.
export async function open_sent(head) {
  const sessions = [];
  for (const [i, log] of head.logs.entries()) {
    const [details, packed] = await Promise.all([json_in(`session-${i}-details`), inflated(`session-${i}-frames`)]);
    sessions.push(new SentSession(log, details, packed));
  }
  const difference = document.getElementById("session-0-difference") ? await json_in("session-0-difference") : null;
  return { sessions, difference, served: false, follow() {} };
}
