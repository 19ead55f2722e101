// Search: a body by its id or name, or steps by a condition on a number: "speed > 5", "overlap > 1e-3", or on one of a
// body: "speed of 12 > 5", "height of wheel < 0.3".

import { by_name } from "../theme.js";

// What a condition may be about: its value in row i of the timeline, and its unit.
const kQuantities = by_name({
  speed: { of: (rows, i) => rows.speed[i], unit: "m/s", body: (rows, i) => rows.speed_body[i] },
  overlap: { of: (rows, i) => rows.overlap[i], unit: "m" },
  height: { of: (rows, i) => rows.height[i], unit: "m" },
  kinetic: { of: (rows, i) => rows.kinetic[i], unit: "J" },
  potential: { of: (rows, i) => rows.potential[i], unit: "J" },
  energy: { of: (rows, i) => rows.energy(i), unit: "J" },
  contacts: { of: (rows, i) => rows.contacts_told(i), unit: "" },
  begun: { of: (rows, i) => rows.begun[i] ?? null, unit: "" },
  sleeping: { of: (rows, i) => rows.sleeping[i], unit: "" },
  bodies: { of: (rows, i) => rows.bodies[i], unit: "" },
  lost: { of: (rows, i) => rows.lost[i], unit: "" },
  broken: { of: (rows, i) => (rows.bounds.length > 0 ? rows.broken(i) : null), unit: "" },
  separation: { of: (rows, i, separation) => separation?.(rows.step[i]) ?? null, unit: "m" },
});

/// What a condition on one body may be about: its value in row i of the body's history; other: that of the second
/// session, where there is one.
const kBodyQuantities = by_name({
  speed: { of: (one, i) => one.speed[i], unit: "m/s" },
  spin: { of: (one, i) => one.spin?.[i] ?? null, unit: "rad/s" },
  height: { of: (one, i) => one.z[i], unit: "m" },
  x: { of: (one, i) => one.x[i], unit: "m" },
  y: { of: (one, i) => one.y[i], unit: "m" },
  z: { of: (one, i) => one.z[i], unit: "m" },
  asleep: { of: (one, i) => one.asleep[i], unit: "" },
  separation: { of: (one, i, other) => apart(one, i, other), unit: "m" },
});

function apart(one, i, other) {
  if (!other) return null;
  other.rows ??= new Map(other.step.map((step, k) => [step, k]));
  const k = other.rows.get(one.step[i]);
  const parts = k === undefined ? [null] : ["x", "y", "z"].map((axis) => (one[axis][i] === null || other[axis][k] === null
    ? null : one[axis][i] - other[axis][k]));
  return parts.includes(null) ? null : Math.hypot(...parts);
}

const kComparisons = by_name({
  "<": (a, b) => a < b, "<=": (a, b) => a <= b, ">": (a, b) => a > b, ">=": (a, b) => a >= b, "=": (a, b) => a === b,
});
const kWords = by_name({ "≥": ">=", "≤": "<=", "==": "=" });

/// The number of a condition, with or without the unit of its quantity: {bound}, or {kind: "wrong", words}.
function bound_in(text, name, unit) {
  const found = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*)$/i.exec(text);
  const bound = Number(found?.[1]);
  if (!Number.isFinite(bound)) return { kind: "wrong", words: `"${text}" is no number` };
  if (found[2] === "" || found[2] === unit) return { bound };
  return { kind: "wrong", words: `"${found[2]}" is not the unit of ${name}, which ${unit ? `is in ${unit}` : "has none"}` };
}

/// The channel that "channel.NAME" asks for; null where the name is none of these. So one that is called as a quantity
/// of ours, "channel.speed > 5", can be asked for too.
function named_channel(name, units) {
  const channel = /^channel\.(.+)$/i.exec(name)?.[1];
  return channel !== undefined && !(name in units) && channel in units ? channel : null;
}

/// The names of the two bodies in "1 and 2". A name may hold " and " itself: the way to part them counts in which both
/// are names, is_body(name), of one body each.
export function pair_in(text, is_body) {
  const words = text.split(/(\s+and\s+)/i);
  const ways = [];
  for (let k = 1; k < words.length; k += 2) ways.push([words.slice(0, k).join(""), words.slice(k + 1).join("")]);
  return ways.find((names) => names.every(is_body)) ?? ways[0] ?? [text];
}

/// Reads a query: {kind: "body", text}, {kind: "steps", quantity, unit, comparison, bound}, {kind: "body steps",
/// quantity, unit, body, comparison, bound}, likewise {kind: "channel steps", …} of a channel, {kind: "step", step} or
/// {kind: "wrong", words}. channels: further columns, [{name, unit}].
export function parse_query(text, channels = []) {
  const units = by_name(Object.fromEntries(channels.map(({ name, unit }) => [name, unit])));
  const trimmed = text.trim();
  if (trimmed === "") return { kind: "none" };
  const step = /^step\s+([-+]?\d+)$/i.exec(trimmed);
  if (step) return { kind: "step", step: Number(step[1]) };
  const found = /^(.+?)\s*(<=|>=|==|[<>=≥≤])\s*(.*)$/.exec(trimmed);
  if (!found) return { kind: "body", text: trimmed };
  const name = found[1].trim();
  const quantity = name.toLowerCase();
  const comparison = kWords[found[2]] ?? found[2];
  const asked = (kind, part, unit, more = {}) => {
    const { bound, ...wrong } = bound_in(found[3], part, unit);
    return bound === undefined ? wrong : { kind, quantity: part, unit, comparison, bound, ...more };
  };
  const refused = (part, whose, tables) =>
    ({ kind: "wrong", words: `"${part}" is no quantity${whose}; there are ${tables.flatMap(Object.keys).join(", ")}` });
  const channel = named_channel(name, units);
  if (channel !== null) return asked("steps", channel, units[channel], { channel });
  const of = name in units ? null : /^(.+?)\s+of\s+(.+)$/i.exec(name);
  if (of) {
    const part = of[1].toLowerCase();
    const one = named_channel(of[1], units);
    if (one !== null) return asked("channel steps", one, units[one], { body: of[2] });
    if (part in kBodyQuantities) return asked("body steps", part, kBodyQuantities[part].unit, { body: of[2] });
    if (of[1] in units) return asked("channel steps", of[1], units[of[1]], { body: of[2] });
    return refused(of[1], " of a body", [kBodyQuantities, units]);
  }
  if (quantity in kQuantities) return asked("steps", quantity, kQuantities[quantity].unit);
  return name in units ? asked("steps", name, units[name]) : refused(name, "", [kQuantities, units]);
}

/// {runs, judged}: runs of steps in which a condition holds, [{first, last, peak, at, body}], peak being the value
/// furthest from the bound and `at` its step; judged: how many steps have a value.
export function find_runs(query, rows, separation) {
  const { of, body } = (query.channel === undefined ? kQuantities[query.quantity] : undefined) ?? { of: (_, i) => rows.channels[query.quantity]?.[i] ?? null };
  return runs_of(query, rows.step, (i) => of(rows, i, separation), (i) => body?.(rows, i) ?? null);
}

/// Likewise for one body. one, other: its histories in the two sessions; other may be null.
export function find_body_runs(query, one, other) {
  const { of } = kBodyQuantities[query.quantity];
  return runs_of(query, one.step, (i) => of(one, i, other), () => null);
}

/// Likewise for a channel of one body or pair. history: channel_history().
export function find_channel_runs(query, history) {
  return runs_of(query, history.step, (i) => history.value[i], () => null);
}

function runs_of(query, step, value_in, body_in) {
  const holds = kComparisons[query.comparison];
  const runs = [];
  let judged = 0;
  let open = null;
  for (let i = 0; i < step.length; ++i) {
    const value = value_in(i);
    const known = value !== null && value !== undefined;
    if (known) ++judged;
    const good = known && holds(value, query.bound);
    if (!good) {
      open = null;
      continue;
    }
    if (!open) {
      open = { first: step[i], last: step[i], peak: value, at: step[i], body: body_in(i) };
      runs.push(open);
    }
    open.last = step[i];
    if (Math.abs(value - query.bound) > Math.abs(open.peak - query.bound)) {
      Object.assign(open, { peak: value, at: step[i], body: body_in(i) });
    }
  }
  return { runs, judged };
}
