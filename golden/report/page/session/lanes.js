// The lanes of the timeline: what each shows, and how its value at a step reads.
import { joules, largest, metres } from "../theme.js";

const count = (value) => (value === null || value === undefined ? "–" : String(value));
const speed = (value) => (value === null || value === undefined ? "–" : `${Number(value.toPrecision(4))} m/s`);

const digits = (value, unit, count_of = 6) => (value === null ? "–" : !Number.isFinite(value) ? `${value < 0 ? "−" : ""}infinite`
  : `${Number(value.toPrecision(count_of))}${unit ? ` ${unit}` : ""}`);

const share_text = (rows, i) => (rows.read[i] ? `${rows.sleeping[i]} of ${rows.bodies[i]}` : "–");

/// kind: "line", "area", "bars"; of(rows, i): the number, or null. parts: a line ends where there is no number; without it,
/// only where the step was not read. Lanes without a number anywhere are left out.
const kLanes = [
  { name: "sleeping", kind: "area", of: (rows, i) => (rows.read[i] ? rows.sleeping[i] : null), words: share_text,
    top: (rows) => largest([1, ...sampled(rows.bodies)]) },
  { name: "contacts", kind: "line", of: (rows, i) => rows.contacts_told(i), words: (rows, i) => count(rows.contacts_told(i)), late: true },
  { name: "contacts begun", kind: "bars", of: (rows, i) => rows.begun[i] ?? null,
    words: (rows, i) => count(rows.begun[i]), late: true },
  { name: "energy", kind: "line", of: (rows, i) => rows.energy(i), words: (rows, i) => joules(rows.energy(i)), fit: true },
  { name: "kinetic energy", kind: "area", of: (rows, i) => rows.kinetic[i], words: (rows, i) => joules(rows.kinetic[i]) },
  { name: "highest speed", kind: "line", of: (rows, i) => rows.speed[i],
    words: (rows, i) => (rows.speed[i] > 0 ? `${speed(rows.speed[i])}, ${rows.label(rows.speed_body[i])}` : speed(rows.speed[i])) },
  { name: "deepest overlap", kind: "line", of: (rows, i) => rows.overlap[i], words: (rows, i) => metres(rows.overlap[i]) },
  { name: "bodies lost", kind: "bars", of: (rows, i) => rows.lost[i] || null, words: (rows, i) => count(rows.lost[i]),
    bad: true, only_if_any: true },
];

// What method thesis counts in a step; the panel has the contact points of its last substep.
const kCollisions = { name: "collisions resolved", title: "collisions resolved in all substeps of a step" };

/// The lanes of a session with this head.
export const session_lanes = (head) =>
  kLanes.map((lane) => (lane.name === "contacts" && head.counts_collisions ? { ...lane, ...kCollisions } : lane));

function sampled(column) {
  const stride = Math.ceil(column.length / 5000) || 1;
  return column.filter((value, i) => i % stride === 0 && value !== null);
}

/// Lanes for the bounds of the command line: the value of each metric of the session up to a step.
export const bound_lanes = (texts) => texts.map((text, b) => ({
  name: text, kind: "line", title: `up to each step, ${text}`, broken: (rows, i) => rows.bounds[b]?.broken[i] === 1,
  of: (rows, i) => rows.bounds[b]?.value[i] ?? null,
  words: (rows, i) => {
    const broken = rows.bounds[b]?.broken[i] ?? null;
    if (broken === null) return "not judged";
    const value = rows.bounds[b].value[i];
    return `${value === null ? "no value" : digits(value, "", 4)}, ${broken ? "✕ broken" : "✓ holds"}`;
  },
}));

/// Lanes for the channels that a log carries besides; of those of bodies and pairs, the largest value in each step.
export const channel_lanes = (rows) => rows.channel_heads.map(({ name, unit, of: whose }) => {
  const of = (all, i) => all.channels[name]?.[i] ?? null;
  const words = (all, i) => digits(of(all, i), unit);
  const most = whose === "step" ? "" : `, largest of ${whose}`;
  return { name: `${name}${most}`, kind: "line", fit: true, parts: true, title: `channel ${name}${most}`, of, words };
});

/// The lane of a channel of one body or pair. history: channel_history(), which grows.
export function owner_lane(name, unit, history) {
  const at = new Map();
  const of = (rows, i) => {
    while (at.size < history.step.length) at.set(history.step[at.size], history.value[at.size]);
    return at.get(rows.step[i]) ?? null;
  };
  const words = (rows, i) => digits(of(rows, i), unit);
  return { name, kind: "line", fit: true, parts: true, title: `channel ${name}`, of, words };
}

/// The lane of the distance between two sessions; logarithmic, since it grows by powers.
export function separation_lane(separation) {
  const at = new Map(separation.step.map((step, i) => [step, i]));
  return {
    name: "separation", kind: "line", log: true,
    of: (rows, i) => (at.has(rows.step[i]) ? separation.metres[at.get(rows.step[i])] : null),
    words: (rows, i) => {
      const k = at.get(rows.step[i]);
      return k === undefined ? "none" : separation.metres[k] === null ? "infinite" : metres(separation.metres[k]);
    },
  };
}
