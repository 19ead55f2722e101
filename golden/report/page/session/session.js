// The page of `tumble view`: one session or two, scrubbed, played, searched and compared.
import { element, watch_theme } from "../theme.js";
import { make_player, Steps } from "../viewer/player.js";
import { Drawing, kLostMax } from "./drawing.js";
import { make_header } from "./header.js";
import { listen_keys } from "./keys.js";
import { bound_lanes, channel_lanes, separation_lane, session_lanes } from "./lanes.js";
import { Plots } from "./plots_chosen.js";
import { Side } from "./side.js";
import { make_search } from "./search_box.js";
import { open_sent } from "./sent.js";
import { open_served } from "./served.js";
import { make_timeline } from "./timeline.js";
import { colours } from "../theme.js";
import { make_toolbar } from "./toolbar.js";

const kSettleMs = 60;  // after the last move, before contacts and numbers are asked for

export class SessionPage {
  constructor(place, opened) {
    Object.assign(this, opened, { place, selected: null, hits: [], hit: -1, settle: null, asked: 0 });
    const [main] = this.sessions;
    for (const { rows, bodies } of this.sessions) rows.label = (id) => bodies.label(id);
    this.steps = new Steps(Math.min(...this.sessions.map(({ head }) => head.first)),
      Math.max(...this.sessions.map(({ head }) => head.last)), this.union_of_steps());
    this.player = make_player({ steps: this.steps, dt: () => main.head.dt, show: (step) => this.show(step),
      played: (direction) => this.said_playing(direction) });
    this.header = make_header(this);
    this.view = element("div", { className: "view3d" });
    this.said = element("output", { className: "said" });
    this.told = element("output", { className: "told", ariaLabel: "what has happened" });  // read aloud, not seen
    this.drawing = new Drawing(this.view, this.sessions, (id) => this.select(id));
    this.timeline = make_timeline({ rows: main.rows, range: () => this.steps, seek: (step) => this.player.seek(step),
      hues: colours, marks: () => this.marks() });
    this.plots = this.sessions[0].channel_history ? new Plots(this) : null;
    this.search = make_search(this);
    this.side = new Side(this);
    this.toolbar = make_toolbar(this);
    this.keys = listen_keys(this);
    place.replaceChildren(this.header.place, element("div", { className: "work" },
      element("section", { className: "shown", ariaLabel: "the state shown" }, this.toolbar.place, this.view, this.said, this.told,
        this.player.bar, this.timeline.place),
      element("aside", { ariaLabel: "search and numbers" }, this.search.place, ...this.side.places,
        this.keys.place)));
    this.set_lanes();
    this.side.show_inputs();
    this.side.show_selection();
    if (this.sessions.length === 2) this.side.show_difference();
  }

  union_of_steps() {
    if (!this.sessions.some((session) => session.steps)) return null;
    return [...new Set(this.sessions.flatMap((session) => session.steps))].sort((a, b) => a - b);
  }

  /// The step and the body that the page's address names; null where it names none.
  addressed() {
    const [step, body] = ["step", "body"].map((name) => new RegExp(`(?:^#|&)${name}=(\\d+)`).exec(location.hash));
    return { step: step && this.steps.at_or_before(Number(step[1])), body: Number(body?.[1] ?? 0) || null };  // ids begin at 1
  }

  go_to_address() {
    const { step, body } = this.addressed();
    if (step !== null) this.player.seek(step);
    if (body !== null) this.select(body);
  }

  async start() {
    const { step: from, body } = this.addressed();
    const step = from ?? this.steps.first;
    this.drawing.frames = await Promise.all(this.sessions.map((session) => session.frame_soon(step).catch(() => null)));
    this.drawing.start();
    this.player.seek(step);
    this.player.refresh();
    if (body !== null) this.select(body);
    addEventListener("hashchange", () => this.go_to_address());
    for (const session of this.sessions) session.on_bodies = () => { this.drawing.describe(); this.refresh(); };
    new ResizeObserver(() => this.drawing.resize()).observe(this.view);
    watch_theme(() => {
      this.drawing.restart();
      this.timeline.draw();
    });
    this.follow((difference) => this.changed(difference), (error) => this.header.trouble(error));
    this.place.dataset.ready = "true";
  }

  marks() {
    const [{ rows }] = this.sessions;
    return { gaps: this.sessions.flatMap((session) => session.gaps()), inputs: rows.events, hits: this.hits,
      first_difference: this.difference?.first?.step ?? null,
      first_effect: this.difference?.effect?.step ?? null };
  }

  set_lanes() {
    const { head, rows } = this.sessions[0];
    const lanes = [...(this.plots?.lanes() ?? []), ...bound_lanes(this.bounds), ...session_lanes(head), ...channel_lanes(rows)];
    if (this.difference?.separation) lanes.unshift(separation_lane(this.difference.separation));
    this.timeline.set_lanes(lanes);
    this.timeline.draw();
  }

  separation_at(step) {
    const found = this.difference?.separation;
    if (!found) return null;
    this.separations ??= new Map(found.step.map((one, i) => [one, found.metres[i] ?? Infinity]));
    return this.separations.get(step) ?? null;
  }

  /// The server has more.
  changed(difference) {
    const { head } = this.sessions[0];
    const last = Math.max(...this.sessions.map((session) => session.head.last));
    if (difference && difference !== this.difference) {
      const had = Boolean(this.difference?.separation);
      this.difference = difference;
      this.side.show_difference();
      if (!had && difference.separation) this.set_lanes();
    }
    if (last !== this.steps.last && this.player.set_last(last) && !head.finished) this.player.seek(last);
    this.header.show();
    this.side.show_inputs();
    this.search.again();
    this.plots?.again();
    this.timeline.draw();
  }

  /// Shows a step as soon as its states are there; later calls overtake earlier ones.
  show(step) {
    this.timeline.show(step);
    const mine = ++this.asked;
    const frames = this.sessions.map((session) => session.frame(session.steps ? this.own_step(session, step) : step));
    if (this.player.direction !== 0) {
      for (const session of this.sessions) session.prefetch(step, this.player.direction * this.player.stride);
    }
    if (frames.every((frame) => frame !== null)) this.show_frames(step, frames);
    else this.fetch_frames(step, mine);
    clearTimeout(this.settle);
    this.settle = setTimeout(() => this.settled(step), kSettleMs);
  }

  own_step(session, step) {
    return new Steps(session.head.first, session.head.last, session.steps).at_or_before(step);
  }

  async fetch_frames(step, mine) {
    if (this.fetching) {  // one question at a time; the last one wins
      this.wanted = [step, mine];
      return;
    }
    this.fetching = true;
    try {
      const began = performance.now();
      const frames = await Promise.all(this.sessions.map((session) => (step < session.head.first || step > session.head.last
        ? null : session.frame_soon(session.steps ? this.own_step(session, step) : step))));
      this.seek_ms = performance.now() - began;
      if (mine === this.asked || this.player.direction !== 0) this.show_frames(step, frames);
      this.header.trouble(null);
    } catch (error) {
      this.header.trouble(error);
    }
    this.fetching = false;
    const { wanted } = this;
    this.wanted = null;
    if (wanted) this.fetch_frames(...wanted);
  }

  show_frames(step, frames) {
    this.drawing.frames = frames;
    this.drawing.show();
    this.shown = step;
    const words = this.words(step, frames);
    this.said.value = words;
    this.player.slider.setAttribute("aria-valuetext", words);
    const gap = frames[0] && frames[0].status !== 0 ? this.sessions[0].gap_at(step) : null;
    const beyond = frames.every((frame) => frame === null || frame.status !== 0);
    this.drawing.over.hidden = !beyond;
    this.drawing.over.textContent = !beyond ? "" : gap ? `Step ${step} is not here: ${gap[2]}.`
      : `The state of step ${step} cannot be read.`;
  }

  words(step, frames) {
    const [session] = this.sessions;
    const [frame] = frames;
    const parts = [`step ${step}`, `${session.time_of(step).toFixed(3)} s`];
    if (frame && frame.status === 0) {
      const count = [0, 0, 0, 0];
      for (const mark of frame.mark) ++count[mark];
      const all = count[1] + count[2] + count[3];
      parts.push(`${all} bod${all === 1 ? "y" : "ies"}, ${count[2]} asleep`);
      if (count[3] > 0) {
        const row = frame.mark.indexOf(3);
        parts.push(`${session.bodies.label(session.bodies.id(row))}${count[3] > 1 ? ` and ${count[3] - 1} more` : ""} lost: no numbers${count[3] > kLostMax ? `, ${kLostMax} of them marked` : ""}`);
      }
      if (frame.step !== step) parts.push(`A shows step ${frame.step}`);
    } else if (session.gap_at(step)) {
      parts.push(session.gap_at(step)[2]);
    }
    parts.push(...this.drawing.ways_words());
    if (this.sessions.length === 2) {
      const first = this.difference?.first?.step;
      const apart = this.separation_at(step);
      if (first !== undefined && step < first) parts.push("the same in both");
      else if (apart !== null) parts.push(apart === Infinity ? "infinitely far apart" : `at most ${apart.toPrecision(3)} m apart`);
      parts.push(...this.drawing.only_in_words());
    }
    return parts.join(" · ");
  }

  /// Once the step stays: contacts and the numbers of the body chosen.
  async settled(step) {
    const hash = `#step=${step}${this.selected === null ? "" : `&body=${this.selected}`}`;
    try {
      history.replaceState(null, "", hash);
    } catch { /* a page in a frame may not */ }
    if (this.player.direction !== 0 && this.served) return;
    await this.side.settled(step).catch((error) => this.header.trouble(error));
  }

  refresh() { this.player.refresh(); }

  /// Has a screen reader say what changed elsewhere on the page.
  tell(words) { if (words && this.told.value !== words) this.told.value = words; }

  /// Thirty states a second are not read aloud; the one where playing ends is.
  said_playing(direction) {
    this.said.setAttribute("aria-live", direction === 0 ? "polite" : "off");
    this.tell(direction === 0 ? `stopped at ${this.said.value}` : direction > 0 ? "playing" : "playing backwards");
  }

  select(id) {
    if (id !== this.selected) this.tell(id === null ? "no body is chosen" : `${this.side.label(id)} is chosen`);
    this.selected = id;
    this.drawing.selected = id;
    if (id === null) this.drawing.following = false;
    this.toolbar.show();
    this.drawing.show();
    this.drawing.show_ways().catch((error) => this.header.trouble(error));
    this.side.show_selection();
    this.side.draw_contacts();
    this.settled(this.player.step);
  }

  go_to_first_difference() {
    const step = this.difference?.first?.step;
    if (step !== undefined) this.player.seek(step);
  }

  go_to_first_effect() {
    const step = this.difference?.effect?.step;
    if (step !== undefined) this.player.seek(step);
  }

  set_hits(runs) {
    this.hits = runs;
    this.hit = -1;
    this.timeline.draw();
  }

  next_hit(way) {
    if (this.hits.length === 0) return;
    this.hit = (this.hit + way + this.hits.length) % this.hits.length;
    const run = this.hits[this.hit];
    this.player.seek(way > 0 || this.steps.list === null ? run.first : run.at);
    this.search.at(this.hit);
  }
}

/// Draws the page into its place, or says why it cannot.
export async function open_session(place) {
  try {
    const head = JSON.parse(document.getElementById("session-head").textContent);
    const opened = await (head.mode === "sent" ? open_sent : open_served)(head);
    await new SessionPage(place, { ...opened, bounds: head.bounds ?? [] }).start();
  } catch (error) {
    place.append(element("p", { className: "bad", textContent: `This cannot be drawn: ${error.message}` }));
    throw error;
  }
}
