// Search: a body by its id or name, or steps by a condition on a number: "speed > 5", "overlap > 1e-3".

// What a condition may be about: its value in row i of the timeline, and its unit.
export const kQuantities = {
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
};

const kComparisons = {
  "<": (a, b) => a < b, "<=": (a, b) => a <= b, ">": (a, b) => a > b, ">=": (a, b) => a >= b, "=": (a, b) => a === b,
};
const kWords = { "≥": ">=", "≤": "<=", "==": "=" };

/// Reads a query: {kind: "body", text}, {kind: "steps", quantity, comparison, bound}, {kind: "step", step} or
/// {kind: "wrong", words}. channels: names of further columns.
export function parse_query(text, channels = []) {
  const trimmed = text.trim();
  if (trimmed === "") return { kind: "none" };
  const step = /^step\s+(\d+)$/i.exec(trimmed);
  if (step) return { kind: "step", step: Number(step[1]) };
  const found = /^(.+?)\s*(<=|>=|==|[<>=≥≤])\s*(.*)$/.exec(trimmed);
  if (!found) return { kind: "body", text: trimmed };
  const name = found[1].trim();
  const quantity = name.toLowerCase();
  if (!(quantity in kQuantities) && !channels.includes(name)) {
    const known = [...Object.keys(kQuantities), ...channels].join(", ");
    return { kind: "wrong", words: `"${name}" is no quantity; there are ${known}` };
  }
  const number = found[3].replace(/\s*(m\/s|m|J)\s*$/, "");
  const bound = Number(number);
  if (number === "" || !Number.isFinite(bound)) return { kind: "wrong", words: `"${found[3]}" is no number` };
  return { kind: "steps", quantity: quantity in kQuantities ? quantity : name,
    comparison: kWords[found[2]] ?? found[2], bound };
}

/// Runs of steps in which a condition holds: [{first, last, peak, at, body}], peak being the value furthest from the
/// bound and `at` its step.
export function find_runs(query, rows, separation) {
  const { of, body } = kQuantities[query.quantity] ?? { of: (_, i) => rows.channels[query.quantity]?.[i] ?? null };
  const holds = kComparisons[query.comparison];
  const runs = [];
  let open = null;
  for (let i = 0; i < rows.count; ++i) {
    const value = of(rows, i, separation);
    const good = value !== null && value !== undefined && holds(value, query.bound);
    if (!good) {
      open = null;
      continue;
    }
    if (!open) {
      open = { first: rows.step[i], last: rows.step[i], peak: value, at: rows.step[i], body: body?.(rows, i) ?? null };
      runs.push(open);
    }
    open.last = rows.step[i];
    if (Math.abs(value - query.bound) > Math.abs(open.peak - query.bound)) {
      Object.assign(open, { peak: value, at: rows.step[i], body: body?.(rows, i) ?? null });
    }
  }
  return runs;
}
