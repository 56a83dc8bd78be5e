// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of every view, a line for each method: from where does it err most?

/** The error of each view of a row; empty where there is one view. */
const viewErrors = (row) => row.curves?.find(({ name }) => name === `${errorColumn().title} over the views`)?.y.map(numberOf) ?? [];

function viewPicture(row, source, view, error, isWorst) {
  const text = row.reference ? `view ${view + 1}` : `${errorColumn().title} ${scientific(error)}${isWorst ? ", worst" : ""}`;
  const what = row.reference ? `${row.name} from view ${view + 1}` : `error of ${row.name} from view ${view + 1}: ${text}`;
  const image = source ? make("img", { src: source, alt: what, loading: "lazy" }) : "–";
  return make("td", { class: isWorst && "worst" }, make("figure", {}, image, make("figcaption", {}, text)));
}

function viewLine(row) {
  const errors = viewErrors(row), worst = row.reference ? -1 : errors.indexOf(Math.max(...errors));
  const isApart = errors.some((error) => error !== errors[worst]);
  const cells = row.view_pictures.map((source, view) => viewPicture(row, source, view, errors[view], isApart && view === worst));
  return make("tr", {}, make("th", { scope: "row" }, row.method, make("br"), make("small", {}, row.reference ? "reference" : spaced(row.parameters))), cells);
}

/** Of a scene's rows, the reference first; null of one view. */
function viewsTable(rows) {
  const shown = rows.filter((row) => row.view_pictures?.length > 1);
  if (shown.length > 0) {
    const lead = "The reference from each view, then each method's error map; the view from which it errs most is framed.";
    return make("div", { class: "views" }, make("h3", {}, "Views"), make("p", { class: "lead" }, lead),
                make("div", { class: "wide" }, make("table", {}, make("tbody", {}, shown.map(viewLine)))));
  }
  return viewCount(rows[0]) > 1 ? make("p", { class: "note" }, "Of the other views there are too many pictures for one file: a report in a folder, --report folder, has them.") : null;
}
