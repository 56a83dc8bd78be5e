// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers over numbers: what studies ask for along rays and over depths, and every number over a swept parameter.

/** More curves than these in one plot can't be told apart. */
const mostCurves = 6;

/** So many of a list, first and last among them. */
function spread(list, most) {
  if (list.length <= most) return list;
  return Array.from({ length: most }, (_, i) => list[Math.round((i * (list.length - 1)) / (most - 1))]);
}

/** The known points of a curve. */
const curvePoints = ({ label, x, y }) => x.map((at, i) => ({ label, x: at, y: y[i] })).filter((point) => isKnown(point.x) && isKnown(point.y));

/** What of errors on a logarithmic axis is said below it. */
const clampedNote = (points) => points.some(({ y }) => y < smallestError) && `Errors below 10${superscript("-7")} stand there.`;

const curvesCsv = (curves, { x_title, y_title }) => [["label", x_title, y_title], ...curves.flatMap(curvePoints).map(({ label, x, y }) => [label, x, y])];

/** Curves `{label, x, y}`; that of the reference, if there is one, is drawn in ink. `all` are those that the file of numbers has, `notes` stand below. */
function curvesSpec(curves, axes, reference, width, colors, { logarithmic, logarithmicX, points, nominal, zero = true, all = curves, notes = [] } = {}) {
  const values = curves.flatMap(curvePoints);
  const drawn = logarithmic ? values.map((point) => ({ ...point, y: Math.max(point.y, smallestError) })) : values;
  const labels = curves.map(({ label }) => label);
  const scheme = ["#3b6fb6", "#d1742c", "#3f9b62", "#8a5bb5", "#c2418a", "#7d8a2e", "#20a0a8"];
  const range = labels.map((label, i) => (label === reference ? colors.ink : scheme[i % scheme.length]));
  const place = { x: { scale: "x", field: "x" }, y: { scale: "y", field: "y" } };
  const stroke = { stroke: { scale: "color", field: "label" } };
  const line = mark("line", "series", { ...place, ...stroke, strokeWidth: { value: 1.5 } });
  const dots = mark("symbol", "series", { ...place, ...stroke, fill: { scale: "color", field: "label" }, size: { value: 24 } });
  const groups = { type: "group", from: { facet: { name: "series", data: "values", groupby: "label" } }, marks: nominal ? [dots] : points ? [line, dots] : [line] };
  const axis = { grid: true, tickCount: 5, labelOverlap: true };
  const xs = values.map(({ x }) => x), ys = drawn.map(({ y }) => y);
  const xScale = nominal ? { type: "point", padding: 0.5, domain: [...new Set(xs)] }
               : logarithmicX ? { type: "log", domain: logarithmicDomain(xs, 0.02) }
                         : { type: "linear", domain: linearDomain(xs, false), zero: false };
  // Between whole numbers, of bands or bins, there is nothing.
  const xAxis = logarithmicX ? { ...axis, format: "~s" } : xs.every(Number.isInteger) ? { ...axis, tickMinStep: 1 } : axis;
  // Of a linear scale a format would round to what tells its ticks apart: 100 as 1e+2.
  const yAxis = logarithmic ? { ...axis, format: "~g" } : axis;
  const yScale = logarithmic ? { type: "log", domain: logarithmicDomain(ys, 0.05) } : { type: "linear", domain: linearDomain(ys, zero), nice: true, zero };
  const title = notesBelow([...notes, logarithmic && clampedNote(values)].filter(Boolean), width, colors);
  return {
    width, height: 300, autosize: { type: "fit", contains: "padding" }, config: plotConfig(colors), title: title.text.length > 0 ? title : undefined,
    usermeta: { csv: curvesCsv(all, axes) },
    data: [{ name: "values", values: drawn }],
    scales: [
      { name: "x", range: "width", ...xScale },
      { name: "y", range: "height", ...yScale },
      { name: "color", type: "ordinal", domain: labels, range },
    ],
    axes: [
      { orient: "bottom", scale: "x", title: axes.x_title, ...xAxis },
      { orient: "left", scale: "y", title: axes.y_title, ...yAxis },
    ],
    legends: curves.length > 1 ? [{ stroke: "color", orient: "bottom", columns: 2, symbolType: "stroke", labelLimit: 200, offset: 2 }] : [],
    marks: [groups],
  };
}

/** The curves of one name, the reference's apart; of one label the last row's, which is the longest series. */
function curvesNamed(rows, name) {
  const byLabel = new Map();
  for (const row of rows)
    for (const curve of (row.curves ?? []).filter((c) => c.name === name)) {
      const label = curve.label || (row.reference ? "exact" : row.name);
      byLabel.set(label, { ...curve, label });
    }
  const curves = [...byLabel.values()], isExact = ({ label }) => label === "exact";
  return { exact: curves.filter(isExact), others: curves.filter((curve) => !isExact(curve)) };
}

/** [title, spec of width and colours] for each name of a curve. */
function curvePlots(rows) {
  const names = [...new Set(rows.flatMap((row) => (row.curves ?? []).map(({ name }) => name)))];
  return names.map((name) => {
    const { exact, others } = curvesNamed(rows, name);
    const all = [...exact, ...others], curves = [...exact, ...spread(others, mostCurves)];
    const points = curves.some(({ x }) => x.length < 100);
    const notes = [all.length > curves.length && `${mostCurves} of ${others.length} curves are drawn; the CSV has all.`,
                   curves[0].title.endsWith(", view 1") && `Of ${viewText(rows[0])}.`];  // a saved plot has no heading
    return [curves[0].title, (width, colors) => curvesSpec(curves, curves[0], "exact", width, colors, { points, all, notes })];
  });
}

/** The one parameter of a method that takes many values while the others stay, and the rows by its value; null if there is none. A choice,
    as of an equation by its number, is nominal: it has no order and nothing between. */
function sweepOf(rows) {
  const values = (name) => new Set(rows.map((row) => row.parameter_values[name]));
  const varied = Object.keys(rows[0].parameter_values).filter((name) => values(name).size > 1);
  if (varied.length !== 1 || rows.length < 4) return null;
  const [name] = varied, text = (row) => row.parameter_values[name];
  if (data.methods[rows[0].method]?.choices.includes(name)) return { name, rows, at: text, nominal: true };
  const at = (row) => Number(text(row));
  if (rows.some((row) => Number.isNaN(at(row)))) return null;
  return { name, rows: [...rows].sort((a, b) => at(a) - at(b)), at };
}

/** The numbers that say so over the swept parameter of each method. */
function sweepPlots(rows) {
  const methods = [...new Set(rows.filter((row) => !row.reference).map((row) => row.method))];
  return methods.flatMap((method) => {
    const sweep = sweepOf(rows.filter((row) => row.method === method && !row.reference));
    if (!sweep) return [];
    return columns.filter(({ sweeps }) => sweeps).map((column) => {
      const y_title = labelOf(column);
      const curve = { label: method, x: sweep.rows.map(sweep.at), y: sweep.rows.map(column.shown) };
      const spec = (width, colors) => curvesSpec([curve], { x_title: sweep.name, y_title }, null, width, colors, { ...column.axis, points: true, nominal: sweep.nominal });
      return [`${method}: ${y_title} over ${sweep.name}`, spec];
    });
  });
}
