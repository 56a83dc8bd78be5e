// Error against cost with its Pareto front, and where the time goes, as Vega specifications.

/** Equal pictures have no logarithm: they are drawn here. */
const smallestError = 1e-7;

/** Those that no other beats in both error and cost, the cheapest first. */
function paretoFront(points) {
  const sorted = [...points].sort((a, b) => a.cost - b.cost || a.error - b.error);
  let best = Infinity;
  return sorted.filter((point) => {
    const beats = point.error < best;
    if (beats) best = point.error;
    return beats;
  });
}

function themeColors() {
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(name).trim();
  return { ink: color("--ink"), soft: color("--soft"), faint: color("--faint"), line: color("--line"), accent: color("--accent"), paper: color("--paper") };
}

function plotConfig(colors) {
  const font = getComputedStyle(document.body).fontFamily;
  const axis = { labelColor: colors.soft, titleColor: colors.soft, labelFont: font, titleFont: font, labelFontSize: 11,
                 titleFontSize: 12, titleFontWeight: 400, domainColor: colors.faint, tickColor: colors.faint, gridColor: colors.line };
  return { background: null, axis, legend: { labelColor: colors.soft, labelFont: font, labelFontSize: 11, symbolType: "square" },
           title: { color: colors.ink, font, fontSize: 13, fontWeight: 600, anchor: "start", offset: 10, frame: "group" }, text: { font } };
}

/** Where a point's label may stand, near places first. */
const labelPlaces = (() => {
  const near = ["right", "top", "bottom", "left"], corners = ["top-right", "bottom-right", "top-left", "bottom-left"];
  return { anchor: [...near, ...corners, ...corners, ...near], offset: [...near.map(() => 6), ...corners.map(() => 4), ...corners.map(() => 12), ...near.map(() => 16)] };
})();

/** `cost` reads a row's cost; the reference's is a dashed line. */
function tradeOffSpec(rows, cost, title, axisTitle, width, colors) {
  const points = rows.filter((row) => !row.reference).map((row) => ({
    name: row.name, cost: cost(row), error: Math.max(row.metrics.rmse, smallestError),
    tip: `${row.name}: RMSE ${scientific(row.metrics.rmse)}, ${fixed(cost(row), 1)} ${axisTitle}` }));
  const front = paretoFront(points);
  for (const point of points) point.best = front.includes(point);
  const reference = rows.filter((row) => row.reference).map((row) => ({ name: row.name, cost: cost(row) }));
  const log = (name, range, fields) => ({ name, type: "log", range, domain: { fields }, padding: 24 });
  return {
    width: width - 66, height: 230, padding: { left: 56, right: 10, top: 34, bottom: 40 }, autosize: "none", config: plotConfig(colors), title,
    data: [{ name: "points", values: points }, { name: "front", values: front }, { name: "reference", values: reference }],
    scales: [log("x", "width", [{ data: "points", field: "cost" }, { data: "reference", field: "cost" }]),
             log("y", "height", [{ data: "points", field: "error" }])],
    axes: [{ orient: "bottom", scale: "x", title: axisTitle, grid: true, format: "~g", tickCount: 5, labelOverlap: true },
           { orient: "left", scale: "y", title: "RMSE", grid: true, format: "~g", tickCount: 5, labelOverlap: true }],
    marks: [
      { type: "rule", from: { data: "reference" }, encode: { enter: { x: { scale: "x", field: "cost" }, y: { value: 0 }, y2: { signal: "height" },
          stroke: { value: colors.faint }, strokeDash: { value: [3, 3] } } } },
      { type: "text", name: "referenceLabel", from: { data: "reference" }, encode: { enter: { x: { scale: "x", field: "cost" }, dx: { value: 4 }, y: { value: 8 },
          text: { field: "name" }, fill: { value: colors.faint }, fontSize: { value: 11 } } } },
      { type: "line", name: "frontLine", from: { data: "front" }, encode: { enter: { x: { scale: "x", field: "cost" }, y: { scale: "y", field: "error" },
          interpolate: { value: "step-after" }, stroke: { value: colors.accent }, strokeWidth: { value: 1.5 }, strokeOpacity: { value: 0.6 } } } },
      { type: "symbol", name: "dots", from: { data: "points" }, encode: { enter: { x: { scale: "x", field: "cost" }, y: { scale: "y", field: "error" },
          size: { value: 60 }, fill: { signal: `datum.best ? "${colors.accent}" : "${colors.paper}"` }, stroke: { value: colors.accent },
          strokeWidth: { value: 1.5 }, tooltip: { field: "tip" } } } },
      { type: "text", from: { data: "dots" }, encode: { enter: { text: { field: "datum.name" }, fill: { value: colors.ink }, fontSize: { value: 11 } } },
        transform: [{ type: "label", size: { signal: "[width, height]" }, ...labelPlaces, avoidMarks: ["dots", "frontLine", "referenceLabel"] }] }] };
}

/** The median of every step, one bar per method. */
function stepsSpec(rows, width, colors) {
  const values = rows.flatMap((row) => row.seconds.steps.map((step) => ({ method: row.name, step: step.name, ms: step.median * 1e3 })));
  for (const value of values) value.tip = `${value.method}, ${value.step}: ${fixed(value.ms, 1)} ms`;
  const bar = { y: { scale: "y", field: "method" }, height: { scale: "y", band: 1 }, x: { scale: "x", field: "from" }, x2: { scale: "x", field: "to" },
                fill: { scale: "color", field: "step" }, tooltip: { field: "tip" } };
  return {
    width, height: 250, autosize: { type: "fit", contains: "padding" }, config: plotConfig(colors), title: "Where the time goes",
    data: [{ name: "steps", values, transform: [{ type: "stack", groupby: ["method"], field: "ms", as: ["from", "to"] }] }],
    scales: [{ name: "x", type: "linear", range: "width", nice: true, domain: { data: "steps", field: "to" } },
             { name: "y", type: "band", range: "height", padding: 0.3, domain: rows.map((row) => row.name) },
             { name: "color", type: "ordinal", range: { scheme: "tableau20" }, domain: { data: "steps", field: "step" } }],
    axes: [{ orient: "bottom", scale: "x", title: "ms", grid: true, tickCount: 5 }, { orient: "left", scale: "y", ticks: false, domain: false }],
    legends: [{ fill: "color", orient: "bottom", columns: 3, labelLimit: 120, offset: 2 }],
    marks: [{ type: "rect", from: { data: "steps" }, encode: { enter: bar } }] };
}

function drawPlot(holder, spec) {
  holder.replaceChildren();
  const view = new vega.View(vega.parse(spec), { renderer: "svg", container: holder, hover: true });
  view.tooltip((_handler, event, item, text) => { item && (holder.title = text ?? ""); });
  view.runAsync();
}

/** Three plots of a scene's rows; returns what draws them for the current width and theme. */
function plotsOf(rows, holder) {
  const specs = [
    (width, colors) => tradeOffSpec(rows, (row) => row.seconds.median * 1e3, "Error against time", "ms", width, colors),
    (width, colors) => tradeOffSpec(rows, (row) => row.bytes.total / 1e6, "Error against memory", "MB", width, colors),
    (width, colors) => stepsSpec(rows, width, colors)];
  const holders = specs.map(() => make("div", { class: "plot" }));
  holder.append(...holders);
  return () => specs.forEach((spec, i) => drawPlot(holders[i], spec(holders[i].clientWidth, themeColors())));
}
