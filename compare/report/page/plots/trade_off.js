// SPDX-License-Identifier: GPL-3.0-or-later
// Error against a cost, with the Pareto front, as a Vega specification.

/** Smaller errors are a float's rounding: with the exact ones, which have no logarithm, they stand on a rail. */
const smallestError = 1e-7;

/** Those that no other beats in both error and cost, the cheapest first. */
function paretoFront(points) {
  const byError = ranked(points, ({ error }) => Math.max(error, smallestError));
  let best = Infinity;
  return ranked(byError, ({ cost }) => cost).filter((point) => {
    const error = Math.max(point.error, smallestError), beats = error < best;
    if (beats) best = error;
    return beats;
  });
}

/** The methods of which both error and cost are known, and the names of the others. */
function tradeOffPoints(rows, cost) {
  const error = errorColumn();
  const methods = rows.filter((row) => !row.reference);
  const isPoint = (row) => isKnown(cost.value(row)) && isKnown(error.value(row));
  const points = methods.filter(isPoint).map((row) => ({
    name: row.name,
    cost: cost.shown(row),
    error: error.value(row),
    tip: `${row.name}: ${error.title} ${error.text(row)}, ${cost.text(row)} ${cost.unit}`,
  }));
  const front = paretoFront(points);
  for (const point of points) point.best = front.includes(point);
  return { points, front, unknown: methods.filter((row) => !isPoint(row)).map(({ name }) => name) };
}

const atPlace = { x: { field: "x" }, y: { field: "y" } };
const constants = (values) => Object.fromEntries(Object.entries(values).map(([name, value]) => [name, { value }]));
const mark = (type, data, enter, more = {}) => ({ type, from: { data }, encode: { enter }, ...more });

/** Of a dashed line at the reference's cost, which has no error, its label's place. */
function referenceLabel({ name, x }, width) {
  const isAtEdge = x + 4 + textWidth(name) > width, left = isAtEdge ? x - 4 - textWidth(name) : x + 4;
  return { name, x, left, box: [left, 0, left + textWidth(name), labelHeight] };
}

function referenceMarks(colors) {
  const dashes = constants({ y: 0, stroke: colors.faint, strokeDash: [3, 3] });
  const label = { x: { field: "left" }, text: { field: "name" }, ...constants({ y: 8, fill: colors.faint, fontSize }) };
  return [mark("rule", "reference", { x: { field: "x" }, y2: { signal: "height" }, ...dashes }), mark("text", "reference", label)];
}

/** Lines that part the rails from the axes, and what stands on them. */
function railMarks(colors) {
  const line = { ...atPlace, x2: { field: "x2" }, y2: { field: "y2" }, ...constants({ stroke: colors.faint }) };
  const label = { x: { field: "left" }, y: { field: "top" }, align: { field: "align" }, text: { field: "text" }, ...constants({ fill: colors.soft, fontSize, baseline: "middle" }) };
  return [mark("rule", "rails", line), mark("text", "rails", label)];
}

function railsOf(x, y, { width, height }) {
  const floor = height - y.rail;
  const exact = { x: 0, y: floor, x2: width, y2: floor, left: -6, top: height - y.rail / 2, align: "right", text: `≤ 10${superscript("-7")}` };
  const free = { x: x.rail, y: 0, x2: x.rail, y2: height, left: x.rail / 2, top: height + 12, align: "center", text: "0" };
  return [y.rail > 0 && exact, x.rail > 0 && free].filter(Boolean);
}

/** With more points than these only the front's have their names; the others show theirs under the pointer. */
const mostNames = 14;

function pointMarks(colors) {
  const { accent, paper, ink } = colors;
  const stair = constants({ interpolate: "step-after", stroke: accent, strokeWidth: 1.5, strokeOpacity: 0.6 });
  const dot = {
    ...atPlace,
    ...constants({ size: 60, stroke: accent, strokeWidth: 1.5 }),
    fill: { signal: `datum.best ? "${accent}" : "${paper}"` },
    tooltip: { field: "tip" },
    description: { field: "tip" },
  };
  const label = { ...atPlace, text: { field: "text" }, ...constants({ fill: ink, fontSize, baseline: "middle" }) };
  return [mark("line", "front", { ...atPlace, ...stair }), mark("symbol", "points", dot, { name: "dots" }), mark("text", "labels", label)];
}

/** The boxes of the stair through the front's points. */
const stairBoxes = (front) => front.slice(1).flatMap((to, i) => {
  const from = front[i];
  return [[from.x, from.y, to.x, from.y], [to.x, Math.min(from.y, to.y), to.x, Math.max(from.y, to.y)]];
});

function tradeOffNotes({ homeless, others, unknown, cost }) {
  const named = ranked(homeless, (point) => point.cost).map(({ name }) => name).join(", ");
  return [named && `Without room for a name, the cheapest first: ${named}.`, others > 0 && `${counted(others, "further point")}: named under the pointer and in the table.`,
          unknown.length > 0 && `Not drawn, of unknown error or ${cost.title.toLowerCase()}: ${unknown.join(", ")}.`].filter(Boolean);
}

const tradeOffCsv = (points, cost) =>
  [["name", cost.unit, errorColumn().heading, "on the front"], ...points.map(({ name, cost: at, error, best }) => [name, at, error, best])];

/** The error over `cost`, a column. */
function tradeOffSpec(rows, cost, width, colors) {
  const margin = { left: 68, right: 10 }; // of the longest label of a tick, 0.00005, and the axis's title
  const size = { width: width - margin.left - margin.right, height: 230 };
  const { points, front, unknown } = tradeOffPoints(rows, cost);
  const references = rows.filter((row) => row.reference && isKnown(cost.value(row))).map((row) => ({ name: row.name, cost: cost.shown(row) }));
  const x = railedAxis([...points, ...references].map((point) => point.cost), 0, size.width);
  const y = railedAxis(points.map(({ error }) => error), smallestError, size.height);
  for (const point of points) Object.assign(point, { x: x.at(point.cost), y: size.height - y.at(point.error) });
  const reference = references.map(({ name, cost: at }) => referenceLabel({ name, x: x.at(at) }, size.width));
  const few = points.length <= mostNames, named = few ? [...front, ...points.filter(({ best }) => !best)] : front;
  const { labels, homeless } = placeLabels(named, points, size, [...reference.map(({ box }) => box), ...stairBoxes(front)]);
  const notes = tradeOffNotes({ homeless, others: points.length - named.length, unknown, cost });
  const title = notesBelow(notes, width - 20, colors);
  const axis = { grid: true, format: "~g", tickCount: 5, labelOverlap: true };
  return {
    ...size, padding: { ...margin, top: 10, bottom: 42 + 14 * title.text.length }, autosize: "none",
    config: plotConfig(colors), title: notes.length > 0 ? title : undefined,
    usermeta: { csv: tradeOffCsv(points, cost) },
    data: Object.entries({ points, front, reference, labels, rails: railsOf(x, y, size) }).map(([name, values]) => ({ name, values })),
    scales: [
      { name: "x", type: "log", range: [x.rail, size.width], domain: x.domain },
      { name: "y", type: "log", range: [size.height - y.rail, 0], domain: y.domain },
    ],
    axes: [
      { orient: "bottom", scale: "x", title: cost.unit, ...axis },
      { orient: "left", scale: "y", title: errorColumn().heading, ...axis },
    ],
    marks: [...referenceMarks(colors), ...railMarks(colors), ...pointMarks(colors)],
  };
}
