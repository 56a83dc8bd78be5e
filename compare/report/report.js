// Puts the page together from the data that the program has inserted.

const data = JSON.parse(document.getElementById("data").textContent);
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
  const lead = `${counted(scenes, "scene")} × ${counted(methods, "method")}, each picture measured against ${reference}` +
    (machine.cpu ? `; on ${machine.cpu}, ${counted(machine.cores, "core")}.` : ".");
  return [make("h1", {}, data.study.title), data.study.source && make("p", { class: "source" }, data.study.source), make("p", { class: "lead" }, lead),
          failed > 0 && make("p", { class: "failed" }, `${failed} of the cells failed; the table says why.`)].filter(Boolean);
}

function sceneLead(scene, reference) {
  const pixels = scene.width * scene.height;
  return `${scene.width} × ${scene.height} pixels, ${(reference.fragments / pixels).toPrecision(3)} layers per pixel on average, ` +
    `${count(reference.max_layers)} at most. The frame in each picture marks its zoom-in.`;
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
  return make("section", { id: `scene-${scene.name}` }, make("h2", {}, scene.name), make("p", { class: "lead" }, sceneLead(scene, done[0])),
              make("div", { class: "cards" }, cards), plots);
}

function navigation() {
  const links = data.scenes.map((scene) => [`scene-${scene.name}`, scene.name]).concat([["table", "All numbers"], ["provenance", "Provenance"]]);
  return make("div", {}, links.map(([id, text]) => make("a", { href: `#${id}` }, text)),
              make("span", { class: "keys" }, "click a picture, or ", make("kbd", {}, "F"), " for all: flip to the reference"));
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
document.getElementById("nav").append(navigation());
document.getElementById("main").append(
  ...data.scenes.map(sceneSection),
  make("section", { id: "table" }, make("h2", {}, "All numbers"),
       make("p", { class: "lead" }, "A click on a head sorts. The best of each scene, the reference left out, is in colour."), sortableTable(data.rows)),
  provenanceSection(data));
redraw();

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
let resizing = 0;
addEventListener("resize", () => {
  clearTimeout(resizing);
  resizing = setTimeout(redraw, 150);
});
addEventListener("keydown", (event) => {
  if (event.key.toLowerCase() === "f" && !event.ctrlKey && !event.metaKey && !event.altKey && !viewer.dialog.open) flipAll();
});
