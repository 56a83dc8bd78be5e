// SPDX-License-Identifier: GPL-3.0-or-later
// A card per method: picture, zoom-in and error map, its numbers below. A click flips the picture
// and its zoom-in to the reference and back.

const pictureOf = ({ width, height }, source, alt) => distantImage(source, { alt, width, height });

/** The crop of `scene` shown over the whole width of its frame, pixels as squares. */
function zoomIn(scene, source, title) {
  const [x, y, width, height] = scene.crop;
  const image = distantImage(source, { alt: title });
  image.style.width = `${(100 * scene.width) / width}%`;
  image.style.left = `${(-100 * x) / width}%`;
  image.style.top = `${(-100 * y) / height}%`;
  return image;
}

function cropBox(scene) {
  const [x, y, width, height] = scene.crop;
  const box = make("span", { class: "crop" });
  box.style.left = `${(100 * x) / scene.width}%`;
  box.style.top = `${(100 * y) / scene.height}%`;
  box.style.width = `${(100 * width) / scene.width}%`;
  box.style.height = `${(100 * height) / scene.height}%`;
  return box;
}

function numbers(row) {
  const entries = [...qualityColumns(), ...costColumns().filter(({ card }) => card)];
  const cells = entries.map((column) => make("div", {}, make("dt", {}, labelOf(column)), make("dd", {}, column.text(row))));
  return make("dl", { class: "numbers" }, cells);
}

/** For exact methods, and those that make layers of their own: where the numbers of layers differ, and the error where they don't. */
function coverageNote(row) {
  if (!row.coverage) return null;
  const { layers_differ, layers_differ_by_more, pixels, rmse_equal_layers } = row.coverage;
  return make("p", { class: "note" }, `Layers differ in ${count(layers_differ)} pixels ` +
    `(${percent(layers_differ / pixels)}), by more than 1 in ${count(layers_differ_by_more)}; RMSE over the others ${scientific(rmse_equal_layers)}.`);
}

function droppedNote(row) {
  if (!row.dropped) return null;
  return make("p", { class: "note" }, `${count(row.dropped)} fragments of ${count(row.truncated_pixels)} pixels did not reach the picture.`);
}

function failedCard(row) {
  const why = make("div", { class: "failed" }, row.error);
  return make("figure", { class: "card" }, why, make("figcaption", {}, caption(row)));
}

function caption(row, enlarge) {
  return make("header", {}, make("h3", { title: row.title }, row.method),
    make("span", { class: "parameters" }, row.reference ? "reference" : row.given ? "given" : spaced(row.parameters)),
    viewText(row) && make("span", { class: "parameters" }, viewText(row)), enlarge);
}

/** One picture's frame; flipping sets its source. */
function flippable(row, reference, image, extra, onclick) {
  const label = row.reference ? "Reference" : `Flip ${row.name} and the reference`;
  const frame = make("button", { class: "frame", type: "button", "aria-label": label, onclick }, image,
                     make("span", { class: "badge" }, "reference"), extra);
  return { frame, show: (flipped) => changeSource(image, flipped ? reference.picture : row.picture) };
}

function pictureCard(scene, row, reference, enlarge) {
  const card = make("figure", { class: "card" });
  const views = [];
  const flip = (on = !card.classList.contains("flipped")) => {
    if (row.reference) return;
    card.classList.toggle("flipped", on);
    for (const view of views) view.show(on);
  };
  const whole = pictureOf(scene, row.picture, row.name);
  const maps = row.reference ? make("div", { class: "scales" }, errorLegend(data.error_scale), flipLegend(data.error_scale))
    : [mapOf(scene, row, "error", enlarge), row.flip_map && mapOf(scene, row, "flip", enlarge)];
  const closer = zoomIn(scene, row.picture, `${row.name}, zoomed in`);
  views.push(flippable(row, reference, whole, cropBox(scene), () => flip()),
             flippable(row, reference, closer, null, () => flip()));
  views[0].frame.style.aspectRatio = `${scene.width} / ${scene.height}`;
  const zoom = views[1].frame;
  zoom.classList.add("zoom");
  zoom.style.aspectRatio = `${scene.crop[2]} / ${scene.crop[3]}`;
  const open = make("button", { class: "enlarge", type: "button", "aria-label": `Enlarge ${row.name}`, onclick: () => enlarge(row) }, "enlarge");
  const pair = make("div", { class: "pair" }, make("div", {}, zoom, make("small", {}, "zoom-in")), maps);
  const notes = [numbers(row), coverageNote(row), droppedNote(row)];
  card.append(views[0].frame, pair, ...furtherPictures(scene, row), make("figcaption", {}, caption(row, open), notes));
  whenNear(card, () => showImages(card));
  return { card, flip };
}

/** The maps of a picture's error: where the row has them, and what they are called. */
const errorMaps = {
  error: { source: (row) => row.error_map, title: "error" },
  flip: { source: (row) => row.flip_map, title: "FLIP" },
};

function mapOf(scene, row, what, enlarge) {
  const { source, title } = errorMaps[what];
  const image = pictureOf(scene, source(row), `${title} of ${row.name}`);
  const label = `Enlarge the ${title} of ${row.name}`;
  const onclick = () => enlarge(row, what);
  const frame = make("button", { class: "frame", type: "button", "aria-label": label, onclick }, image);
  frame.style.aspectRatio = `${scene.crop[2]} / ${scene.crop[3]}`;
  return make("div", {}, frame, make("small", {}, title));
}

/** The scales that all maps of error share stand where the reference's own maps would. */
const errorLegend = (scale) => logarithmicScale(scale, "error maps: the largest error of red, green and blue");

function flipLegend({ colors }) {
  const ticks = [0, 0.25, 0.5, 0.75, 1];
  return colorScale(colors, ticks.map((at) => [at, String(at)]), "FLIP maps: the difference seen when the pictures alternate");
}

function logarithmicScale({ min, max, colors }, text) {
  const decades = Math.round(Math.log10(max / min));
  const ticks = Array.from({ length: decades + 1 }, (_, i) => [i / decades, String(Number((min * 10 ** i).toPrecision(2)))]);
  return colorScale(colors, ticks, text);
}

/** A bar of colours; ticks are [share of its length, text]. */
function colorScale(colors, ticks, text) {
  const bar = make("div", { class: "bar" });
  bar.style.background = `linear-gradient(to right, ${colors.join(", ")})`;
  for (const [at, label] of ticks) {
    const tick = make("span", {}, label);
    tick.style.left = `${100 * at}%`;
    bar.append(tick);
  }
  return make("div", { class: "scale" }, make("small", {}, text), bar);
}
