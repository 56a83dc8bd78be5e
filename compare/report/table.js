// All numbers of the study, sorted by a click on a column's head.

const columns = [
  { title: "Scene", value: (row) => row.scene, text: (row) => row.scene },
  { title: "Method", value: (row) => row.name, text: (row) => row.name },
  { title: "RMSE", value: (row) => row.metrics.rmse, text: (row) => scientific(row.metrics.rmse), better: "lower" },
  { title: "SSIM", value: (row) => row.metrics.ssim, text: (row) => similarity(row.metrics.ssim), better: "higher" },
  { title: "PSNR [dB]", value: (row) => row.metrics.psnr ?? Infinity, text: (row) => decibels(row.metrics.psnr), better: "higher" },
  { title: "Max error", value: (row) => row.metrics.max_error, text: (row) => scientific(row.metrics.max_error), better: "lower" },
  { title: "SSIM, 8 bits", value: (row) => row.metrics.displayed.ssim, text: (row) => similarity(row.metrics.displayed.ssim), better: "higher" },
  { title: "Time [ms]", value: (row) => row.seconds.median, text: (row) => milliseconds(row.seconds.median), better: "lower",
    tip: (row) => `${milliseconds(row.seconds.min)} to ${milliseconds(row.seconds.max)} ms in ${row.seconds.repeats} runs` },
  { title: "Memory [MB]", value: (row) => row.bytes.total, text: (row) => megabytes(row.bytes.total), better: "lower",
    tip: (row) => row.bytes.parts.map((part) => `${part.name}: ${megabytes(part.bytes)} MB`).join("\n") },
  { title: "Fragments", value: (row) => row.fragments, text: (row) => count(row.fragments) },
  { title: "Layers", value: (row) => row.max_layers, text: (row) => count(row.max_layers) }];

/** The best value of a column in a scene, the reference left out. */
function bestIn(rows, scene, column) {
  const values = rows.filter((row) => row.scene === scene && !row.reference && !row.error).map(column.value).filter((v) => v != null);
  return column.better === "lower" ? Math.min(...values) : Math.max(...values);
}

function tableRow(rows, row) {
  const identity = columns.slice(0, 2).map((column) => make("td", {}, column.text(row)));
  if (row.error) return make("tr", {}, identity, make("td", { class: "error", colspan: columns.length - 2 }, row.error));
  const cells = columns.slice(2).map((column) => {
    const best = column.better && !row.reference && column.value(row) === bestIn(rows, row.scene, column);
    return make("td", { class: best && "best", title: column.tip?.(row) }, column.text(row));
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
  const heads = columns.map((column, i) => make("th", { scope: "col" }, make("button", { type: "button", onclick: () => sortBy(i) }, column.title)));
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
