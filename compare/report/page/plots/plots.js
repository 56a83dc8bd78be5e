// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a scene: error against each cost, where the time goes, and what sweeps and curves it has.

function themeColors() {
  if (document.documentElement.classList.contains("printing")) return paperColors;
  const style = getComputedStyle(document.documentElement);
  const names = ["ink", "soft", "faint", "line", "accent", "paper"];
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

function plotConfig({ soft, faint, line }) {
  const font = getComputedStyle(document.body).fontFamily;
  return {
    background: null,
    axis: {
      labelColor: soft, labelFont: font, labelFontSize: 11,
      titleColor: soft, titleFont: font, titleFontSize: 12, titleFontWeight: 400,
      domainColor: faint, tickColor: faint, gridColor: line,
    },
    legend: { labelColor: soft, labelFont: font, labelFontSize: 11, symbolType: "square" },
    text: { font },
  };
}

const isTimed = (row) => row.seconds.steps.length > 0;

/** Those whose steps were timed: of many the reference and the fastest. */
function fastest(rows, most) {
  const timed = rows.filter(isTimed);
  if (timed.length <= most) return timed;
  const others = ranked(timed.filter((row) => !row.reference), (row) => row.seconds.median);
  return [...timed.filter((row) => row.reference), ...others].slice(0, most);
}

function stepValues(rows) {
  return rows.flatMap((row) => row.seconds.steps.map(({ name, median }) => ({
    method: row.name, step: name, ms: median * 1e3, tip: `${row.name}, ${name}: ${milliseconds(median)} ms`,
  })));
}

/** More bars than these are read in the table. */
const mostBars = 15;

/** The median of every step, one bar per method: of many the reference and the fastest. */
function stepsSpec(all, width, colors) {
  const rows = fastest(all, mostBars);
  const bar = {
    x: { scale: "x", field: "from" }, x2: { scale: "x", field: "to" },
    y: { scale: "y", field: "method" }, height: { scale: "y", band: 1 },
    fill: { scale: "color", field: "step" }, tooltip: { field: "tip" },
  };
  const values = stepValues(rows), untimed = all.filter((row) => !isTimed(row)).map(({ name }) => name);
  const title = notesBelow(untimed.length > 0 ? [`Of unknown time: ${untimed.join(", ")}.`] : [], width, colors);
  const longest = rows.map((row) => row.seconds.steps.reduce((sum, { median }) => sum + median * 1e3, 0));
  const stack = { type: "stack", groupby: ["method"], field: "ms", as: ["from", "to"] };
  return {
    // 250 as its neighbours, unless the labels of many methods need more.
    width, height: Math.max(250, 110 + 15 * rows.length), autosize: { type: "fit", contains: "padding" },
    config: plotConfig(colors), title: untimed.length > 0 ? title : undefined,
    usermeta: { csv: [["method", "step", "ms"], ...values.map(({ method, step, ms }) => [method, step, ms])] },
    data: [{ name: "steps", values, transform: [stack] }],
    scales: [
      { name: "x", type: "linear", range: "width", nice: true, domain: linearDomain(longest, true) },
      { name: "y", type: "band", range: "height", padding: 0.3, domain: rows.map((row) => row.name) },
      { name: "color", type: "ordinal", range: { scheme: "tableau20" }, domain: { data: "steps", field: "step" } },
    ],
    axes: [
      { orient: "bottom", scale: "x", title: "ms", grid: true, tickCount: 5 },
      { orient: "left", scale: "y", ticks: false, domain: false },
    ],
    legends: [{ fill: "color", orient: "bottom", columns: 3, labelLimit: 120, offset: 2 }],
    marks: [mark("rect", "steps", bar)],
  };
}

function drawPlot(holder, title, spec) {
  holder.replaceChildren();
  const view = new vega.View(vega.parse({ ...spec, description: title }), { renderer: "svg", container: holder, hover: true });
  view.tooltip((_handler, _event, _item, text) => { holder.title = text ?? ""; });
  view.runAsync();
}

/** Puts the plots of a scene's rows into `holder`; returns what draws them, when they are near, for the current width and theme. */
function plotsOf(rows, holder) {
  const plots = [
    ...costColumns().map((cost) =>
      [`Error against ${cost.title.toLowerCase()}`, (width, colors) => tradeOffSpec(rows, cost, width, colors)]),
    [rows.filter(isTimed).length > mostBars ? `Where the time goes, of the fastest ${mostBars}` : "Where the time goes", (width, colors) => stepsSpec(rows, width, colors)],
    ...sweepPlots(rows),
    ...curvePlots(rows),
  ].map(([title, spec]) => ({ title, spec, place: make("div") }));
  holder.append(...plots.map(({ title, spec, place }) => {
    const buttons = plotButtons(`${rows[0].scene}-${title}`, spec, () => place.clientWidth || 480);
    return make("div", { class: "plot" }, make("h3", {}, title, buttons), place);
  }));
  return () => {
    for (const { title, spec, place } of plots) whenNear(place, () => drawPlot(place, `${title}, ${rows[0].scene}`, spec(place.clientWidth, themeColors())));
  };
}
