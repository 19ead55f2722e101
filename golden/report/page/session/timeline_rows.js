// The numbers of each step that the timeline shows and the search reads: columns, a row a step that was read so far.
import { by_name } from "../theme.js";

const kColumns = ["step", "time", "read", "kinetic", "potential", "inputs", "contacts", "bodies", "sleeping", "lost",
  "speed", "speed_body", "height", "overlap"];

/// Adds a reply's values to a column: numbers, null, objects, and infinite numbers as "Infinity", which JSON has none
/// for. Not by push(...values): a browser takes no call of a hundred thousand arguments.
export function add_values(column, values) {
  for (const value of values) column.push(typeof value === "string" ? Number(value) : value);
}

export class TimelineRows {
  /// channels: those of the log's head, [{name, unit, of}]. of_another: whether it is the log of another engine.
  constructor(channels = [], of_another = false) {
    this.channel_heads = channels;
    for (const name of kColumns) this[name] = [];
    this.begun = [];
    this.of_another = of_another;
    this.may_lack_contacts = of_another;  // until a row has one
    this.contacts_seen = 0;
    this.label = (id) => `body ${id}`;
    this.events = [];  // inputs: {step, kind, body, text}
    this.begun_why_not = "";
    this.channels = by_name();
    this.bounds = [];  // {value, broken}, in the order of the head's
  }

  get count() { return this.step.length; }

  /// json: timeline_json() of the program.
  append(json) {
    for (const name of kColumns) add_values(this[name], json[name]);
    json.bounds.forEach(({ value, broken }, b) => {
      // Rows before the first that was judged have no entry.
      const bound = this.bounds[b] ??= { value: new Array(this.count - value.length).fill(null), broken: new Array(this.count - value.length).fill(null) };
      add_values(bound.value, value);
      add_values(bound.broken, broken);
    });
    json.channels.forEach((values, c) => {
      const { name } = this.channel_heads[c];
      const column = this.channels[name] ??= [];
      while (column.length < this.count - values.length) column.push(null);
      add_values(column, values);
    });
  }

  /// The row of a step, or of the last step before it; −1 before the first.
  index(step) {
    const { count } = this;
    if (count === 0 || step < this.step[0]) return -1;
    const stride = count > 1 ? this.step[1] - this.step[0] : 1;
    let i = Math.min(count - 1, Math.max(0, Math.floor((step - this.step[0]) / stride)));
    while (i > 0 && this.step[i] > step) --i;
    while (i + 1 < count && this.step[i + 1] <= step) ++i;
    return i;
  }

  /// Whether the rows read so far go up to a step; rows of a thinned timeline stand for the steps up to the next.
  reaches(step) {
    const stride = this.count > 1 ? this.step[1] - this.step[0] : 1;
    return this.count > 0 && step < this.step[this.count - 1] + stride;
  }

  /// Runs of steps that could not be read: [first, last, why].
  unread() {
    const runs = [];
    for (let i = 0; i < this.count; ++i) {
      if (this.read[i] !== 0) continue;
      const run = runs.at(-1);
      const last = i + 1 < this.count ? this.step[i + 1] - 1 : this.step[i];  // a row of a thinned timeline is of several
      if (run && i > 0 && this.read[i - 1] === 0) run[1] = last;
      else runs.push([this.step[i], last, "the record with it is damaged"]);
    }
    return runs;
  }

  unread_count() { return this.unread().reduce((sum, [first, last]) => sum + last - first + 1, 0); }

  /// The number of bounds that are broken up to row i.
  broken(i) { return this.bounds.reduce((sum, { broken }) => sum + (broken[i] ?? 0), 0); }

  /// The first step up to which a bound is broken, of each that is.
  breaks() {
    return this.bounds.map(({ broken }) => broken.indexOf(1)).filter((i) => i >= 0).map((i) => this.step[i]);
  }

  /// Whether no row has a contact and the log would hold some only where its engine told them.
  without_contacts() {
    while (this.may_lack_contacts && this.contacts_seen < this.count) {
      if (this.contacts[this.contacts_seen++] > 0) this.may_lack_contacts = false;
    }
    return this.may_lack_contacts;
  }

  /// The contacts of row i; null where none was told.
  contacts_told(i) { return this.without_contacts() ? null : this.contacts[i]; }

  /// Why a page to send shows no contacts of a step: the log may hold what the page has no room for.
  why_no_contacts(step) {
    const no_contacts = "the log of another engine holds no contacts";
    if (this.without_contacts()) return no_contacts;
    if (this.of_another && this.contacts[Math.max(0, this.index(step))] === 0) return `${no_contacts} of step ${step}`;
    return "this page has no contacts of this state; a served page (tumble view without -o) has all";
  }

  energy(i) {
    return this.kinetic[i] === null || this.potential[i] === null ? null : this.kinetic[i] + this.potential[i];
  }
}
