// The keys of the session page, and the list of them.
import { element } from "../theme.js";
import { panel } from "./panels.js";

const kKeys = [
  ["Space", "play, or stop"], ["J  K  L", "play backwards, stop, play"], ["← →", "one step back, on; with Shift ten"],
  ["Home End", "first, last step"], ["[  ]", "the input, difference, gap or break of a bound before, after"], ["d  D", "the first difference, the first state that differs"],
  ["/", "search"], ["n  N", "next run of steps found, the one before"], ["c  w  s  f  r", "contacts, ways, side by side, follow, whole scene"],
  ["Esc", "let the body go"], ["arrows, + −", "in the view: turn, with Shift move; zoom. Drag turns, with Shift moves; the wheel zooms once the view has the focus"],
];

function beside(page, way) {
  const { inputs, gaps, first_difference, first_effect } = page.marks();
  const places = [...page.sessions[0].rows.breaks(), ...inputs.map(({ step }) => step), ...gaps.flatMap(([first, last]) => [first, last])];
  places.push(...[first_difference, first_effect].filter((step) => step !== null));
  const { step } = page.player;
  const further = places.filter((one) => (way > 0 ? one > step : one < step)).sort((a, b) => way * (a - b));
  if (further.length > 0) page.player.seek(further[0]);
}

export function listen_keys(page) {
  const actions = {
    " ": () => page.player.play(page.player.direction || 1), j: () => page.player.play(-1), k: () => page.player.stop(),
    l: () => page.player.play(1), ArrowLeft: (shift) => page.player.move(shift ? -10 : -1),
    ArrowRight: (shift) => page.player.move(shift ? 10 : 1), Home: () => page.player.seek(page.steps.first),
    End: () => page.player.seek(page.steps.last), "[": () => beside(page, -1), "]": () => beside(page, 1),
    d: () => page.go_to_first_difference(), D: () => page.go_to_first_effect(), "/": () => page.search.focus(), n: () => page.next_hit(1), N: () => page.next_hit(-1),
    Escape: () => page.select(null), ...page.toolbar.flip,
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input:not([type=range]), select, textarea")) return;
    const presses = event.target.closest("button, summary, a") !== null;
    if (presses && (event.key === " " || event.key === "Enter")) return;
    const action = actions[event.key] ?? (event.shiftKey ? null : actions[event.key.toLowerCase()]);
    if (!action) return;
    event.preventDefault();
    action(event.shiftKey);
  });
  const { place, body } = panel("Keys", { open: false });
  body.append(element("dl", { className: "keys" }, ...kKeys.flatMap(([keys, words]) =>
    [element("dt", {}, element("kbd", { textContent: keys })), element("dd", { textContent: words })])));
  return { place };
}
