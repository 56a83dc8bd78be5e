// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as it is kept: SVG for a paper, and its numbers as CSV.

/** On white paper, whatever the screen's theme. */
const paperColors = { ink: "#1d1f22", soft: "#404449", faint: "#8b9097", line: "#dfe0dc", accent: "#1f6f8b", paper: "#ffffff" };

function saveFile(name, blob) {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Quoted where it has to be; what a spreadsheet would take for a formula gets an apostrophe. */
function csvField(value) {
  const text = typeof value === "string" && /^[=+\-@\t\r]/.test(value) ? `'${value}` : String(value ?? "");
  return /[,"\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Lines of fields: the numbers of a plot, with all their digits, below what they are called. */
const csvText = (lines) => lines.map((line) => line.map(csvField).join(",") + "\n").join("");

const plotSvg = (spec) => new vega.View(vega.parse(spec), { renderer: "none" }).toSVG();

/** Buttons that save a plot; `spec` is a function of its width and colours, `width` of nothing. */
function plotButtons(title, spec, width) {
  const name = title.replace(/[^\w.=-]+/g, "-");
  const paperSpec = () => spec(width(), paperColors);
  const button = (kind, act) => make("button", { type: "button", title: `Save this plot as ${kind}`, onclick: act }, kind);
  return make("span", { class: "saves" },
    button("SVG", async () => saveFile(`${name}.svg`, new Blob([await plotSvg(paperSpec())], { type: "image/svg+xml" }))),
    button("CSV", () => saveFile(`${name}.csv`, new Blob([csvText(paperSpec().usermeta.csv)], { type: "text/csv" }))));
}
