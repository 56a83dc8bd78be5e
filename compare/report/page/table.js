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

/** How a number stands to the best of its scene: "best" with those tied with it; "undecided" where it is the least of times that decide nothing. */
function standingOf(column, row, judged) {
  const [best] = judged;
  if (row !== best) return verdictOf(column, row, best) === "tied" ? "best" : null;
  return judged.length > 1 && !placeOf(column, best) ? "undecided" : "best";
}

/** Of each row its standings by column, the reference left out. */
function standings(rows) {
  const standing = new Map(rows.map((row) => [row, {}]));
  const scenes = new Map();
  for (const row of rows.filter(({ reference, error }) => !reference && !error)) scenes.set(row.scene, [...(scenes.get(row.scene) ?? []), row]);
  for (const column of columns.filter(({ direction }) => direction))
    for (const here of scenes.values()) {
      const judged = ranked(here, column.value, column.direction);
      for (const row of judged) standing.get(row)[column.name] = standingOf(column, row, judged);
    }
  return standing;
}

function tableCell(column, row, standing) {
  const tip = standing === "undecided" ? `not told apart: ${tooFewTimes}` : row.given ? row.explanation.join("\n") : tips[column.name]?.(row);
  return make("td", { class: standing, title: tip }, column.textWithInterval(row));
}

function tableRow(row, standing) {
  const names = nameColumns.map((column) => make("td", {}, column.text(row)));
  if (row.error) return make("tr", {}, names, make("td", { class: "error", colspan: columns.length }, row.error));
  return make("tr", { class: row.reference && "reference" }, names, columns.map((column) => tableCell(column, row, standing[column.name])));
}

/** So few rows are seen at a glance. */
const fewestFiltered = 10;

function sortableTable(rows) {
  const body = make("tbody");
  const all = [...nameColumns, ...columns];
  const heads = all.map(({ heading }, i) =>
    make("th", { scope: "col" }, make("button", { type: "button", onclick: () => sortBy(i) }, heading)));
  const standing = standings(rows);
  const lines = new Map(rows.map((row) => [row, tableRow(row, standing.get(row))]));
  let shown = rows, matches = () => true;
  const fill = (sorted) => {
    shown = sorted;
    body.replaceChildren(...sorted.filter(matches).map((row) => lines.get(row)));
  };
  const filter = make("input", { type: "search", placeholder: "filter: fourier rmse<0.01", "aria-label": "Filter by scene, method and bounds on numbers",
    title: "words of scene and method, and bounds on columns: rmse<0.01 ms<=5 psnr>30", oninput: () => { matches = filterOf(filter.value); fill(shown); } });
  function sortBy(i) {
    const direction = heads[i].getAttribute("aria-sort") === "ascending" ? -1 : 1;
    heads.forEach((head) => head.removeAttribute("aria-sort"));
    heads[i].setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
    const value = (row) => (row.error && i >= nameColumns.length ? null : all[i].value(row));
    fill([...rows].sort((a, b) => compareKnown(value(a), value(b), direction)));
  }
  fill(rows);
  const table = make("div", { class: "wide" }, make("table", {}, make("thead", {}, make("tr", {}, heads)), body));
  const copies = copyButtons(() => shown.filter(matches), standing);
  return [make("p", { class: "filter" }, rows.length > fewestFiltered && filter, copies), table];
}

function tableSection(rows) {
  const lead = "A click on a head sorts. The best of each scene, the reference left out, is in colour, with those that equal it or whose 95 % interval overlaps its own; " +
    `the least of times from ${tooFewTimes} is underlined: it decides nothing.`;
  return make("section", { id: "table" }, make("h2", {}, "All numbers"), make("p", { class: "lead" }, lead),
              sortableTable(rows));
}
