// The page's colours, light or dark, for what is drawn on a canvas.

export function colours() {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue(name).trim();
  return {
    paper: read("--paper"),
    ink: read("--ink"),
    soft: read("--soft"),
    line: read("--line"),
    bad: read("--bad"),
    actual: read("--actual"),
    actual_more: read("--actual-more"),
    expected: read("--expected"),
    contact: read("--contact"),
    select: read("--select"),
    asleep: read("--asleep"),
    way: read("--way"),
    lanes: [read("--actual"), read("--actual-more"), read("--expected"), read("--way")],
  };
}

export function watch_theme(action) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", action);
}

/// Of numbers without NaN; −Infinity for none. Math.max(...numbers) fails where there are more of them than a browser
/// takes as arguments.
export const largest = (numbers) => numbers.reduce((most, one) => (one > most ? one : most), -Infinity);

/// A table by names that may be any: "constructor" is in a plain object without having been put there.
export const by_name = (entries = {}) => Object.assign(Object.create(null), entries);

/// An element with properties and children.
export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/// "1.235 m", "12.3 µm": four digits and a prefix that fits.
export function metres(value) {
  if (value === null || value === undefined) return "–";
  const size = Math.abs(value);
  if (size === 0 || size >= 0.1) return `${Number(value.toPrecision(4))} m`;
  if (size >= 1e-3) return `${Number((value * 1e3).toPrecision(4))} mm`;
  if (size >= 1e-6) return `${Number((value * 1e6).toPrecision(4))} µm`;
  return `${Number(value.toPrecision(3)).toExponential()} m`;  // "1e-9 m", "1.23e-9 m"
}

export function joules(value) {
  if (value === null || value === undefined) return "–";
  return `${Number(value.toPrecision(5))} J`;
}
