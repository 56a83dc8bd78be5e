// SPDX-License-Identifier: GPL-3.0-or-later
// Error against a cost, with the Pareto front, as a Vega specification.

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

function tradeOffPoints(rows, cost) {
  const error = errorColumn();
  const points = rows.filter((row) => !row.reference).map((row) => ({
    name: row.name,
    cost: cost.shown(row),
    error: Math.max(error.value(row), smallestError),
    tip: `${row.name}: ${error.title} ${error.text(row)}, ${cost.text(row)} ${cost.unit}`,
  }));
  const front = paretoFront(points);
  for (const point of points) point.best = front.includes(point);
  return { points, front };
}

/** Where a point's label may stand, near places first. */
const labelPlaces = (() => {
  const near = ["right", "top", "bottom", "left"];
  const corners = ["top-right", "bottom-right", "top-left", "bottom-left"];
  const rounds = [[near, 6], [corners, 4], [corners, 12], [near, 16]];
  return {
    anchor: rounds.flatMap(([places]) => places),
    offset: rounds.flatMap(([places, distance]) => places.map(() => distance)),
  };
})();

const atCost = { x: { scale: "x", field: "cost" } };
const atPoint = { ...atCost, y: { scale: "y", field: "error" } };
const constants = (values) => Object.fromEntries(Object.entries(values).map(([name, value]) => [name, { value }]));
const mark = (type, data, enter, more = {}) => ({ type, from: { data }, encode: { enter }, ...more });

/** A dashed line at the reference's cost: it has no error. */
function referenceMarks(colors) {
  const dashes = constants({ y: 0, stroke: colors.faint, strokeDash: [3, 3] });
  const line = { ...atCost, y2: { signal: "height" }, ...dashes };
  const isAtEdge = "scale('x', datum.cost) > width - 70";  // then there is no room to the right
  const side = { align: { signal: `${isAtEdge} ? 'right' : 'left'` }, dx: { signal: `${isAtEdge} ? -4 : 4` } };
  const label = { ...atCost, ...side, text: { field: "name" }, ...constants({ y: 8, fill: colors.faint, fontSize: 11 }) };
  return [mark("rule", "reference", line), mark("text", "reference", label, { name: "referenceLabel" })];
}

/** With more points than these only the front's have their names; the others show theirs under the pointer. */
const mostNames = 14;

function pointMarks(colors, few) {
  const { accent, paper, ink } = colors;
  const stair = constants({ interpolate: "step-after", stroke: accent, strokeWidth: 1.5, strokeOpacity: 0.6 });
  const dot = {
    ...atPoint,
    ...constants({ size: 60, stroke: accent, strokeWidth: 1.5 }),
    fill: { signal: `datum.best ? "${accent}" : "${paper}"` },
    tooltip: { field: "tip" },
  };
  const avoidMarks = ["dots", "frontLine", "referenceLabel"];
  const place = { type: "label", size: { signal: "[width, height]" }, ...labelPlaces, avoidMarks };
  const text = few ? { field: "datum.name" } : { signal: "datum.datum.best ? datum.datum.name : ''" };
  const label = { text, ...constants({ fill: ink, fontSize: 11 }) };
  return [mark("line", "front", { ...atPoint, ...stair }, { name: "frontLine" }),
          mark("symbol", "points", dot, { name: "dots" }),
          mark("text", "dots", label, { transform: [place] })];
}

/** The error over `cost`, a column. */
function tradeOffSpec(rows, cost, width, colors) {
  const { points, front } = tradeOffPoints(rows, cost);
  const reference = rows.filter((row) => row.reference).map((row) => ({ name: row.name, cost: cost.shown(row) }));
  const costs = { fields: [{ data: "points", field: "cost" }, { data: "reference", field: "cost" }] };
  const scale = { type: "log", padding: 24 };
  const axis = { grid: true, format: "~g", tickCount: 5, labelOverlap: true };
  return {
    width: width - 66, height: 230, padding: { left: 56, right: 10, top: 10, bottom: 40 }, autosize: "none",
    config: plotConfig(colors),
    data: Object.entries({ points, front, reference }).map(([name, values]) => ({ name, values })),
    scales: [
      { name: "x", range: "width", domain: costs, ...scale },
      { name: "y", range: "height", domain: { data: "points", field: "error" }, ...scale },
    ],
    axes: [
      { orient: "bottom", scale: "x", title: cost.unit, ...axis },
      { orient: "left", scale: "y", title: errorColumn().heading, ...axis },
    ],
    marks: [...referenceMarks(colors), ...pointMarks(colors, points.length <= mostNames)],
  };
}
