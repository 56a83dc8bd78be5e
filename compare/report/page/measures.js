// SPDX-License-Identifier: GPL-3.0-or-later
// What only some methods can say of their own work: numbers, and pictures with a scale of their own.

/** Whole numbers in full, others to four digits; very small and large ones as 1.23·10⁻⁵. */
function measured(x) {
  if (x == null) return "–";
  if (Math.abs(x) === Infinity) return x > 0 ? "∞" : "−∞";
  if (Number.isInteger(x)) return count(x);
  return Math.abs(x) >= 1e-3 && Math.abs(x) < 1e6 ? String(Number(x.toPrecision(4))) : scientific(x);
}

/** The measures of all rows, each once. */
function measureKinds(rows) {
  const kinds = new Map();
  for (const measure of rows.flatMap((row) => row.measures ?? [])) if (!kinds.has(measure.name)) kinds.set(measure.name, measure);
  return [...kinds.values()];
}

/** Over how many views the numbers of a row are means. */
const viewCount = (row) => row.measures?.find(({ name }) => name === "views")?.value ?? 1;

/** Of which view a row's pictures are, where there are several. */
const viewText = (row) => (viewCount(row) > 1 ? `view 1 of ${viewCount(row)}` : "");

function bestMeasure({ better }, values) {
  if (better === "neither") return null;
  const known = values.filter((value) => value != null);
  return better === "lower" ? Math.min(...known) : Math.max(...known);
}

/** A line for each number, a column for each method; nothing where no method has any. */
function measuresTable(rows) {
  const methods = rows.filter((row) => row.measures?.length > 0);
  if (methods.length === 0) return null;
  const head = make("tr", {}, make("th", {}), methods.map((row) => make("th", { scope: "col" }, row.method, make("br"), make("small", {}, spaced(row.parameters)))));
  const body = measureKinds(methods).map((kind) => {
    // A measure that is there without a number is infinite: so earlier builds wrote it.
    const values = methods.map((row) => row.measures.find(({ name }) => name === kind.name)).map((measure) => measure && (numberOf(measure.value) ?? Infinity));
    const best = bestMeasure(kind, values);
    const title = kind.unit ? `${kind.title} [${kind.unit}]` : kind.title;
    return make("tr", {}, make("td", {}, title),
                values.map((value) => make("td", { class: value != null && value === best && "best" }, measured(value))));
  });
  return make("div", { class: "wide measures" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body)));
}

/** A method's further pictures, each above its scale. */
function furtherPictures(scene, row) {
  return (row.pictures ?? []).map((picture) =>
    make("div", { class: "further" },
         make("div", { class: "frame" }, pictureOf(scene, picture.source, `${picture.title}, ${row.name}`)),
         logarithmicScale({ ...picture, colors: data.error_scale.colors }, picture.title)));
}
