// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers over numbers: what studies ask for along rays and over depths, and every number over a swept parameter.

/** More curves than these in one plot can't be told apart. */
const mostCurves = 6;

/** So many of a list, first and last among them. */
function spread(list, most) {
  if (list.length <= most) return list;
  return Array.from({ length: most }, (_, i) => list[Math.round((i * (list.length - 1)) / (most - 1))]);
}

const curveSymbols = ({ x, y }, label) => x.map((at, i) => ({ label, x: at, y: y[i] }));

/** Curves `{label, x, y}`; that of the reference, if there is one, is drawn in ink. */
function curvesSpec(curves, axes, reference, width, colors, { logarithmic, points, nominal, zero = true } = {}) {
  const labels = curves.map(({ label }) => label);
  const scheme = ["#3b6fb6", "#d1742c", "#3f9b62", "#8a5bb5", "#c2418a", "#7d8a2e", "#20a0a8"];
  const range = labels.map((label, i) => (label === reference ? colors.ink : scheme[i % scheme.length]));
  const place = { x: { scale: "x", field: "x" }, y: { scale: "y", field: "y" } };
  const stroke = { stroke: { scale: "color", field: "label" } };
  const line = mark("line", "series", { ...place, ...stroke, strokeWidth: { value: 1.5 } });
  const dots = mark("symbol", "series", { ...place, ...stroke, fill: { scale: "color", field: "label" }, size: { value: 24 } });
  const groups = { type: "group", from: { facet: { name: "series", data: "values", groupby: "label" } }, marks: nominal ? [dots] : points ? [line, dots] : [line] };
  const axis = { grid: true, tickCount: 5, labelOverlap: true };
  const xs = curves.flatMap(({ x }) => x);
  const xScale = nominal ? { type: "point", padding: 0.5, domain: [...new Set(xs)] }
                         : { type: "linear", domain: { data: "values", field: "x" }, zero: false };
  // Between whole numbers, of bands or bins, there is nothing.
  const xAxis = xs.every(Number.isInteger) ? { ...axis, tickMinStep: 1 } : axis;
  // Of a linear scale a format would round to what tells its ticks apart: 100 as 1e+2.
  const yAxis = logarithmic ? { ...axis, format: "~g" } : axis;
  const yScale = logarithmic ? { type: "log", nice: true } : { type: "linear", nice: true, zero };
  return {
    width, height: 300, autosize: { type: "fit", contains: "padding" }, config: plotConfig(colors),
    data: [{ name: "values", values: curves.flatMap((curve) => curveSymbols(curve, curve.label)) }],
    scales: [
      { name: "x", range: "width", ...xScale },
      { name: "y", range: "height", domain: { data: "values", field: "y" }, ...yScale },
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

/** The curves of one name, the reference's first; of one label the last row's, which is the longest series. */
function curvesNamed(rows, name) {
  const byLabel = new Map();
  for (const row of rows)
    for (const curve of (row.curves ?? []).filter((c) => c.name === name)) {
      const label = curve.label || (row.reference ? "exact" : row.name);
      byLabel.set(label, { ...curve, label });
    }
  const curves = [...byLabel.values()];
  const exact = curves.filter(({ label }) => label === "exact");
  return [...exact, ...spread(curves.filter(({ label }) => label !== "exact"), mostCurves)];
}

/** [title, spec of width and colours] for each name of a curve. */
function curvePlots(rows) {
  const names = [...new Set(rows.flatMap((row) => (row.curves ?? []).map(({ name }) => name)))];
  return names.map((name) => {
    const curves = curvesNamed(rows, name);
    const points = curves.some(({ x }) => x.length < 100);
    return [curves[0].title, (width, colors) => curvesSpec(curves, curves[0], "exact", width, colors, { points })];
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
      const value = column.axis.logarithmic ? (row) => Math.max(column.value(row), smallestError) : column.shown;
      const curve = { label: method, x: sweep.rows.map(sweep.at), y: sweep.rows.map(value) };
      const spec = (width, colors) => curvesSpec([curve], { x_title: sweep.name, y_title }, null, width, colors, { ...column.axis, points: true, nominal: sweep.nominal });
      return [`${method}: ${y_title} over ${sweep.name}`, spec];
    });
  });
}
