// SPDX-License-Identifier: GPL-3.0-or-later
// Where each picture's error comes from: a bar for each stage, signed, which add up to the whole.

const shareText = (share) => `${(100 * share).toFixed(1)} %`;

/** A bar from 0 to the share, and a thin line from its part when refined first to that when refined last. */
function shareBar({ share, first, last }, low, high) {
  const at = (x) => (100 * (x - low)) / (high - low);
  const span = (a, b) => `left:${at(Math.min(a, b))}%;width:${at(Math.max(a, b)) - at(Math.min(a, b))}%`;
  return make("td", { class: "share-bar" },
              make("div", {}, make("i", { style: span(0, share), class: share < 0 && "less" }),
                   first != null && make("b", { style: span(first, last) })));
}

const secondsText = (seconds) => seconds == null ? "undecided" : `${seconds < 0 ? "−" : ""}${fixed(Math.abs(seconds), 2)}`;

/** What a gain costs, where the times are told apart. */
function priceText({ gain, seconds }) {
  if (seconds == null) return "undecided";
  return seconds > 0 ? scientific(gain / seconds) : "free";
}

function budgetTable(budget) {
  const applying = budget.stages.filter((stage) => !stage.why_not);
  const ends = [0, budget.interaction, ...applying.flatMap(({ share, first, last }) => [share, first, last])];
  const low = Math.min(...ends), high = Math.max(...ends);
  const bars = applying.map((stage) =>
    make("tr", { title: `refined to ${stage.refinement}` }, make("td", {}, stage.title), shareBar(stage, low, high),
         [shareText(stage.share), scientific(stage.gain), secondsText(stage.seconds), priceText(stage)].map((text) => make("td", {}, text))));
  const rest = make("tr", {}, make("td", {}, "Interaction of three or more"), shareBar({ share: budget.interaction }, low, high),
                    make("td", {}, shareText(budget.interaction)), make("td", {}), make("td", {}), make("td", {}));
  const head = make("tr", {}, ["Stage", "Share of the error", "", "Gain in RMSE", "More [s]", "Gain per s"].map((text) => make("th", { scope: "col" }, text)));
  return make("div", { class: "wide budget" }, make("table", {}, make("thead", {}, head), make("tbody", {}, bars, rest)));
}

function rowBudget(row) {
  const absent = row.budget.stages.filter((stage) => stage.why_not).map((stage) => `${stage.title}: ${stage.why_not}`);
  return make("div", {}, make("h3", {}, row.name),
              make("p", { class: "note" }, `RMSE ${scientific(row.budget.rmse)} against all stages refined; ${secondsText(row.budget.seconds)} s as drawn.`),
              budgetTable(row.budget), absent.length > 0 && make("p", { class: "note" }, `Not here: ${absent.join("; ")}.`));
}

/** Nothing where no row of the scene has a budget. */
function budgetSection(rows) {
  const split = rows.filter((row) => row.budget);
  if (split.length === 0) return null;
  const lead = "The whole error, projected onto itself, is 100 %; each stage's bar is its part, the thin line its part when it is refined first and last. " +
    "The largest gain per second is the knob to turn first; it is undecided where the intervals of the times before and after overlap, or one has none.";
  return make("div", {}, make("h3", {}, "Where the error comes from"), make("p", { class: "lead" }, lead), split.map(rowBudget));
}
