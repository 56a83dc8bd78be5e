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

function sceneFacts(rows) {
  const known = rows.filter((row) => row.reference && row.scene_provenance);
  return known.map((row) => [make("h3", {}, row.scene), facts(Object.entries(row.scene_provenance))]);
}

const measures = `Times are medians of wall-clock seconds around finished work, after one warm-up. Memory is
what a method allocates beyond the scene's geometry and the final picture. Numbers of error and similarity are of the
float pictures unless they say "8 bits".`;

function provenanceSection(data) {
  return make("section", { id: "provenance" },
    make("h2", {}, "Provenance"),
    make("h3", {}, "Methods"), methodFacts(data.methods),
    make("h3", {}, "Numbers"), metricFacts(data.metrics),
    sceneFacts(data.rows),
    make("h3", {}, "Machine"), machineFacts(data.rows),
    make("p", { class: "note" }, measures));
}
