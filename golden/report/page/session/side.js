// The panels beside the view, and what is asked for them: the body chosen, its contacts, where a value comes from, the
// comparison, the inputs.
import { element } from "../theme.js";
import { panel, say, show_blame, show_body, show_contacts, show_difference, verdict_of } from "./panels.js";

export class Side {
  constructor(page) {
    this.page = page;
    this.sessions = page.sessions;
    this.body_panel = panel("Body");
    this.blame_panel = panel("Where it comes from");
    this.blame_panel.place.hidden = true;
    this.contact_panel = panel("Contacts");
    this.input_panel = panel("Inputs", { open: false });
    this.difference_panel = panel("Comparison");
    this.places = [...(this.sessions.length === 2 ? [this.difference_panel.place] : []), this.body_panel.place,
      this.blame_panel.place, this.contact_panel.place, this.input_panel.place];
  }

  /// Once the step stays: contacts and the numbers of the body chosen. The contacts of a step may take long: only one
  /// question about them is under way at a time, and the last one asked meanwhile follows it.
  settled(step) {
    this.next_contacts = step;
    this.asking_contacts ??= this.ask_contacts().finally(() => { this.asking_contacts = null; });
    return Promise.all([this.asking_contacts, this.show_body(step)]);
  }

  async ask_contacts() {
    while (this.next_contacts !== null) {
      const step = this.next_contacts;
      this.next_contacts = null;
      await this.show_contacts(step);
    }
  }

  async show_contacts(step) {
    const answers = await Promise.all(this.sessions.map(async (session) => {
      if (step < session.head.first || step > session.head.last) return { step, why_not: "the log has no such step" };
      return session.contacts_at(session.steps ? this.page.own_step(session, step) : step);
    }));
    if (this.page.player.step !== step) return;
    this.page.drawing.contacts = answers;
    this.page.drawing.show();
    this.draw_contacts();
  }

  draw_contacts() {
    const { contacts } = this.page.drawing;
    const two = this.sessions.length === 2;
    this.contact_panel.body.replaceChildren(...this.sessions.flatMap(({ bodies }, s) => {
      const place = element("div", { className: "contacts" });
      show_contacts(place, contacts[s], { selected: this.page.selected, bodies, select: (id) => this.page.select(id),
        go: (step) => this.page.player.seek(step) });
      return two ? [element("h3", {}, element("span", { className: `side side-${"ab"[s]}`, textContent: "AB"[s] })), place] : [place];
    }));
  }

  show_selection() {
    if (this.page.selected === null) {
      this.body_panel.body.replaceChildren(element("p", { className: "soft",
        textContent: "Press a body in the view, or search for its id or name." }));
    }
  }

  async show_body(step) {
    const id = this.page.selected;
    if (id === null) return;
    const answers = await Promise.all(this.sessions.map((session) =>
      session.body_at(session.steps ? this.page.own_step(session, step) : step, id)));
    if (this.page.selected !== id || this.page.player.step !== step) return;
    const session = this.sessions.find((one) => one.bodies.row(id) !== undefined) ?? this.sessions[0];
    const row = session.bodies.row(id);
    const actions = element("p", { className: "actions" }, ...[
      ["Follow", () => { this.page.drawing.following = !this.page.drawing.following; this.page.toolbar.show(); this.page.drawing.show(); }],
      ["Look at", () => { const at = this.page.drawing.place_of(0, id) ?? this.page.drawing.place_of(1, id); if (at) this.page.drawing.stage?.look_at(at); }],
      ["Let go", () => this.page.select(null)],
    ].map(([words, action]) => {
      const made = element("button", { type: "button", textContent: words });
      made.addEventListener("click", action);
      return made;
    }));
    show_body(this.body_panel.body, { id, label: session.bodies.label(id), name: row === undefined ? "" : session.bodies.name(row),
      shape: row === undefined ? "size unknown" : session.bodies.shape_words(row), answers, actions,
      bodies: session.bodies, plots: session === this.sessions[0] ? this.page.plots : null, asked: this.sessions[0].head.blames && this.sessions[0].blame ? (field) => this.show_blame(step, id, field) : null });
  }

  /// Where a value of the body chosen comes from.
  async show_blame(step, id, field, back = 5) {
    this.blame_panel.place.hidden = false;
    this.blame_panel.place.open = true;
    const mine = this.blamed = {};
    const fill = (account) => show_blame(this.blame_panel.body, account, this.sessions[0].bodies, (at) => this.page.player.seek(at), (other) => this.page.select(other),
      (more) => this.show_blame(step, id, field, more));
    fill(null);
    try {
      const account = await this.sessions[0].blame(step, id, field, back);
      if (this.blamed !== mine) return;
      fill(account);
      const [first] = account.answers ?? [];
      this.page.tell(account.why_not ?? `${account.field} ${say(account.value)} comes from step ${first.step}, ${first.phase}: ${first.text}`);
    } catch (error) {
      if (this.blamed === mine) fill({ why_not: error.message });
    }
  }

  show_difference() {
    show_difference(this.difference_panel.body, this.page.difference, (id) => this.label(id), (step) => this.page.player.seek(step), (id) => this.page.select(id));
    this.page.tell(verdict_of(this.page.difference));
  }

  /// The name of a body, as the first session that knows it has it.
  label(id) { return (this.sessions.find(({ bodies }) => bodies.row(id) !== undefined) ?? this.sessions[0]).bodies.label(id); }

  show_inputs() {
    const { events } = this.sessions[0].rows;
    if (this.inputs_shown === events.length) return;
    this.inputs_shown = events.length;
    const shown = events.slice(0, 200);
    this.input_panel.body.replaceChildren(events.length === 0 ? element("p", { className: "soft", textContent: "None." })
      : element("ol", { className: "inputs" }, ...shown.map(({ step, kind, body, text }) => {
        const go = element("button", { type: "button", className: "link", textContent: `step ${step}` });
        go.addEventListener("click", () => this.page.player.seek(step));
        return element("li", {}, go, ` ${kind}${body === null ? "" : ` ${this.sessions[0].bodies.short(body)}`} ${text}`);
      })));
    if (events.length > shown.length) this.input_panel.body.append(element("p", { className: "soft", textContent: `and ${events.length - shown.length} more` }));
  }
}
