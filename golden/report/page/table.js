// Sorts and filters the table of failed and moved cases, and hides the sections below of cases that are filtered out.
import { element } from "./theme.js";

const kVerdicts = { failed: "failed", within_bounds: "moved within bounds", unchanged: "unchanged",
  out_of_bounds: "out of bounds, not required", not_judged: "not judged" };
const kOrder = Object.keys(kVerdicts);

const kKeys = {
  name: (row) => row.dataset.name,
  verdict: (row) => kOrder.indexOf(row.dataset.verdict),
  magnitude: (row) => -Number(row.dataset.magnitude),
  category: (row) => row.dataset.category,
};

const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);

function sort_rows(body, key, falling) {
  const rows = [...body.rows].sort((a, b) => (falling ? -1 : 1) * compare(kKeys[key](a), kKeys[key](b)));
  body.append(...rows);
}

function make_sortable(table) {
  const heads = [...table.querySelectorAll("th[data-sort]")];
  for (const head of heads) {
    const button = element("button", { type: "button", textContent: head.textContent });
    head.replaceChildren(button);
    button.addEventListener("click", () => {
      const falling = head.getAttribute("aria-sort") === "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", falling ? "descending" : "ascending");
      sort_rows(table.tBodies[0], head.dataset.sort, falling);
    });
  }
}

function choice(label, values, words) {
  const select = element("select", {}, element("option", { value: "", textContent: "all" }),
    ...values.map((value) => element("option", { value, textContent: words(value) })));
  return { select, place: element("label", {}, label, select) };
}

/// table: the overview. Filters it and all sections of cases by verdict, category and name.
export function make_overview(table) {
  make_sortable(table);
  const things = [...table.tBodies[0].rows, ...document.querySelectorAll("details[data-verdict]")];
  const found = (key) => [...new Set(things.map((thing) => thing.dataset[key]))];
  const verdict = choice("Verdict", kOrder.filter((value) => found("verdict").includes(value)), (value) => kVerdicts[value]);
  const category = choice("Category", found("category").sort(), (value) => value);
  const name = element("input", { type: "search" });
  const said = element("output");
  const show = () => {
    let rows = 0;
    for (const thing of things) {
      const is_row = thing instanceof HTMLTableRowElement;
      const own_name = is_row ? thing.dataset.name : thing.querySelector("h3").id;
      thing.hidden = (verdict.select.value !== "" && thing.dataset.verdict !== verdict.select.value) ||
        (category.select.value !== "" && thing.dataset.category !== category.select.value) ||
        !own_name.includes(name.value);
      if (is_row && !thing.hidden) ++rows;
    }
    said.value = `${rows} of ${table.tBodies[0].rows.length} failed or moved cases`;
  };
  for (const control of [verdict.select, category.select, name]) control.addEventListener("input", show);
  show();
  table.parentElement.before(element("div", { className: "filters" }, verdict.place, category.place,
    element("label", {}, "Name", name), said));
}
