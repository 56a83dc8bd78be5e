// SPDX-License-Identifier: GPL-3.0-or-later
// What only shows across scenes: every method's error on each of them, and the cheapest method within an error bound.

/** From transparent at 1e-6 to full at 1: how dark a cell of the overview is. */
const shadeOf = (error) => Math.min(1, Math.max(0, 1 + Math.log10(Math.max(error, 1e-6)) / 6));

function overviewCell(row) {
  if (!row) return make("td", {}, "–");
  if (row.error) return make("td", { class: "error", title: row.error }, "failed");
  if (!isKnown(errorColumn().value(row))) return make("td", {}, errorColumn().text(row));
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

/** The best one, those that are not told from it, and those of which nothing is known. */
function choiceText(best, known, unknown, cost) {
  const names = (verdict) => known.filter((row) => row !== best && verdictOf(cost, row, best) === verdict).map((row) => row.name);
  const parts = { tied: names("tied"), [`not told apart (${tooFewTimes})`]: names("undecided"), [`of unknown ${cost.title.toLowerCase()}`]: unknown };
  const said = Object.entries(parts).filter(([, of]) => of.length > 0).map(([what, of]) => `${what}: ${shortened(of, ", ")}`);
  return [best?.name ?? "none", ...said].join("; ");
}

/** Within the bound on the error the row of least cost; the reference, which has none, competes. */
function choice(rows, bound, cost) {
  const within = rows.filter((row) => !row.error && isWithin(errorColumn().value(row), bound));
  const known = ranked(within, cost.value), unknown = within.filter((row) => !known.includes(row)).map((row) => row.name);
  const [best] = known;
  return [choiceText(best, known, unknown, cost), best ? `${cost.textWithInterval(best)} ${cost.unit}` : ""];
}

/** A scene's choices, the same of neighbouring bounds as one. */
function choicesOf(rows) {
  const choices = [];
  for (const bound of errorBounds) {
    const texts = costColumns().flatMap((cost) => choice(rows, bound, cost));
    const last = choices.at(-1);
    if (last && texts.every((text, i) => text === last.texts[i])) last.bounds.push(bound);
    else choices.push({ bounds: [bound], texts });
  }
  return choices;
}

const boundsText = (bounds) => `≤ ${bounds.length > 1 ? `${bounds.at(0)} … ${bounds.at(-1)}` : bounds[0]}`;

function choiceRows(rows, scene) {
  return choicesOf(rows).map(({ bounds, texts }, i) =>
    make("tr", {}, make("td", {}, i === 0 ? scene : ""), make("td", {}, boundsText(bounds)), texts.map((text) => make("td", {}, text))));
}

/** Of how many views the numbers are, which limits what they say. */
function viewsLead(rows) {
  const views = Math.max(...rows.map(viewCount));
  return views > 1 ? ` Errors and times are means over ${views} views of each scene.` : " Each scene is seen from one side: \"views\" in a study tell how far another one changes the answer.";
}

/** For a handful of pictures the plots are clearer than a table of choices. */
const fewestChoices = 6;

function choicesSection(rows, scenes) {
  if (new Set(rows.map((row) => row.name)).size < fewestChoices) return null;
  const least = costColumns().flatMap(({ title }) => [`Least ${title.toLowerCase()}`, ""]);
  const head = make("tr", {}, ["Scene", errorColumn().title, ...least].map((text) => make("th", {}, text)));
  const body = scenes.flatMap((scene) => choiceRows(rows.filter((row) => row.scene === scene.name), scene.name));
  const lead = `The method of least cost within each bound on the error; tied with it are those of the same cost, or whose 95 % intervals overlap. Times of ${tooFewTimes} have no interval, and decide nothing.${viewsLead(rows.filter((row) => !row.error))}`;
  return make("section", { id: "choices" }, make("h2", {}, "What to choose"), make("p", { class: "lead" }, lead),
              make("div", { class: "wide choices" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}
