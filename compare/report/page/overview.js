// SPDX-License-Identifier: GPL-3.0-or-later
// What only shows across scenes: every method's error on each of them, and the cheapest method within an error bound.

/** From transparent at 1e-6 to full at 1: how dark a cell of the overview is. */
const shadeOf = (error) => Math.min(1, Math.max(0, 1 + Math.log10(Math.max(error, 1e-6)) / 6));

function overviewCell(row) {
  if (!row) return make("td", {}, "–");
  if (row.error) return make("td", { class: "error", title: row.error }, "failed");
  const style = `background: color-mix(in srgb, var(--warn) ${Math.round(45 * shadeOf(errorColumn().value(row)))}%, transparent)`;
  const others = numbersLine(qualityColumns().filter(({ role }) => role === "none"), row);
  return make("td", { style, title: others }, errorColumn().text(row));
}

/** The error by method and scene; nothing for a single scene, whose table says it all. */
function overviewSection(rows, scenes) {
  if (scenes.length < 2) return null;
  const names = [...new Set(rows.filter((row) => !row.reference).map((row) => row.name))];
  const find = (name, scene) => rows.find((row) => row.name === name && row.scene === scene.name && !row.reference);
  const head = make("tr", {}, make("th", {}, "Method"), scenes.map((scene) => make("th", {}, scene.name)));
  const body = names.map((name) =>
    make("tr", {}, make("td", {}, name), scenes.map((scene) => overviewCell(find(name, scene)))));
  const lead = `${errorColumn().title} of every method on every scene; the darker, the farther from the reference.`;
  return make("section", { id: "overview" }, make("h2", {}, "Across scenes"), make("p", { class: "lead" }, lead),
              make("div", { class: "wide overview" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}

const errorBounds = [0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001];

/** The row of least cost whose error is within the bound; the reference, which has none, competes. */
function cheapest(rows, bound, cost) {
  const within = rows.filter((row) => !row.error && errorColumn().value(row) <= bound);
  return within.reduce((best, row) => (best && cost.value(best) <= cost.value(row) ? best : row), null);
}

/** Those within the bound whose cost is not told from the best one's. */
function tiedWith(best, rows, bound, cost) {
  const tied = rows.filter((row) => row !== best && !row.error && errorColumn().value(row) <= bound && cost.areTied(row, best));
  return tied.length === 0 ? "" : `; tied: ${tied.map((row) => row.name).join(", ")}`;
}

function choiceRow(rows, scene, bound) {
  const choice = (cost) => {
    const row = cheapest(rows, bound, cost);
    return [make("td", {}, row ? row.name + tiedWith(row, rows, bound, cost) : "none"), make("td", {}, row ? `${cost.textWithInterval(row)} ${cost.unit}` : "")];
  };
  return make("tr", {}, make("td", {}, scene), make("td", {}, `≤ ${bound}`), costColumns().map(choice));
}

/** For a handful of pictures the plots are clearer than a table of choices. */
const fewestChoices = 6;

function choicesSection(rows, scenes) {
  if (new Set(rows.map((row) => row.name)).size < fewestChoices) return null;
  const least = costColumns().flatMap(({ title }) => [`Least ${title.toLowerCase()}`, ""]);
  const head = make("tr", {}, ["Scene", errorColumn().title, ...least].map((text) => make("th", {}, text)));
  const body = scenes.flatMap((scene) => {
    const here = rows.filter((row) => row.scene === scene.name);
    return errorBounds.map((bound) => choiceRow(here, scene.name, bound));
  });
  const lead = "The method of least cost within each bound on the error, and those whose cost is not told from its own.";
  return make("section", { id: "choices" }, make("h2", {}, "What to choose"), make("p", { class: "lead" }, lead),
              make("div", { class: "wide choices" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}
