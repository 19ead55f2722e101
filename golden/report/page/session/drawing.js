// The view of the session page: the bodies of one session or two in the state shown, with contacts and ways.
import { colours, element } from "../theme.js";
import { kAbsent, kFrozen, kNotFinite } from "../viewer/bodies.js";
import { box_around, listen } from "../viewer/pointer.js";
import { make_stage } from "../viewer/stage.js";

const kApart_m = 0.0005;   // nearer than this a ghost would only hide what it haunts
const kWaysMax = 24;
export const kLostMax = 50;
const kLook = { crate: "#c99a5b", brick: "#b8573f", wood: "#b58550", concrete: "#98a2ad", white: "#dfe4e8" };

/// Blue, over green, to red: 0 … 1.
const heat = (share, tone) => tone.setHSL(0.62 * (1 - Math.min(1, Math.max(0, share))), 0.75, 0.5);

export class Drawing {
  /// picked(id): a body was pressed, or null for none.
  constructor(place, sessions, picked) {
    Object.assign(this, { place, sessions, picked, frames: [null, null], selected: null, paint: "material",
      contacts: [null, null], with_contacts: false, with_ways: false, side_by_side: false, following: false, ways: new Map(),
      lost_places: new Map(), ways_said: [], top_speed: 1, focus: null });
    this.open();
  }

  open() {
    const canvas = element("canvas", { tabIndex: 0 });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The bodies in three dimensions. Arrow keys turn the view, with Shift they move it, + and - zoom.");
    this.canvas = canvas;
    this.tags = this.sessions.map((_, i) => element("span", { className: "tag", hidden: this.sessions.length < 2,
      textContent: i === 0 ? "A" : "B, ghost" }));
    this.over = element("p", { className: "over-view", hidden: true });
    this.place.replaceChildren(canvas, ...this.tags, this.over);
    this.stage = null;
  }

  /// Needs the first frame of each session, for the size of the scene.
  start() {
    this.hue = colours();
    const first = this.frames.find((frame) => frame && frame.rows > 0);
    const known = (axis) => (first ? Array.from(first[axis]).filter((_, row) => first.mark[row] !== kAbsent) : []);
    const table = this.sessions[0].bodies;
    let size = 0.1;
    for (let row = 0; row < table.count; ++row) if (!table.is_static(row)) size = Math.max(size, ...table.size(row));
    const { camera, ground } = this.sessions[0].head;
    this.box = box_around(["x", "y", "z"].map(known), size, ground ?? true);
    try {
      this.stage = make_stage(this.canvas, { hue: this.hue, box: this.box, camera, ground });
    } catch {
      this.place.textContent = "This browser has no WebGL, so there is no view; timeline, search and numbers work.";
      return;
    }
    this.bodies = this.sessions.map((session, i) => {
      const made = this.stage.add_session(i === 0 ? "solid" : "ghost", i === 0 ? this.hue.actual : this.hue.expected);
      made.describe(session.bodies);
      return made;
    });
    listen(this.canvas, this.stage, (x, y) => {
      const hit = this.stage.pick(x, y);
      this.picked(hit ? this.sessions[hit.session].bodies.id(hit.row) : null);
    });
    this.set_side_by_side(this.side_by_side);
    this.resize();
  }

  describe() {
    this.sessions.forEach((session, i) => this.bodies?.[i].describe(session.bodies));
  }

  restart() {
    if (!this.stage) return;
    const view = { ...this.stage.view };
    this.stage.dispose();
    this.open();
    this.start();
    if (this.stage) Object.assign(this.stage.view, view);
    this.show();
  }

  reset_view() {
    const { stage } = this;
    if (!stage) return;
    stage.dispose();
    this.open();
    this.following = false;
    this.start();
    this.show();
  }

  set_side_by_side(on) {
    this.side_by_side = on;
    this.place.classList.toggle("halves", on);
    if (this.tags[1]) this.tags[1].textContent = on ? "B" : "B, ghost";
    this.stage?.set_side_by_side(on);
    this.show();
  }

  /// Where a body is in session s; null where it is not.
  place_of(s, id) {
    const frame = this.frames[s];
    const row = this.sessions[s]?.bodies.row(id);
    if (!frame || row === undefined || row >= frame.rows) return null;
    if (frame.mark[row] === kAbsent || frame.mark[row] === kNotFinite) return null;
    return [frame.x[row], frame.y[row], frame.z[row]];
  }

  /// How far apart the two sessions have a body, m; null where one of them has it nowhere.
  apart(id) {
    const [a, b] = [this.place_of(0, id), this.place_of(1, id)];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) : null;
  }

  /// The ids of bodies that session s has in the state shown and the other one has not; none where the two show other steps.
  only_in(s) {
    const [one, other] = [this.frames[s], this.frames[1 - s]];
    if (!one || !other || one.status !== 0 || other.status !== 0 || one.step !== other.step) return new Set();
    const { bodies } = this.sessions[1 - s];
    const is_there = (id) => {
      const row = bodies.row(id);
      return row !== undefined && row < other.rows && other.mark[row] !== kAbsent;
    };
    const ids = this.sessions[s].bodies.json.id.filter((id, row) => row < one.rows && one.mark[row] !== kAbsent && !is_there(id));
    return new Set(ids);
  }

  /// "1 body only in A", "2 bodies only in B".
  only_in_words() {
    return ["A", "B"].flatMap((side, s) => {
      const count = this.only_in(s).size;
      return count === 0 ? [] : [`${count} bod${count === 1 ? "y" : "ies"} only in ${side}`];
    });
  }

  colour_of(session, frame) {
    const { bodies } = session;
    const alone = this.only_in(this.sessions.indexOf(session));
    return (row, tone) => {
      const id = bodies.id(row);
      if (id === this.selected) return tone.set(this.hue.select);
      if (alone.has(id)) return tone.set(this.hue.bad);
      if (this.paint === "speed") return heat(frame.speed[row] / this.top_speed, tone);
      if (this.paint === "apart") return heat(Math.log10(Math.max(1e-9, this.apart(id) ?? 0) / 1e-9) / 9, tone);
      const asleep = frame.mark[row] === kFrozen;
      if (this.paint === "state") {
        tone.set(bodies.is_static(row) ? this.hue.soft : asleep ? this.hue.asleep : this.hue.actual);
      } else {
        tone.set(kLook[bodies.texture(row)] ?? this.hue.actual);
        if (asleep) tone.offsetHSL(0, -0.12, -0.05);
      }
      return tone.offsetHSL(0, 0, 0.022 * (row % 5 - 2));
    };
  }

  lost_in(session, frame) {
    const lost = [];
    for (let row = 0; row < frame.rows && lost.length < kLostMax; ++row) {
      if (frame.mark[row] !== kNotFinite) continue;
      const id = session.bodies.id(row);
      const key = `${this.sessions.indexOf(session)} ${id}`;
      if (!this.lost_places.has(key)) {
        this.lost_places.set(key, null);
        session.way(id).then((way) => {
          let at = null;
          way.step.forEach((step, i) => {
            const place = way.at.slice(3 * i, 3 * i + 3);
            if (!place.includes(null) && (at === null || step <= frame.step)) at = place;
          });
          this.lost_places.set(key, at);
          this.show();
        }).catch(() => {});
      }
      const at = this.lost_places.get(key);
      if (at) lost.push({ at, size: Math.max(0.2, ...session.bodies.size(row)) });
    }
    return lost;
  }

  /// Draws the frames that are set.
  show() {
    if (!this.stage) return;
    this.sessions.forEach((session, i) => {
      const frame = this.frames[i];
      const shown = frame && frame.status === 0 ? frame : null;
      const paint = shown ? { colour: this.colour_of(session, shown), lost: this.lost_in(session, shown) } : {};
      if (shown && i === 1 && !this.side_by_side) {
        const alone = this.only_in(1);
        paint.colour = (row, tone) => {
          const id = session.bodies.id(row);
          return (id === this.selected || alone.has(id)) && tone.set(id === this.selected ? this.hue.select : this.hue.bad);
        };
        paint.hidden = (row) => (this.apart(session.bodies.id(row)) ?? 1) < kApart_m;
      }
      this.bodies[i].show(shown, paint);
    });
    const links = [];
    if (this.sessions.length === 2 && !this.side_by_side) {
      for (const id of this.sessions[0].bodies.json.id) {
        if ((this.apart(id) ?? 0) >= kApart_m) links.push(...this.place_of(0, id), ...this.place_of(1, id));
      }
    }
    this.stage.set_lines("links", { points: links, colour: this.hue.bad, on_top: true });
    this.show_contacts();
    const at = this.following && this.selected !== null ? this.place_of(0, this.selected) ?? this.place_of(1, this.selected) : null;
    if (at) this.stage.look_at(at);
    this.stage.draw();
  }

  /// Of the body chosen, or of all.
  show_contacts() { this.sessions.forEach((_, s) => this.show_contacts_of(s)); }

  show_contacts_of(s) {
    const found = this.contacts[s];
    const fits = found && this.frames[s] && found.step === this.frames[s].step;
    const rows = fits ? found.rows ?? [] : [];
    const mine = ([a, b]) => a === this.selected || b === this.selected;
    const chosen = this.selected !== null ? rows.filter(mine) : this.with_contacts ? rows : [];
    const drawn = chosen.filter((row) => row[9] > 0 && !row.includes(null));
    this.stage.set_arrows(drawn.map((row) => {
      // The arrow shows the push on the upper of the two; of the ground it points up.
      const up = row[7] < 0 ? -1 : 1;
      return { at: row.slice(2, 5), normal: row.slice(5, 8).map((part) => up * part), impulse: row[9] };
    }), s);
  }

  /// The bodies whose ways are shown: the selected one, else those thrown in, else some of all. said: of how many, where
  /// there are more.
  ways_chosen() {
    if (this.selected !== null) return { ids: [this.selected], said: [] };
    const { bodies } = this.sessions[0];
    const free = [...bodies.json.id.keys()].filter((row) => !bodies.is_static(row));
    const thrown = free.filter((row) => bodies.name(row) === "thrown");
    const all = thrown.length > 0 ? thrown : free;
    const stride = thrown.length > 0 ? 1 : Math.max(1, Math.ceil(free.length / kWaysMax));
    const ids = all.filter((_, i) => i % stride === 0).slice(0, kWaysMax).map((row) => bodies.id(row));
    return { ids, said: ids.length < all.length ? [`ways of ${ids.length} of ${all.length} bodies${thrown.length > 0 ? " thrown in" : ""}`] : [] };
  }

  /// What the view leaves out of the ways that it shows.
  ways_words() { return this.with_ways ? this.ways_said : []; }

  async show_ways() {
    if (!this.stage) return;
    const { ids, said } = this.with_ways || this.selected !== null ? this.ways_chosen() : { ids: [], said: [] };
    this.ways_said = said;
    const made = await Promise.all(this.sessions.map(async (session) => {
      const points = [];
      for (const id of ids) {
        if (session.bodies.row(id) === undefined) continue;
        const way = await session.way(id);
        for (let i = 1; i < way.step.length; ++i) {
          const part = way.at.slice(3 * i - 3, 3 * i + 3);
          if (!part.includes(null)) points.push(...part);
        }
      }
      return points;
    }));
    if (!this.stage) return;
    this.stage.set_lines("ways A", { points: made[0], colour: this.hue.way, opacity: 0.9 });
    this.stage.set_lines("ways B", made[1] ? { points: made[1], colour: this.hue.expected, dash: this.box.radius / 40, session: 1 } : null);
  }

  resize() {
    const { clientWidth, clientHeight } = this.place;
    if (clientWidth > 0) this.stage?.resize(clientWidth, clientHeight);
  }
}
