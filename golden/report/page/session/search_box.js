// The search: reads what is typed, and lists bodies or runs of steps.
import { element, metres } from "../theme.js";
import { find_body_runs, find_channel_runs, find_runs, pair_in, parse_query } from "./search.js";
import { link } from "./panels.js";

const kShown = 12;
const kExtremes = { ">": ": up to ", ">=": ": up to ", "<": ": down to ", "<=": ": down to ", "=": ": " };

function value_text(value, unit) {
  if (!Number.isFinite(value)) return value < 0 ? "−infinite" : "infinite";
  if (unit === "m") return metres(value);
  return `${Number(value.toPrecision(4))}${unit ? ` ${unit}` : ""}`;
}

/// What a page to send searches where it has not every step of the timeline.
function thinned({ thin }) {
  return thin && thin.rows_run > 1 ? `; of each ${thin.rows_run} steps only the largest value was searched` : "";
}

/// What a page to send compares of single bodies is rounded, and of the states that it has.
function rounded({ head, thin }, unit) {
  if (!thin) return "";
  const searched = thin.every > 1 ? `; ${thin.steps.length} of ${head.last - head.first + 1} states were searched` : "";
  if (unit === "") return searched;
  return searched + (unit === "m" ? `; places are rounded to ${metres(thin.quantum)}` : `; speeds are made of places rounded to ${metres(thin.quantum)}`);
}

/// What the contacts of a step are, where they are not the contact points that the panel shows.
function counted({ head }, quantity) {
  return quantity === "contacts" && head.counts_collisions ? "; contacts are the collisions resolved in all substeps" : "";
}

/// Where Enter goes for "step 120": {step, words}; step null where there is none.
function way_to(asked, steps) {
  if (asked < steps.first || asked > steps.last) return { step: null, words: `no step ${asked}: the session has steps ${steps.first} to ${steps.last}` };
  const step = steps.at_or_before(asked);
  return { step, words: `Enter goes to step ${step}${step === asked ? "" : `, the last before step ${asked} that this page has`}` };
}

export function make_search(page) {
  const input = element("input", { type: "search", placeholder: "speed > 5, wall 0, step 120", autocomplete: "off", spellcheck: false });
  input.setAttribute("aria-label", "search for steps by a condition, or for a body by id or name");
  const said = element("output", { ariaLabel: "what the search found" });
  const list = element("ul", { className: "hits" });
  let query = { kind: "none" };
  let items = [];

  const show_bodies = () => {
    const { bodies } = page.sessions[0];
    const rows = bodies.find(query.text);
    said.value = rows.length === 0 ? "no such body" : `${rows.length} bod${rows.length === 1 ? "y" : "ies"}`;
    list.replaceChildren(...rows.slice(0, kShown).map((row) =>
      element("li", {}, link(bodies.label(bodies.id(row)), () => page.select(bodies.id(row))), bodies.label(bodies.id(row)).includes(bodies.name(row)) ? "" : ` ${bodies.name(row)}`)));
    if (rows.length > kShown) list.append(element("li", { className: "soft", textContent: `and ${rows.length - kShown} more` }));
    page.set_hits([]);
    return rows;
  };
  const show_runs = () => {
    const { rows, timeline_done, unread } = page.sessions[0];
    if (unread) {
      said.value = `the timeline was not read: ${unread}`;
      items = [];
      list.replaceChildren();
      page.set_hits([]);
      return [];
    }
    return list_runs(find_runs(query, rows, (step) => page.separation_at(step)), query.unit, timeline_done,
      counted(page.sessions[0], query.quantity) + thinned(page.sessions[0]));
  };
  /// Whether nothing can be added to what a search of single bodies has read.
  const asks_finished = (two) => page.sessions.slice(0, two ? 2 : 1).every(({ head }) => head.finished || !page.served);
  /// Reads the history of a body in turn, and shows what was found so far.
  const show_body_runs = async (is_new) => {
    const asked = query;
    const ids = page.sessions.map(({ bodies }) => bodies.find(asked.body).map((row) => bodies.id(row)));
    const found = [...new Set(ids.flat())];
    if (found.length !== 1) {
      said.value = found.length === 0 ? `no body "${asked.body}"` : `${found.length} bodies answer to "${asked.body}"; wanted one`;
      list.replaceChildren();
      page.set_hits([]);
      return [];
    }
    const { unit } = asked;
    const two = asked.quantity === "separation" && page.sessions.length === 2;
    const histories = [null, null];
    let runs = [];
    const show = (done) => {
      if (query !== asked) return false;
      if (histories[0] && (!two || histories[1])) runs = list_runs(find_body_runs(asked, ...histories), unit, done, rounded(page.sessions[0], unit));
      return true;
    };
    try {
      for (const s of two ? [1, 0] : [0]) {
        const last = s === 0;
        histories[s] = await page.sessions[s].history(found[0], (history) => { histories[s] = history; return show(false) && query === asked; });
        if (!show(last && asks_finished(two))) return [];
      }
      if (is_new && page.selected !== found[0]) page.select(found[0]);
    } catch (error) {
      if (query === asked) said.value = error.message;
    }
    return runs;
  };
  /// Likewise of a channel: "heat of ball > 7" asks about a body, "pull of ball and can > 1" about a pair.
  const show_channel_runs = async () => {
    const asked = query;
    const [session] = page.sessions;
    const channel = session.rows.channel_heads.findIndex(({ name }) => name === asked.quantity);
    const { of: whose, unit } = session.rows.channel_heads[channel];
    const refuse = (words) => {
      said.value = words;
      list.replaceChildren();
      page.set_hits([]);
    };
    const names = whose === "pairs" ? pair_in(asked.body, (name) => session.bodies.find(name).length === 1) : [asked.body];
    if (whose === "step") return refuse(`"${asked.quantity}" is a channel of the step, not of a body`);
    if (whose === "pairs" && names.length !== 2) return refuse(`"${asked.quantity}" is a channel of pairs: ${asked.quantity} of 1 and 2 > 0`);
    if (!session.channel_history) return refuse("this page has no channels of single bodies; a served page (tumble view without -o) has");
    const found = names.map((name) => session.bodies.find(name));
    for (const [i, rows] of found.entries()) {
      if (rows.length !== 1) return refuse(rows.length === 0 ? `no body "${names[i]}"` : `${rows.length} bodies answer to "${names[i]}"; wanted one`);
    }
    const [a, b] = found.map(([row]) => session.bodies.id(row));
    try {
      const history = await session.channel_history(channel, a, b ?? 0, (more) => {
        if (query === asked) list_runs(find_channel_runs(asked, more), unit, false);
        return query === asked;
      });
      if (query === asked) list_runs(find_channel_runs(asked, history), unit, asks_finished(false));
    } catch (error) {
      if (query === asked) refuse(error.message);
    }
    return undefined;
  };
  const list_runs = ({ runs, judged }, unit, whole, note = "") => {
    const partly = whole ? "" : " so far";
    const unread = page.sessions[0].rows.unread_count();
    const none = judged === 0 ? `no step has a value of it${partly}` : `in no step${partly}`;
    said.value = (runs.length === 0 ? none : `${runs.length} run${runs.length === 1 ? "" : "s"} of steps${partly}, the first at ${runs[0].first}`) +
      (unread === 0 ? "" : unread === 1 ? "; 1 step was not read" : `; ${unread} steps were not read`) + note;
    items = runs.slice(0, kShown).map((run) => {
      const where = run.first === run.last ? `step ${run.first}` : `steps ${run.first} to ${run.last}`;
      const made = element("li", {}, link(where, () => page.player.seek(run.first)), kExtremes[query.comparison],
        link(`${value_text(run.peak, unit)}`, () => page.player.seek(run.at), `at step ${run.at}`));
      if (run.body) made.append(", ", link(page.sessions[0].bodies.label(run.body), () => page.select(run.body)));
      return made;
    });
    list.replaceChildren(...items);
    if (runs.length > kShown) list.append(element("li", { className: "soft", textContent: `and ${runs.length - kShown} more` }));
    page.set_hits(runs);
    return runs;
  };
  const run = () => {
    items = [];
    query = parse_query(input.value, page.sessions[0].rows.channel_heads);
    if (query.kind === "body") return show_bodies();
    if (query.kind === "steps") return show_runs();
    if (query.kind === "body steps" || query.kind === "channel steps") {
      said.value = "…";
      if (query.kind === "body steps") show_body_runs(true);
      else show_channel_runs();
      return [];
    }
    said.value = query.kind === "wrong" ? query.words : query.kind === "step" ? way_to(query.step, page.steps).words : "";
    list.replaceChildren();
    page.set_hits([]);
    return [];
  };
  input.addEventListener("input", run);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") input.blur();
    if (event.key !== "Enter") return;
    event.preventDefault();
    if (query.kind === "step") {
      const { step } = way_to(query.step, page.steps);
      if (step !== null) page.player.seek(step);
    }
    if (query.kind === "steps" || query.kind === "body steps" || query.kind === "channel steps") page.next_hit(event.shiftKey ? -1 : 1);
    else if (query.kind === "body") {
      const [row] = run();
      if (row !== undefined) page.select(page.sessions[0].bodies.id(row));
    }
  });
  const button = (words, label, way) => {
    const made = element("button", { type: "button", textContent: words, title: label });
    made.setAttribute("aria-label", label);
    made.addEventListener("click", () => page.next_hit(way));
    return made;
  };
  return {
    place: element("div", { className: "search" }, element("div", { className: "search-row" }, input,
      button("‹", "the run of steps before (N)", -1), button("›", "the next run of steps (n)", 1)), said, list),
    focus: () => input.focus(),
    at(which) {
      items.forEach((item, i) => item.classList.toggle("at", i === which));
    },
    /// The timeline has grown.
    again() {
      if (query.kind === "steps") {
        const before = page.hit;
        show_runs();
        page.hit = before;
      } else if (query.kind === "step") {
        said.value = way_to(query.step, page.steps).words;
      } else if (query.kind === "body steps") {
        show_body_runs(false);
      } else if (query.kind === "channel steps") {
        show_channel_runs();
      }
    },
  };
}
