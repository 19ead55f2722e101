// The panels beside the view: the body chosen, the contacts of the state shown, the comparison of two sessions.
import { element, metres } from "../theme.js";

const kContactsShown = 12;

export const say = (value) => (typeof value === "number" ? String(value) : String(value ?? "–"));

const cell = (words, className = "") => element("td", { textContent: words, className });
const row_of = (...cells) => element("tr", {}, ...cells);

/// said: what a screen reader says instead of the words, where they are a bare number.
export function link(words, action, title = "", said = null) {
  const made = element("button", { type: "button", className: "link", textContent: words, title });
  if (said !== null) made.setAttribute("aria-label", said);
  made.addEventListener("click", action);
  return made;
}

/// A panel that folds: {place, body, hide(on)}.
export function panel(title, { open = true, id = "" } = {}) {
  const body = element("div", { className: "inside" });
  const place = element("details", { open, className: "panel", id }, element("summary", {}, element("h2", { textContent: title })), body);
  return { place, body };
}

/// The channels of a body and of its pairs, each with a button that draws it in the timeline. plots: as page.plots.
function channel_table(channels, id, bodies, plots) {
  const buttons = [];  // each says whether it is pressed; a further plot may take the oldest away
  const rows = channels.map(({ field, value, channel, with: other }) => {
    const name = other === null ? field : `${field} with ${bodies.label(other)}`;
    const plot = cell("", "number");
    if (channel !== null && plots) {
      const made = element("button", { type: "button", className: "link", textContent: "plot" });
      const show = () => made.setAttribute("aria-pressed", String(plots.has(channel, id, other ?? 0)));
      made.setAttribute("aria-label", `plot ${name} in the timeline`);
      made.addEventListener("click", () => {
        plots.flip(channel, id, other ?? 0);
        for (const again of buttons) again();
      });
      buttons.push(show);
      show();
      plot.append(made);
    }
    return row_of(element("th", { scope: "row", textContent: name }), cell(value, "number"), plot);
  });
  return element("div", { className: "scroll" }, element("table", { className: "numbers" },
    element("caption", { textContent: "Channels" }), element("tbody", {}, ...rows)));
}

/// answers: one of body_at() a session. asked(field): null, or what is called when a value is pressed.
export function show_body(body, { id, label, name, shape, answers, actions, bodies, plots = null, asked = null }) {
  const two = answers.length === 2;
  const lost = answers.find((answer) => answer.why_not);
  const table = element("table", { className: "numbers", ariaLabel: `values of ${label}` });
  table.append(element("thead", {}, row_of(element("th", { scope: "col", textContent: "field", colSpan: two ? 2 : 1 }),
    element("th", { scope: "col", textContent: "value", className: "number" }))));
  const first = answers.find((answer) => answer.fields);
  for (const [i, { field }] of (first?.fields ?? []).entries()) {
    const values = answers.map((answer) => answer.fields?.[i]);
    const bits = values.map((value) => value?.hex ?? String(value?.value));
    const rows = values.map((value, s) => {
      const shown = cell("", "number");
      if (value && asked) {
        shown.append(link(say(value.value), () => asked(field), `${value.hex ?? ""} – where does it come from?`,
          `${field} ${say(value.value)}: where does it come from?`));
      }
      else shown.textContent = say(value?.value);
      if (value?.hex) shown.title = value.hex;
      // Two values stand one below the other, digit below digit: side by side they leave no room for the field.
      const heads = s > 0 ? [] : [element("th", { scope: two ? "rowgroup" : "row", rowSpan: answers.length, textContent: field })];
      if (two) heads.push(element("th", { scope: "row", textContent: "AB"[s] }));
      const made = row_of(...heads, shown);
      made.classList.toggle("differs", bits.length === 2 && bits[0] !== bits[1]);
      return made;
    });
    table.append(element("tbody", { className: two ? "pair" : "" }, ...rows));
  }
  const facts = [...(label.includes(name) || shape.startsWith(name) ? [] : [name]), shape];
  if (first) facts.push(first.frozen ? "asleep" : "awake");
  const sides = answers.filter((answer) => answer.fields).length === 1 && two;
  if (sides && answers.some(({ absent }) => absent)) facts.push(`only in ${first === answers[0] ? "A" : "B"}`);
  body.replaceChildren(element("p", {}, element("strong", { textContent: label.replace(/^body /, "Body ") }), ` ${facts.join(" · ")}`), actions);
  if (first) body.append(element("div", { className: "scroll" }, table));
  if (first?.channels?.length > 0) {
    body.append(channel_table(first.channels, id, bodies, plots));
    const listed = first.channels.filter(({ with: other }) => other !== null).length;
    if (first.pairs > listed) {
      body.append(element("p", { className: "soft", textContent: `${listed} of ${first.pairs} values of pairs are listed; tumble dump has all of them.` }));
    }
  }
  if (lost) body.append(element("p", { className: "soft", textContent: `${two ? `${answers.indexOf(lost) === 0 ? "A" : "B"}: ` : ""}${lost.why_not}` }));
  if (first?.rounded) body.append(element("p", { className: "soft", textContent: "Rounded in this page; tumble dump prints every bit." }));
}

/// answer: of contacts_at(); bodies: the session's table. select(id), go(step).
export function show_contacts(body, answer, { selected, bodies, select, go }) {
  if (!answer) return body.replaceChildren(element("p", { className: "soft", textContent: "…" }));
  if (answer.why_not) {
    body.replaceChildren(element("p", { className: "soft", textContent: answer.why_not }));
    if (answer.near !== null && answer.near !== undefined) {
      body.append(element("p", {}, "The nearest with contacts: ", link(`step ${answer.near}`, () => go(answer.near))));
    }
    return undefined;
  }
  const mine = answer.rows.filter(([a, b]) => selected === null || a === selected || b === selected);
  const sorted = [...mine].sort((one, other) => (other[9] ?? 0) - (one[9] ?? 0)).slice(0, kContactsShown);
  const count = `${mine.length} contact point${mine.length === 1 ? "" : "s"}${selected === null ? "" : ` of ${bodies.label(selected)}`}`;
  const deepest = mine.reduce((most, row) => Math.max(most, row[8] ?? 0), 0);
  body.replaceChildren(element("p", { textContent: `${count}${mine.length > 0 ? `, deepest ${metres(deepest)}` : ""}` }));
  if (sorted.length === 0) return undefined;
  const rows = element("tbody", {}, ...sorted.map((row) => {
    const who = cell("");
    const body_of = (id) => link(bodies.short(id), () => select(id), "", bodies.label(id));
    who.append(body_of(row[0]), " – ", row[1] === 0 ? "ground" : body_of(row[1]));
    return row_of(who, cell(`${Number((row[9] ?? 0).toPrecision(3))} N s`, "number"), cell(metres(row[8]), "number"));
  }));
  const table = element("table", { className: "numbers", ariaLabel: "contacts, the strongest first" }, element("thead", {}, row_of(element("th", { scope: "col", textContent: "bodies" }),
    element("th", { scope: "col", textContent: "impulse", className: "number" }), element("th", { scope: "col", textContent: "depth", className: "number" }))), rows);
  body.append(element("div", { className: "scroll" }, table));
  if (mine.length > sorted.length) body.append(element("p", { className: "soft", textContent: `The ${sorted.length} strongest are listed.` }));
  return undefined;
}

/// account: blame_json() of the program, or {why_not}, or null while it is computed. go(step), select(id), again(answers).
export function show_blame(body, account, bodies, go, select, again) {
  if (!account) return body.replaceChildren(element("p", { className: "soft", textContent: "Taking the steps again …" }));
  if (account.why_not) return body.replaceChildren(element("p", { className: "soft", textContent: account.why_not }));
  const head = element("p", {}, link(bodies.label(account.body).replace(/^body /, "Body "), () => select(account.body)),
    `, ${account.field} after step ${account.step}: ${say(account.value)} ${account.unit}`);
  const list = element("ol", { className: "blame" }, ...account.answers.map((answer) => {
    const where = answer.substep === null ? answer.phase : `${answer.phase}, substep ${answer.substep}`;
    const item = element("li", {}, link(`step ${answer.step}`, () => go(answer.step)), ` · `, element("strong", { textContent: where }),
      element("p", { textContent: answer.text }));
    if (answer.shares.length > 0) {
      item.append(element("ul", { className: "shares" }, ...answer.shares.map((share) => {
        const row = element("li", {}, `${share.kind}`);
        if (share.kind === "contact") row.append(" with ", share.with === null ? "the ground" : link(bodies.label(share.with), () => select(share.with)));
        row.append(`: ${say(share.amount)} ${answer.unit}`);
        return row;
      })));
    }
    return item;
  }));
  body.replaceChildren(head, list);
  if (account.ends) body.append(element("p", { className: "soft", textContent: account.ends }));
  for (const note of account.notes ?? []) body.append(element("p", { className: "soft", textContent: note }));
  if (!account.complete) {
    const more = element("button", { type: "button", textContent: "Further back" });
    more.addEventListener("click", () => again(account.answers.length + 5));
    body.append(element("p", {}, more));
  }
  return undefined;
}

const value_text = (value, hex) => `${say(value)}${hex ? ` (${hex})` : ""}`;

function phases_table(partings, go) {
  if (partings.why_not) return element("p", { className: "soft", textContent: `Phases: ${partings.why_not}` });
  const rows = element("tbody", {}, ...partings.rows.map((phase) => {
    const at = cell("", "number");
    if (phase.step === null) at.textContent = "never";
    else at.append(link(String(phase.step), () => go(phase.step), "", `step ${phase.step}`));
    const made = row_of(element("th", { scope: "row", textContent: phase.phase }), at,
      cell(phase.step === null ? "" : String(phase.substep), "number"), cell(String(phase.steps), "number"));
    made.classList.toggle("differs", phase.step === partings.from);
    return made;
  }));
  const heads = ["phase", "from step", "substep", "steps"];
  return element("div", { className: "scroll" }, element("table", { className: "numbers phases" },
    element("caption", { textContent: `Phases in which the two part, steps ${partings.from} to ${partings.last}` }),
    element("thead", {}, row_of(...heads.map((words, i) => element("th", { scope: "col", textContent: words, className: i > 0 ? "number" : "" })))), rows));
}

/// What was found, in a sentence; empty while it is not known.
export function verdict_of(found) {
  if (!found || found.state === "working") return "";
  if (found.state === "failed") return found.why;
  const { first } = found;
  if (!first) {
    const [a, b] = found.last;
    if (found.identical) return `Identical: ${found.steps} steps, the same in ${found.every_bit}.`;
    return a === b ? `Different: ${found.unequal}; the ${found.steps} steps of both are the same in all else that was compared.`
      : `The ${found.steps} steps of both are the same; A ends with step ${a}, B with step ${b}.`;
  }
  const where = [`step ${first.step}`, `phase ${first.phase}`];
  if (first.substep !== null) where.push(`substep ${first.substep}`);
  return `First difference: ${where.join(", ")}`;
}

/// found: difference_data() of the program. label(id), go(step), select(id).
export function show_difference(body, found, label, go, select) {
  if (!found || found.state === "working") {
    const share = found ? ` (${Math.floor(100 * found.done)} %)` : "";
    return body.replaceChildren(element("p", { textContent: `Comparing every byte of both${share} …` }));
  }
  const verdict = verdict_of(found);
  if (found.state === "failed") return body.replaceChildren(element("p", { className: "bad", textContent: verdict }));
  const parts = [];
  const first = found.first;
  if (!first) {
    parts.push(element("p", { className: found.identical ? "good" : "bad", textContent: verdict }));
    parts.push(element("p", { textContent: `Compared: ${(found.compared ?? []).join(", ")}.` }),
      element("p", { className: "soft", textContent: `Not compared: ${(found.not_compared ?? []).join("; ")}.` }));
  } else {
    parts.push(element("p", {}, element("strong", { textContent: verdict })));
    if (found.cause) parts.push(element("p", { textContent: `Cause: ${found.cause}` }));
    const effect = found.effect ?? first;
    const later = effect.step !== first.step;
    const what = element("p", { className: "effect" });
    if (later || effect.phase !== first.phase) what.append("Effect: ", link(`step ${effect.step}`, () => go(effect.step)), `, phase ${effect.phase}, `);
    if (effect.body !== null) what.append(link(label(effect.body), () => select(effect.body)), ", ");
    if (effect.field === "body") what.append(`only in ${effect.actual === null ? "A" : "B"}`);
    else what.append(`${effect.field}: ${value_text(effect.expected, effect.expected_hex)} → ${value_text(effect.actual, effect.actual_hex)}`);
    // JSON numbers here are doubles: larger counts are not exact.
    const ulps = effect.ulps > Number.MAX_SAFE_INTEGER ? `about ${effect.ulps.toPrecision(3)}` : effect.ulps;
    if (ulps !== null) what.append(`, ${ulps} ${ulps === 1 ? "ULP" : "ULPs"} apart`);
    parts.push(what);
    const jump = element("button", { type: "button", className: "jump", textContent: `Go to the first difference` });
    jump.addEventListener("click", () => go(first.step));
    parts.push(element("p", {}, jump));
    if (later) {
      const to_state = element("button", { type: "button", className: "jump", textContent: "Go to the first state that differs" });
      to_state.addEventListener("click", () => go(effect.step));
      parts.at(-1).append(" ", to_state);
    }
    const marks = found.aftermath?.marks ?? [];
    if (marks.length > 0) {
      parts.push(element("ul", { className: "marks" }, ...marks.map(({ above, step, body: id }) => element("li", {},
        `more than ${metres(above)} apart from `, link(`step ${step}`, () => go(step)), ", ", link(label(id), () => select(id))))));
    } else if (found.growth_unknown) parts.push(element("p", { className: "soft", textContent: `Its growth is not known: ${found.growth_unknown}` }));
    if (found.partings) parts.push(phases_table(found.partings, go));
  }
  for (const note of found.notes ?? []) parts.push(element("p", { className: "soft", textContent: note }));
  return body.replaceChildren(...parts);
}
