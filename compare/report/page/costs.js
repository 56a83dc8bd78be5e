// SPDX-License-Identifier: GPL-3.0-or-later
// Where a study gives its source's costs: every method's memory and time, step by step, beside the source's.

const shortTime = (ms) => (ms == null ? "–" : ms >= 100 ? ms.toFixed(0) : String(Number(ms.toPrecision(3))));

function costsTable({ title, steps, lines }) {
  const titles = ["Scene", "Method", "Memory [MB]", "Total [ms]", ...steps];
  const head = make("tr", {}, titles.map((text) => make("th", { scope: "col" }, text)));
  const body = lines.map((line) =>
    make("tr", {}, make("td", {}, line.scene), make("td", {}, line.call.replace(":", ": ")),
         make("td", {}, line.bytes == null ? "–" : megabytes(line.bytes)), make("td", {}, shortTime(line.milliseconds)),
         line.steps.map((step, k) => make("td", { class: k === line.bottleneck && "best" }, shortTime(step)))));
  return make("div", {}, make("h3", {}, title),
              make("div", { class: "wide costs" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}

function ratiosTable({ ratios, reference }) {
  const titles = ["Scene", "Method", "Here", "As published"];
  const head = make("tr", {}, titles.map((text) => make("th", { scope: "col" }, text)));
  const times = (ratio) => (ratio == null ? "–" : `${Number(ratio.toPrecision(3))} ×`);
  const body = ratios.map((ratio) =>
    make("tr", {}, make("td", {}, ratio.scene), make("td", {}, ratio.call.replace(":", ": ")),
         make("td", {}, times(ratio.here)), make("td", {}, times(ratio.published))));
  return make("div", {}, make("h3", {}, `How many times as long ${reference} takes`),
              make("div", { class: "wide costs" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}

function costsSection({ costs }) {
  if (costs.tables.length === 0) return null;
  const lead = "Milliseconds of every step, the longest in bold; then what the source printed, and how the reference's time compares.";
  return make("section", { id: "costs" }, make("h2", {}, "What it costs"), make("p", { class: "lead" }, lead),
              costs.tables.map(costsTable), ratiosTable(costs));
}
