// SPDX-License-Identifier: GPL-3.0-or-later
// How costs grow with the size of scenes: a plot for each number over each size, and the exponents of its curves.

/** Of many curves those that are apart where the size is largest. */
function growthSpec({ title, curves }, column, width, colors) {
  const scaled = curves.map(({ label, x, y }) => ({ label, x, y: y.map((value) => (numberOf(value) == null ? null : numberOf(value) * column.factor)) }));
  const drawn = spread([...scaled].sort((a, b) => b.y.at(-1) - a.y.at(-1)), mostCurves);
  const notes = drawn.length < curves.length ? [`${drawn.length} of ${curves.length} curves are drawn; the CSV has all.`] : [];
  return curvesSpec(drawn, { x_title: title, y_title: labelOf(column) }, null, width, colors, { logarithmic: true, logarithmicX: true, points: true, all: scaled, notes });
}

/** A line for each method, a column for each number. */
function exponentsTable(title, plots) {
  const calls = [...new Set(plots.flatMap(({ curves }) => curves.map(({ label }) => label)))];
  const heads = [`${title}: exponent of`, ...plots.map(({ column }) => column.title)];
  const lawOf = ({ curves }, call) => curves.find(({ label }) => label === call)?.law ?? "–";
  const head = make("tr", {}, heads.map((text) => make("th", { scope: "col" }, text)));
  const body = calls.map((call) => make("tr", {}, make("td", {}, spaced(call)), plots.map((plot) => make("td", {}, lawOf(plot, call)))));
  return make("div", { class: "wide claims" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body)));
}

function growthOf(title, plots) {
  const holder = make("div", { class: "plots" });
  for (const plot of plots) {
    const heading = `${plot.column.title} over ${title.toLowerCase()}`, place = make("div");
    const spec = (width, colors) => growthSpec(plot, plot.column, width, colors);
    holder.append(make("div", { class: "plot" }, make("h3", {}, heading, plotButtons(`growth-${heading}`, spec, () => place.clientWidth || 480)), place));
    redraws.push(() => whenNear(place, () => drawPlot(place, heading, spec(place.clientWidth, themeColors()))));
  }
  return [holder, exponentsTable(title, plots)];
}

function growthSection({ growth }) {
  if (growth.length === 0) return null;
  const plots = growth.map((plot) => ({ ...plot, column: columnOf(plot.column) }));
  const titles = [...new Set(plots.map(({ title }) => title))];
  const lead = "Exponents p of y = c xᵖ by least squares of the logarithms, with 95 % of them by the scatter about the law; “last” is that between the two largest sizes.";
  return make("section", { id: "growth" }, make("h2", {}, "How costs grow"), make("p", { class: "lead" }, lead),
              titles.flatMap((title) => growthOf(title, plots.filter((plot) => plot.title === title))));
}
