// SPDX-License-Identifier: GPL-3.0-or-later
// All numbers of the study, sorted by a click on a column's head.

/** How a column of each style is written; the program's table of columns says which has which. */
const styles = () => ({ scientific, similarity, decibels, milliseconds, megabytes, count });
const directions = { lower: Math.min, higher: Math.max };
const tips = { seconds: timeTip, bytes: memoryTip, fragments: fragmentsTip };

/** PSNR of equal pictures is infinite, which JSON holds as null. */
const valueOf = ({ name, style }) => (row) => row.values?.[name] ?? (style === "decibels" ? Infinity : null);

const tableColumns = () => [
  { title: "Scene", value: (row) => row.scene, text: String },
  { title: "Method", value: (row) => row.name, text: String },
  ...data.columns.map((column) => ({
    title: column.heading, value: valueOf(column), text: styles()[column.style],
    better: directions[column.better], tip: tips[column.name],
  })),
];

let columns = []; // of the table, once it is made

function timeTip({ seconds }) {
  return `${milliseconds(seconds.min)} to ${milliseconds(seconds.max)} ms in ${seconds.repeats} runs`;
}

function memoryTip({ bytes }) {
  return bytes.parts.map((part) => `${part.name}: ${megabytes(part.bytes)} MB`).join("\n");
}

function fragmentsTip({ fragments, stored, dropped, truncated_pixels }) {
  return `${count(fragments)} seen, ${count(stored)} kept apart, ${count(dropped)} dropped in ${count(truncated_pixels)} pixels`;
}

/** The best value of a column in a scene, the reference left out. */
function bestIn(rows, scene, column) {
  const judged = rows.filter((row) => row.scene === scene && !row.reference && !row.error);
  return column.better(...judged.map(column.value).filter((value) => value != null));
}

function tableRow(rows, row) {
  const identity = columns.slice(0, 2).map((column) => make("td", {}, column.text(column.value(row))));
  const colspan = columns.length - 2;
  if (row.error) return make("tr", {}, identity, make("td", { class: "error", colspan }, row.error));
  const cells = columns.slice(2).map((column) => {
    const value = column.value(row);
    const best = column.better && !row.reference && value === bestIn(rows, row.scene, column);
    return make("td", { class: best && "best", title: column.tip?.(row) }, column.text(value));
  });
  return make("tr", { class: row.reference && "reference" }, identity, cells);
}

/** Numbers by size, names by the alphabet; what a row lacks comes last. */
function compareValues(a, b) {
  if (a == null || b == null) return (a == null) - (b == null);
  return typeof a === "string" ? a.localeCompare(b) : a - b;
}

function sortableTable(rows) {
  const body = make("tbody");
  const heads = columns.map(({ title }, i) =>
    make("th", { scope: "col" }, make("button", { type: "button", onclick: () => sortBy(i) }, title)));
  const fill = (sorted) => body.replaceChildren(...sorted.map((row) => tableRow(rows, row)));
  function sortBy(i) {
    const direction = heads[i].getAttribute("aria-sort") === "ascending" ? -1 : 1;
    heads.forEach((head) => head.removeAttribute("aria-sort"));
    heads[i].setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
    const value = (row) => (row.error && i > 1 ? null : columns[i].value(row));
    fill([...rows].sort((a, b) => direction * compareValues(value(a), value(b))));
  }
  fill(rows);
  return make("div", { class: "wide" }, make("table", {}, make("thead", {}, make("tr", {}, heads)), body));
}

function tableSection(rows) {
  columns = tableColumns();
  const lead = "A click on a head sorts. The best of each scene, the reference left out, is in colour.";
  return make("section", { id: "table" }, make("h2", {}, "All numbers"), make("p", { class: "lead" }, lead),
              sortableTable(rows));
}
