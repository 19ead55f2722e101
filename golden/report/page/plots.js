// Energy, symmetry and heights over steps: the actual session as lines, what the golden has of the expected one as
// rings, so that neither needs colour to be told from the other.
import uPlot from "uplot";
import { colours, element, joules, metres } from "./theme.js";

const kHeight = 210;

// Each plot's lines: a column of `actual`, and the column of `expected` that it should run through. group: of the metrics
// that it explains.
const kPlots = [
  { title: "Energy", group: "energy", unit: joules, lines: [
    { label: "total", column: "total", source: "states" },
    { label: "potential", column: "potential", source: "track", dash: [7, 4] },
    { label: "kinetic", column: "kinetic", source: "states", dash: [2, 3] },
  ] },
  { title: "Symmetry", group: "symmetry", unit: metres, lines: [
    { label: "lateral error", column: "lateral_max", source: "track" },
    { label: "column spread", column: "column_spread", source: "track", dash: [7, 4] },
  ] },
  { title: "Heights", group: "stacking", unit: metres, lines: [
    { label: "highest", column: "height_max", source: "track" },
    { label: "mean", column: "height_mean", source: "track", dash: [7, 4] },
  ] },
];

/// A plot for each channel of another engine: its value, or the largest and the least of its bodies or pairs.
function channel_plots(data) {
  return (data.channels ?? []).map(({ key, name, unit, one }) => {
    const line = (label) => ({ label: one ? "value" : label, column: `${key} ${label}`, source: key });
    return {
      title: `Channel ${name}`, unit: (value) => (value === null || value === undefined ? "–" :
        `${Number(value.toPrecision(6))}${unit === "" ? "" : ` ${unit}`}`),
      lines: one ? [line("largest")] : [line("largest"), { ...line("least"), dash: [7, 4] }],
    };
  });
}

const kEmpty = (column) => column === undefined || column.every((value) => value === null);

/// One table of steps for all lines of a plot, as uPlot wants it, and the lines that have anything to show.
function table_of(plot, data) {
  const lines = plot.lines.filter((line) => !kEmpty(data.actual?.[line.column]));
  const tables = lines.length > 0 ? [[data.actual.step, ...lines.map((line) => data.actual[line.column])]] : [];
  const rings = [];
  for (const line of lines) {
    const expected = data.expected[line.source];
    if (!expected || kEmpty(expected[line.column])) continue;
    tables.push([expected.step, expected[line.column]]);
    rings.push(line);
  }
  return { lines, rings, table: tables.length > 0 ? uPlot.join(tables) : null };
}

function series_of(plot, lines, rings, hue) {
  const value = (_, number) => plot.unit(number);
  const strokes = [hue.actual, hue.actual_more, hue.soft];
  const stroke_of = (line) => strokes[lines.indexOf(line)];
  return [
    { label: "step" },
    ...lines.map((line) => ({
      label: line.label, value, stroke: stroke_of(line), width: 1.75, dash: line.dash, spanGaps: true,
      points: { show: false },
    })),
    ...rings.map((line) => ({
      label: `${line.label}, expected`, value, stroke: hue.expected, width: 1.5, class: "ring",
      paths: () => null,
      points: { show: true, size: 8, width: 1.5, stroke: hue.expected, fill: "transparent" },
    })),
  ];
}

/// What is exactly 0 all along gets a scale that says so, not uPlot's 0 … 100.
function range_of(_, low, high) {
  if (low === null || high === null) return [0, 1];
  if (low === high) return low === 0 ? [-0.001, 0.001] : [low - Math.abs(low) / 10, high + Math.abs(high) / 10];
  return uPlot.rangeNum(low, high, 0.1, true);
}

/// A vertical line where the bits first differ.
function mark_first(first, hue) {
  return (chart) => {
    if (first === null) return;
    const x = Math.round(chart.valToPos(first, "x", true));
    const { top, height } = chart.bbox;
    const context = chart.ctx;
    context.save();
    context.strokeStyle = hue.bad;
    context.lineWidth = devicePixelRatio;
    context.setLineDash([3 * devicePixelRatio, 3 * devicePixelRatio]);
    context.beginPath();
    context.moveTo(x, top);
    context.lineTo(x, top + height);
    context.stroke();
    context.restore();
  };
}

function axes_of(plot, hue) {
  const axis = { stroke: hue.soft, grid: { stroke: hue.line, width: 1 }, ticks: { stroke: hue.line, width: 1 } };
  const values = (_, ticks) => ticks.map((tick) => (tick === null ? "" : plot.unit(tick)));
  return [{ ...axis, label: "step", labelSize: 20, size: 36 }, { ...axis, values, size: 82 }];
}

function make_chart(plot, place, data, first) {
  const { lines, rings, table } = table_of(plot, data);
  if (table === null) return null;
  const hue = colours();
  const options = {
    width: place.clientWidth, height: kHeight,
    scales: { x: { time: false }, y: { range: range_of } },
    legend: { markers: { width: 2, dash: (chart, i) => (chart.series[i].dash ? "dashed" : "solid") } },
    axes: axes_of(plot, hue), series: series_of(plot, lines, rings, hue),
    hooks: { draw: [mark_first(first, hue)] }, cursor: { y: false, drag: { x: true, y: false } },
  };
  return new uPlot(options, table, place);
}

/// In words, for those who do not see the plot.
function words_of(plot, data) {
  const parts = plot.lines.filter((line) => !kEmpty(data.actual?.[line.column])).map((line) => {
    const actual = data.actual[line.column].at(-1);
    const expected = data.expected[line.source]?.[line.column]?.at(-1);
    return `${line.label} at the end ${plot.unit(actual)}, expected ${plot.unit(expected)}`;
  });
  return `${plot.title} over steps: ${parts.join("; ")}`;
}

/// Draws the plots of the groups of metrics that the case judges. first: the step from which bits differ, or null.
export function draw_plots(section, data, { first, groups }) {
  const plots = [...kPlots.filter((plot) => groups.includes(plot.group)), ...channel_plots(data)];
  const note = "Lines: this run. Rings: expected, where the golden keeps it (positions to the millimetre)." +
    (first === null ? "" : ` Dashed upright line: first difference, step ${first}.`) +
    " Drag across a plot to zoom, double-click to zoom out.";
  const grid = element("div", { className: "plots" });
  const places = plots.map((plot) => {
    const place = element("div", { className: "plot" });
    place.setAttribute("role", "img");
    place.setAttribute("aria-label", words_of(plot, data));
    grid.append(element("figure", {}, element("figcaption", { textContent: plot.title }), place));
    return place;
  });
  if (plots.length > 0) {
    section.append(element("h3", { textContent: "Over the steps" }), element("p", { className: "soft", textContent: note }),
      grid);
  }

  let charts = [];
  const redraw = () => {
    for (const chart of charts) chart?.destroy();
    charts = plots.map((plot, i) => make_chart(plot, places[i], data, first));
    charts.forEach((chart, i) => { places[i].parentElement.hidden = chart === null; });
  };
  redraw();
  return {
    redraw,
    resize() {
      charts.forEach((chart, i) => {
        const width = places[i].clientWidth;
        if (chart !== null && width > 0 && width !== chart.width) chart.setSize({ width, height: kHeight });
      });
    },
    show_step(step) {
      for (const chart of charts) chart?.setCursor({ left: chart.valToPos(step, "x"), top: 0 });
    },
  };
}
