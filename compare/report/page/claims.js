// SPDX-License-Identifier: GPL-3.0-or-later
// What the study's source found, held against what was measured here.

function verdict({ against, undecided }) {
  if (against.length > 0) return make("td", { class: "error", title: against.join("\n") }, `otherwise here: ${shortened(against)}`);
  if (undecided.length > 0) return make("td", { title: undecided.join("\n") }, `undecided: ${shortened(undecided)}`);
  return make("td", {}, "the same here");
}

function claimBlock({ text, by, checks }) {
  if (checks.length === 0) return make("div", {}, make("p", {}, text), make("p", { class: "failed" }, "No scene has all of its numbers."));
  const columns = checks[0].values.map(({ of }) => make("th", { scope: "col" }, of.replace(":", ": ")));
  const head = make("tr", {}, make("th", {}, by), make("th", {}), columns);
  const body = checks.map((check) =>
    make("tr", {}, make("td", {}, check.of), verdict(check), check.values.map(({ text: value }) => make("td", {}, value))));
  return make("div", {}, make("p", {}, text),
              make("div", { class: "wide claims" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}

function claimsSection({ claims }) {
  const blocks = claims.map(claimBlock);
  if (blocks.length === 0) return null;
  const lead = "Its orders, the best first, and its bounds, with the numbers measured here.";
  return make("section", { id: "claims" }, make("h2", {}, "What the source found"), make("p", { class: "lead" }, lead),
              make("div", { class: "claim-blocks" }, blocks));
}
