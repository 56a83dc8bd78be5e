// SPDX-License-Identifier: GPL-3.0-or-later
// Where the numbers come from: methods and papers, scenes, machine.

function facts(entries) {
  return make("dl", { class: "facts" }, entries.map(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]));
}

function methodFacts(methods) {
  return facts(Object.entries(methods).map(([name, method]) => {
    const parts = [method.title, method.citation, method.equations && `equations: ${method.equations}`,
                   method.bytes_per_pixel && `bytes per pixel: ${method.bytes_per_pixel}`, method.exact && "exact"];
    return [name, parts.filter(Boolean).join(" · ")];
  }));
}

function metricFacts(metrics) {
  return facts(metrics.map(({ symbol, title, definition, citation }) =>
    [symbol, [title, definition, citation].filter(Boolean).join(" · ")]));
}

/** What went into each number: two of one name can be compared only if these agree. */
function metricCard(metrics) {
  const line = ({ symbol, space, channels, window }) =>
    make("tr", {}, [symbol, space, channels, window].map((text) => make("td", {}, text)));
  const head = ["", "Values", "Channels", "Window"].map((text) => make("th", { scope: "col" }, text));
  return make("div", { class: "wide metric-card" },
    make("table", {}, make("thead", {}, make("tr", {}, head)), make("tbody", {}, metrics.map(line))));
}

const metricNote = `Values are display values in [0, 1], blended as they stand. "Covered" pixels have a layer in the
reference; "equal layers" are pixels with as many layers as there. Numbers of maps (SSIM, FLIP) are the map's mean over
them; SSIM knows only pixels whose window lies inside. Pixels beyond FLIP's edge are as the nearest one.`;

/** Each fact once; where cells differ, all its values. */
function machineFacts(rows) {
  const values = new Map();
  for (const row of rows)
    for (const [name, value] of Object.entries(row.machine ?? {})) {
      if (!values.has(name)) values.set(name, new Set());
      values.get(name).add(value);
    }
  return facts([...values].map(([name, set]) => [name.replaceAll("_", " "), [...set].join("; ")]));
}

/** With the camera of view 1 as --camera takes it. */
function sceneFacts({ rows, scenes }) {
  const known = rows.filter((row) => row.reference && row.scene_provenance);
  const camera = (row) => scenes.find(({ name }) => name === row.scene)?.camera;
  return known.map((row) => [make("h3", {}, row.scene), facts([...Object.entries(row.scene_provenance), ...(camera(row) ? [["--camera", camera(row)]] : [])])]);
}

/** The texts of the study and its scenes, as they were. */
const inputTexts = (inputs) => inputs.map(({ file, text }) =>
  make("details", {}, make("summary", {}, file), make("pre", { tabindex: 0 }, text)));

/** Each file that some cell has read, with the hash of its content; several where it has changed between cells. */
function fileFacts(rows) {
  const hashes = new Map();
  for (const [file, hash] of rows.flatMap((row) => Object.entries(row.files_read ?? {}))) hashes.set(file, (hashes.get(file) ?? new Set()).add(hash));
  return facts([...hashes].map(([file, set]) => [file, [...set].join("; ")]));
}

/** When the first and last cell were measured: the machine's speed is looked at around each of them. */
function measuredFacts(rows) {
  const times = rows.flatMap((row) => row.seconds?.calibrations ?? []).map(({ at }) => at);
  if (times.length === 0) return null;
  const date = (seconds) => `${new Date(seconds * 1000).toISOString().slice(0, 19).replace("T", " ")} UTC`;
  const ends = [Math.min(...times), Math.max(...times)].map(date);
  return facts([["measured", [...new Set(ends)].join(" to ")]]);
}

const measures = `Times are medians of wall-clock seconds around finished work, after one warm-up. Memory is
what a method allocates beyond the scene's geometry and the final picture. Numbers of error and similarity are of the
float pictures unless they say "8 bits".`;

function provenanceSection(data) {
  return make("section", { id: "provenance" },
    make("h2", {}, "Provenance"),
    make("h3", {}, "Methods"), methodFacts(data.methods),
    make("h3", {}, "Numbers"), metricCard(data.metrics), make("p", { class: "note" }, metricNote),
    metricFacts(data.metrics),
    make("h3", {}, "Study and scenes"), inputTexts(data.inputs), fileFacts(data.rows),
    sceneFacts(data),
    make("h3", {}, "Machine"), measuredFacts(data.rows), machineFacts(data.rows),
    data.command && facts([["command", data.command]]),
    make("p", { class: "note" }, measures));
}
