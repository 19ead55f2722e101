// Where a served page has its sessions from: it asks its server, tumble view, for what it shows.
import { BodyTable } from "./bodies_table.js";
import { largest } from "../theme.js";
import { add_values, TimelineRows } from "./timeline_rows.js";

const kCacheBytes = 160e6;   // of frames
const kBatch = 24;           // frames asked for at once while playing
const kPollMs = 700;
const kBusyPollMs = 120;

async function ask(question, parameters = {}) {
  const words = new URLSearchParams(parameters).toString();
  const reply = await fetch(words ? `${question}?${words}` : question, { cache: "no-store" });
  if (!reply.ok) throw new Error(`${question}: ${(await reply.text()).slice(0, 200)}`);
  return reply;
}
const ask_json = async (question, parameters) => (await ask(question, parameters)).json();

/// The frames of a reply, as replay/view/state_frame.h writes them.
function frames_in(buffer) {
  const view = new DataView(buffer);
  const frames = [];
  for (let at = 0; at + 16 <= buffer.byteLength;) {
    const [step, status, rows, version] = [0, 4, 8, 12].map((k) => view.getUint32(at + k, true));
    at += 16;
    const numbers = [0, 1, 2, 3].map((c) => new Float32Array(buffer, at + 4 * c * rows, rows));
    at += 16 * rows;
    const turn = new Int16Array(buffer, at, 4 * rows);
    at += 8 * rows;
    const mark = new Uint8Array(buffer, at, rows);
    at += rows + (4 - rows % 4) % 4;
    const [x, y, z, speed] = numbers;
    frames.push({ step, status, rows, version, x, y, z, speed, turn, mark });
  }
  return frames;
}

class ServedSession {
  constructor(log, head, bodies) {
    this.log = log;
    this.head = head;
    this.thin = null;
    this.bodies = new BodyTable(bodies);
    this.rows = new TimelineRows(head.channels, !head.ours);
    this.steps = null;
    this.timeline_done = false;
    this.note = "";    // why the log cannot be opened now
    this.unread = "";  // why its timeline was not read
    this.cache = new Map();
    this.cache_bytes = 0;
    this.asked = new Set();
    this.contact_cache = new Map();
  }

  /// [first, last, why] of steps that are not there: those that the log lacks, and those that could not be read.
  gaps() {
    const known = this.head.gaps;
    return [...known, ...this.rows.unread().filter(([first]) => !known.some(([low, high]) => first >= low && first <= high))];
  }

  gap_at(step) { return this.gaps().find(([first, last]) => step >= first && step <= last) ?? null; }

  time_of(step) {
    const i = this.rows.index(step);
    return i < 0 ? (step - this.head.first) * this.head.dt : this.rows.time[i] + (step - this.rows.step[i]) * this.head.dt;
  }

  frame(step) { return this.cache.get(step) ?? null; }

  keep(frame) {
    const bytes = 29 * frame.rows + 64;
    this.cache.set(frame.step, frame);
    this.cache_bytes += bytes;
    for (const [step, old] of this.cache) {
      if (this.cache_bytes <= kCacheBytes) break;
      this.cache.delete(step);
      this.cache_bytes -= 29 * old.rows + 64;
    }
  }

  async fetch(first, count, stride) {
    const reply = await ask("frames", { log: this.log, first, count, stride });
    const frames = frames_in(await reply.arrayBuffer());
    for (const frame of frames) this.keep(frame);
    const newest = largest(frames.map((frame) => frame.version));
    if (newest > this.bodies.version) await this.fetch_bodies();
  }

  async fetch_bodies() {
    this.bodies.update(await ask_json("bodies", { log: this.log }));
    this.on_bodies?.();
  }

  async frame_soon(step) {
    if (!this.cache.has(step)) await this.fetch(step, 1, 1);
    return this.frame(step);
  }

  /// Asks for the steps that playing will need next.
  prefetch(step, stride) {
    const whole = Math.max(1, Math.round(Math.abs(stride))) * Math.sign(stride);
    let first = step + whole;
    for (let k = 0; k < kBatch / 2 && this.cache.has(first); ++k) first += whole;
    if (this.asked.size > 1) return;
    const low = whole > 0 ? first : Math.max(this.head.first, first + (kBatch - 1) * whole);
    if (low > this.head.last || low < this.head.first || this.asked.has(low)) return;
    this.asked.add(low);
    this.fetch(low, kBatch, Math.abs(whole)).catch(() => {}).finally(() => this.asked.delete(low));
  }

  async contacts_at(step) {
    if (!this.contact_cache.has(step)) {
      if (this.contact_cache.size > 64) this.contact_cache.clear();
      this.contact_cache.set(step, await ask_json("contacts", { log: this.log, step }));
    }
    return this.contact_cache.get(step);
  }

  /// The values of a body in every step: {id, step, x, y, z, speed, spin, asleep}, null where it is not there. Read in
  /// turn; told(history) after each part, which says whether to go on.
  async history(id, told) {
    this.histories ??= new Map();
    const history = this.histories.get(id) ?? { id, next: this.head.first, step: [], x: [], y: [], z: [], speed: [], spin: [], asleep: [] };
    if (this.histories.size > 16) this.histories.clear();
    this.histories.set(id, history);
    while (history.next <= this.head.last) {
      const from = history.next;
      const more = await ask_json("history", { log: this.log, id, from });
      if (more.why_not) throw new Error(more.why_not);
      if (history.next !== from) continue;  // another question has read on
      for (const name of ["step", "x", "y", "z", "speed", "spin", "asleep"]) add_values(history[name], more[name]);
      history.next = more.next;
      history.rows = undefined;
      if (more.next === from || !told(history)) break;
    }
    return history;
  }

  /// The values of a channel of one body (b: 0) or pair in every step: {step, value}. channel: its index in the head's.
  /// Read in turn; told(history) as above.
  async channel_history(channel, a, b, told) {
    this.channel_histories ??= new Map();
    const key = `${channel} ${a} ${b}`;
    const history = this.channel_histories.get(key) ?? { next: this.head.first, step: [], value: [] };
    if (this.channel_histories.size > 16) this.channel_histories.clear();
    this.channel_histories.set(key, history);
    while (history.next <= this.head.last) {
      const from = history.next;
      const more = await ask_json("channel", { log: this.log, channel, a, b, from });
      if (more.why_not) throw new Error(more.why_not);
      if (history.next !== from) continue;  // another question has read on
      for (const name of ["step", "value"]) add_values(history[name], more[name]);
      history.next = more.next;
      if (more.next === from || !told(history)) break;
    }
    return history;
  }

  way(id) { return ask_json("way", { log: this.log, id }); }
  body_at(step, id) { return ask_json("body", { log: this.log, step, id }); }

  /// blame_json() of a value, or {why_not}.
  blame(step, id, field, back) { return ask_json("blame", { log: this.log, step, id, field, back }); }

  /// Takes what the server has read since. Returns whether there was anything.
  async take_news() {
    const news = await ask_json("news", { log: this.log });
    const grown = news.last > this.head.last || news.finished !== this.head.finished;
    if (grown) this.head = await ask_json("head", { log: this.log });
    if (news.version > this.bodies.version) await this.fetch_bodies();
    let fresh = grown;
    while (this.rows.count < news.rows) {
      const more = await ask_json("timeline", { log: this.log, from: this.rows.count });
      if (more.step.length === 0) break;
      this.rows.append(more);
      add_values(this.rows.events, more.more_inputs);
      fresh = true;
      if (more.step.length < 4000) break;
    }
    while (this.rows.begun.length < Math.min(news.begun, this.rows.count)) {
      const more = await ask_json("begun", { log: this.log, from: this.rows.begun.length });
      if (more.length === 0) break;
      add_values(this.rows.begun, more);
      fresh = true;
    }
    for (const name of ["note", "unread"]) {
      if (news[name] !== this[name]) fresh = true;
      this[name] = news[name];
    }
    if (news.contacts_why_not !== this.rows.begun_why_not) fresh = true;
    this.rows.begun_why_not = news.contacts_why_not;
    this.timeline_done = news.timeline_done;
    this.busy = !news.timeline_done || !news.contacts_done;
    return fresh;
  }
}

/// Resolves to {sessions, difference: null, follow()}. follow(changed): calls changed({grown, difference}) whenever the
/// server has more to show, for as long as the page is open.
export async function open_served(head) {
  const sessions = await Promise.all(head.logs.map(async (log, i) =>
    new ServedSession(i, log, await ask_json("bodies", { log: i }))));
  const follow = (changed, failed) => {
    let difference = null;
    let compared = sessions.length < 2;
    const round = async () => {
      let fresh = false;
      try {
        for (const session of sessions) fresh = await session.take_news() || fresh;
        if (!compared) {
          difference = await ask_json("difference");
          compared = difference.state !== "working";
          fresh = true;
        }
        failed(null);
      } catch (error) {
        failed(error);
      }
      if (fresh) changed(difference);
      const growing = sessions.some((session) => !session.head.finished);
      const busy = !compared || sessions.some((session) => !session.timeline_done || session.busy);
      if (growing || busy) setTimeout(round, busy && !growing ? kBusyPollMs : kPollMs);
    };
    round();
  };
  return { sessions, difference: null, served: true, follow };
}
