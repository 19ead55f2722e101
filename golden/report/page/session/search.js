// Search: a body by its id or name, or steps by a condition on a number: "speed > 5", "overlap > 1e-3", or on one of a
// body: "speed of 12 > 5", "height of wheel < 0.3".

import { by_name } from "../theme.js";

// What a condition may be about: its value in row i of the timeline, and its unit.
export const kQuantities = by_name({
  speed: { of: (rows, i) => rows.speed[i], unit: "m/s", body: (rows, i) => rows.speed_body[i] },
  overlap: { of: (rows, i) => rows.overlap[i], unit: "m" },
  height: { of: (rows, i) => rows.height[i], unit: "m" },
  kinetic: { of: (rows, i) => rows.kinetic[i], unit: "J" },
  potential: { of: (rows, i) => rows.potential[i], unit: "J" },
  energy: { of: (rows, i) => rows.energy(i), unit: "J" },
  contacts: { of: (rows, i) => rows.contacts[i], unit: "" },
  begun: { of: (rows, i) => rows.begun[i] ?? null, unit: "" },
  sleeping: { of: (rows, i) => rows.sleeping[i], unit: "" },
  bodies: { of: (rows, i) => rows.bodies[i], unit: "" },
  lost: { of: (rows, i) => rows.lost[i], unit: "" },
  broken: { of: (rows, i) => (rows.bounds.length > 0 ? rows.broken(i) : null), unit: "" },
  separation: { of: (rows, i, separation) => separation?.(rows.step[i]) ?? null, unit: "m" },
});

/// What a condition on one body may be about: its value in row i of the body's history; other: that of the second
/// session, where there is one.
export const kBodyQuantities = by_name({
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

/// Reads a query: {kind: "body", text}, {kind: "steps", quantity, comparison, bound}, {kind: "body steps", quantity,
/// body, comparison, bound}, likewise {kind: "channel steps", …} of a channel, {kind: "step", step} or {kind: "wrong", words}. channels: names of further columns.
export function parse_query(text, channels = []) {
  const trimmed = text.trim();
  if (trimmed === "") return { kind: "none" };
  const step = /^step\s+(\d+)$/i.exec(trimmed);
  if (step) return { kind: "step", step: Number(step[1]) };
  const found = /^(.+?)\s*(<=|>=|==|[<>=≥≤])\s*(.*)$/.exec(trimmed);
  if (!found) return { kind: "body", text: trimmed };
  const name = found[1].trim();
  const quantity = name.toLowerCase();
  const number = found[3].replace(/\s*(m\/s|rad\/s|m|J)\s*$/, "");
  const bound = Number(number);
  const comparison = kWords[found[2]] ?? found[2];
  const no_number = number === "" || !Number.isFinite(bound) ? { kind: "wrong", words: `"${found[3]}" is no number` } : null;
  const of = channels.includes(name) ? null : /^(.+?)\s+of\s+(.+)$/i.exec(name);
  if (of) {
    const part = of[1].toLowerCase();
    if (!(part in kBodyQuantities) && channels.includes(of[1])) {
      return no_number ?? { kind: "channel steps", quantity: of[1], body: of[2], comparison, bound };
    }
    if (!(part in kBodyQuantities)) {
      const known = [...Object.keys(kBodyQuantities), ...channels].join(", ");
      return { kind: "wrong", words: `"${of[1]}" is no quantity of a body; there are ${known}` };
    }
    return no_number ?? { kind: "body steps", quantity: part, body: of[2], comparison, bound };
  }
  if (!(quantity in kQuantities) && !channels.includes(name)) {
    const known = [...Object.keys(kQuantities), ...channels].join(", ");
    return { kind: "wrong", words: `"${name}" is no quantity; there are ${known}` };
  }
  return no_number ?? { kind: "steps", quantity: quantity in kQuantities ? quantity : name, comparison, bound };
}

/// {runs, judged}: runs of steps in which a condition holds, [{first, last, peak, at, body}], peak being the value
/// furthest from the bound and `at` its step; judged: how many steps have a value.
export function find_runs(query, rows, separation) {
  const { of, body } = kQuantities[query.quantity] ?? { of: (_, i) => rows.channels[query.quantity]?.[i] ?? null };
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
