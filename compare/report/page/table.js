// SPDX-License-Identifier: GPL-3.0-or-later
// All numbers of the study, sorted by a click on a column's head.

const tips = { seconds: timeTip, bytes: memoryTip, fragments: fragmentsTip };

const nameColumns = [
  { heading: "Scene", value: (row) => row.scene, text: (row) => row.scene },
  { heading: "Method", value: (row) => row.name, text: (row) => (row.given ? `${row.name} (given)` : row.name) },
];

function timeTip({ seconds }) {
  return `${milliseconds(seconds.min)} to ${milliseconds(seconds.max)} ms in ${seconds.repeats} runs`;
}

function memoryTip({ bytes }) {
  return bytes.parts.map((part) => `${part.name}: ${megabytes(part.bytes)} MB`).join("\n");
}

function fragmentsTip({ fragments, stored, dropped, truncated_pixels }) {
  return `${count(fragments)} seen, ${count(stored)} kept apart, ${count(dropped)} dropped in ${count(truncated_pixels)} pixels`;
}

/** Whether a row has the best value of its scene, the reference left out, or one that is not told from it. */
function isAmongBest(rows, row, column) {
  if (!column.best || row.reference) return false;
  const judged = rows.filter(({ scene, reference, error }) => scene === row.scene && !reference && !error);
  const best = column.best(...judged.map(column.value).filter((value) => value != null));
  return column.value(row) === best || judged.some((other) => column.value(other) === best && column.areTied(row, other));
}

function tableRow(rows, row) {
  const names = nameColumns.map((column) => make("td", {}, column.text(row)));
  if (row.error) return make("tr", {}, names, make("td", { class: "error", colspan: columns.length }, row.error));
  const cells = columns.map((column) => {
    const best = isAmongBest(rows, row, column);
    return make("td", { class: best && "best", title: row.given ? row.explanation.join("\n") : tips[column.name]?.(row) }, column.textWithInterval(row));
  });
  return make("tr", { class: row.reference && "reference" }, names, cells);
}

/** Numbers by size, names by the alphabet; what a row lacks comes last. */
function compareValues(a, b) {
  if (a == null || b == null) return (a == null) - (b == null);
  return typeof a === "string" ? a.localeCompare(b) : a - b;
}

/** So few rows are seen at a glance. */
const fewestFiltered = 10;

function sortableTable(rows) {
  const body = make("tbody");
  const all = [...nameColumns, ...columns];
  const heads = all.map(({ heading }, i) =>
    make("th", { scope: "col" }, make("button", { type: "button", onclick: () => sortBy(i) }, heading)));
  let shown = rows, words = [];
  const matches = (row) => words.every((word) => nameColumns.some(({ text }) => text(row).toLowerCase().includes(word)));
  const fill = (sorted) => {
    shown = sorted;
    body.replaceChildren(...sorted.filter(matches).map((row) => tableRow(rows, row)));
  };
  const filter = make("input", { type: "search", placeholder: "filter by scene and method", "aria-label": "Filter by scene and method",
    oninput: () => { words = filter.value.toLowerCase().split(/\s+/).filter(Boolean); fill(shown); } });
  function sortBy(i) {
    const direction = heads[i].getAttribute("aria-sort") === "ascending" ? -1 : 1;
    heads.forEach((head) => head.removeAttribute("aria-sort"));
    heads[i].setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
    const value = (row) => (row.error && i >= nameColumns.length ? null : all[i].value(row));
    fill([...rows].sort((a, b) => direction * compareValues(value(a), value(b))));
  }
  fill(rows);
  const table = make("div", { class: "wide" }, make("table", {}, make("thead", {}, make("tr", {}, heads)), body));
  return rows.length > fewestFiltered ? [make("p", { class: "filter" }, filter), table] : [table];
}

function tableSection(rows) {
  const lead = "A click on a head sorts. The best of each scene, the reference left out, is in colour, with those whose 95 % interval overlaps its own.";
  return make("section", { id: "table" }, make("h2", {}, "All numbers"), make("p", { class: "lead" }, lead),
              sortableTable(rows));
}
