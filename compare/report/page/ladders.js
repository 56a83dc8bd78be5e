// SPDX-License-Identifier: GPL-3.0-or-later
// The first scene of each ladder, a row of scenes that get harder in one quantity, at which a method breaks.

const ladderCell = (text) => make("td", { class: text !== "holds" && text !== "–" && "error" }, text);

function laddersSection({ ladders: { heads, lines } }) {
  if (lines.length === 0) return null;
  const head = make("tr", {}, ["Method", ...heads].map((text) => make("th", { scope: "col" }, text)));
  const body = lines.map(({ call, cells }) => make("tr", {}, make("td", {}, call.replace(":", ": ")), cells.map(ladderCell)));
  const lead = "Scenes that get harder in one quantity: the first at which a method is beyond the bound, and its number there.";
  return make("section", { id: "ladders" }, make("h2", {}, "Where each method breaks"), make("p", { class: "lead" }, lead),
              make("div", { class: "wide claims" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}
