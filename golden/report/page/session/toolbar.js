// What is drawn, and how: the row of controls above the view.
import { element, largest } from "../theme.js";

export function make_toolbar(page) {
  const { drawing } = page;
  const two = page.sessions.length === 2;
  const toggle = (words, key, is_on, flip) => {
    const made = element("button", { type: "button", textContent: words, title: `${words} (${key})` });
    made.addEventListener("click", () => {
      flip();
      show();
    });
    return { made, is_on };
  };
  const paint = element("select", {}, ...[["material", "material"], ["state", "asleep or awake"], ["speed", "speed"],
    ...(two ? [["apart", "distance A to B"]] : [])].map(([value, words]) => element("option", { value, textContent: words })));
  paint.addEventListener("change", () => {
    drawing.paint = paint.value;
    const { rows } = page.sessions[0];
    drawing.top_speed = largest([0.1, ...rows.speed.map((speed) => Math.min(speed ?? 0, 50))]);
    drawing.show();
  });
  const flip_contacts = () => { drawing.with_contacts = !drawing.with_contacts; drawing.show(); };
  const flip_ways = () => { drawing.with_ways = !drawing.with_ways; drawing.show_ways(); page.refresh(); };
  const flip_side = () => { if (two) drawing.set_side_by_side(!drawing.side_by_side); };
  const flip_follow = () => { if (page.selected !== null) { drawing.following = !drawing.following; drawing.show(); } };
  const toggles = [
    toggle("Contacts", "c", () => drawing.with_contacts, flip_contacts),
    toggle("Ways", "w", () => drawing.with_ways, flip_ways),
    ...(two ? [toggle("Side by side", "s", () => drawing.side_by_side, flip_side)] : []),
    toggle("Follow", "f", () => drawing.following, flip_follow),
  ];
  const reset = element("button", { type: "button", textContent: "Whole scene", title: "Whole scene (r)" });
  reset.addEventListener("click", () => drawing.reset_view());
  function show() {
    for (const { made, is_on } of toggles) made.setAttribute("aria-pressed", String(is_on()));
    toggles.at(-1).made.disabled = page.selected === null;
  }
  show();
  return {
    place: element("div", { className: "toolbar", role: "group", ariaLabel: "what is drawn" }, element("label", {}, "Colour by ", paint), ...toggles.map(({ made }) => made), reset),
    show,
    flip: { c: () => { flip_contacts(); show(); }, w: () => { flip_ways(); show(); }, s: () => { flip_side(); show(); },
      f: () => { flip_follow(); show(); }, r: () => drawing.reset_view() },
  };
}
