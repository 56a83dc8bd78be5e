// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together from the data that the program has inserted.

const data = JSON.parse(document.getElementById("data").textContent);
data.rows.forEach((row, place) => { row.place = place; });
const columns = data.columns.map(columnOf);
const viewer = new Viewer(document.getElementById("viewer"));
const flips = [];   // one per picture card
const redraws = []; // one per scene's plots

const counted = (n, noun) => `${n} ${noun}${Number(n) === 1 ? "" : "s"}`;

function headSection() {
  const scenes = new Set(data.rows.map((row) => row.scene)).size;
  const reference = data.rows.find((row) => row.reference)?.name ?? "none";
  const failed = data.rows.filter((row) => row.error).length;
  const machine = data.rows.find((row) => !row.error)?.machine ?? {};
  const methods = new Set(data.rows.filter((row) => !row.reference).map((row) => row.name)).size;
  const size = `${counted(scenes, "scene")} × ${counted(methods, "method")}`;
  const where = machine.cpu ? `; on ${machine.cpu}, ${counted(machine.cores, "core")}` : "";
  const opacities = data.study.opacities;
  const composited = opacities ? ` All composite the opacities of least energy that ${opacities} finds.` : "";
  const lead = `${size}, each picture measured against ${reference}${where}.${composited}`;
  const parts = [
    make("h1", {}, data.study.title),
    data.study.source && make("p", { class: "source" }, data.study.source),
    make("p", { class: "lead" }, lead),
    ...data.study.notes.map((note) => make("p", { class: "note" }, note.replaceAll("`", ""))),
    ...data.warnings.map((warning) => make("p", { class: "failed", role: "alert" }, warning.replaceAll("`", ""))),
    failed > 0 && make("p", { class: "failed" }, `${counted(failed, "cell")} failed; the table says why.`),
  ];
  return parts.filter(Boolean);
}

function sceneLead(scene, reference) {
  const pixels = scene.width * scene.height;
  const average = (reference.fragments / pixels).toPrecision(3);
  return `${scene.width} × ${scene.height} pixels, ${average} layers per pixel on average, ` +
    `${count(reference.max_layers)} at most. The frame in each picture marks its zoom-in.` +
    (viewCount(reference) > 1 ? ` Pictures, their maps and single pixels are of ${viewText(reference)}; numbers are means over the views, but for those that say otherwise.` : "");
}

function sceneSection(scene) {
  const rows = data.rows.filter((row) => row.scene === scene.name);
  const done = rows.filter((row) => !row.error);
  const cards = rows.map((row) => {
    if (row.error) return failedCard(row);
    const { card, flip } = pictureCard(scene, row, done[0], (chosen, what) => viewer.open(done, chosen, what));
    flips.push(flip);
    return card;
  });
  const plots = make("div", { class: "plots" });
  redraws.push(plotsOf(done, plots));
  const lead = make("p", { class: "lead" }, sceneLead(scene, done[0]));
  return make("section", { id: `scene-${scene.name}` }, make("h2", {}, scene.name), lead,
              make("div", { class: "cards" }, cards), viewsTable(done), measuresTable(done), budgetSection(done), plots);
}

function navigation(sections) {
  const links = sections.map((section) => [section.id, section.querySelector("h2").textContent]);
  const keys = ["click a picture, or ", make("kbd", {}, "F"), " for all: flip to the reference"];
  return make("div", {}, links.map(([id, text]) => make("a", { href: `#${id}` }, text)),
              make("span", { class: "keys" }, keys));
}

let allFlipped = false;
function flipAll() {
  allFlipped = !allFlipped;
  for (const flip of flips) flip(allFlipped);
}

function redraw() {
  for (const draw of redraws) draw();
}

document.getElementById("head").append(...headSection());
const sections = [
  claimsSection(data), laddersSection(data), growthSection(data), costsSection(data),
  choicesSection(data.rows, data.scenes), overviewSection(data.rows, data.scenes), ...data.scenes.map(sceneSection),
  tableSection(data.rows), provenanceSection(data),
].filter(Boolean);
document.getElementById("nav").append(navigation(sections));
document.getElementById("main").append(...sections);
redraw();

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
let resizing = 0;
addEventListener("resize", () => {
  clearTimeout(resizing);
  resizing = setTimeout(redraw, 150);
});
addEventListener("keydown", (event) => {
  const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
  if (event.key.toLowerCase() === "f" && plain && !viewer.dialog.open) flipAll();
});
