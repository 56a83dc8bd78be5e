// SPDX-License-Identifier: GPL-3.0-or-later
// What the study's source found, held against what was measured here.

function verdict({ against }) {
  if (against.length === 0) return make("td", {}, "the same here");
  const pairs = against.map(([better, worse]) => `${worse} before ${better}`);
  const shown = pairs.length > 3 ? [...pairs.slice(0, 3), `${pairs.length - 3} more`] : pairs;
  return make("td", { class: "error", title: pairs.join("\n") }, `otherwise here: ${shown.join("; ")}`);
}

function claimBlock({ text, by, checks }) {
  if (checks.length === 0) return null;
  const calls = checks[0].values.map(({ call }) => make("th", { scope: "col" }, call.replace(":", ": ")));
  const head = make("tr", {}, make("th", {}, by), make("th", {}), calls);
  const body = checks.map((check) =>
    make("tr", {}, make("td", {}, check.scene), verdict(check), check.values.map(({ text: value }) => make("td", {}, value))));
  return make("div", {}, make("p", {}, text),
              make("div", { class: "wide claims" }, make("table", {}, make("thead", {}, head), make("tbody", {}, body))));
}

function claimsSection({ claims }) {
  const blocks = claims.map(claimBlock).filter(Boolean);
  if (blocks.length === 0) return null;
  const lead = "Its order of the methods, the best first, and the numbers measured here.";
  return make("section", { id: "claims" }, make("h2", {}, "What the source found"), make("p", { class: "lead" }, lead), blocks);
}
