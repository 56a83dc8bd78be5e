// SPDX-License-Identifier: GPL-3.0-or-later
// The page on paper: what waits is made, and tables wider than a sheet are split into groups of columns, each with the names before it.

/** Pixels between the margins of an A4 sheet: 210 mm less 2 × 12 mm, at 96 to the inch; letter paper is wider. */
const sheetWidth = Math.floor((186 / 25.4) * 96);

const total = (list) => list.reduce((sum, x) => sum + x, 0);

/** [first, end] of groups of columns that fit beside the first `names` columns; a column wider than the sheet is a group. */
function columnGroups(widths, names, most) {
  const room = most - total(widths.slice(0, names)), groups = [];
  for (let first = names, end; first < widths.length; first = end) {
    end = first + 1;
    while (end < widths.length && total(widths.slice(first, end + 1)) <= room) ++end;
    groups.push([first, end]);
  }
  return groups;
}

/** A row's names and the columns of a group; a cell over all columns stays whole. */
function groupRow(row, names, [first, end]) {
  const cells = [...row.cells].filter((cell, i) => i < names || cell.colSpan > 1 || (i >= first && i < end));
  const copy = row.cloneNode(false);
  copy.append(...cells.map((cell) => cell.cloneNode(true)));
  for (const cell of copy.cells) if (cell.colSpan > 1) cell.colSpan = end - first;
  for (const button of copy.querySelectorAll("button")) button.replaceWith(button.textContent); // heads with buttons are not repeated on further sheets
  return copy;
}

function groupTable(table, names, group) {
  const copy = table.cloneNode(false);
  for (const part of table.children) {
    const same = part.cloneNode(false);
    same.append(...[...part.rows].map((row) => groupRow(row, names, group)));
    copy.append(same);
  }
  return copy;
}

/** How many columns name a row: the table's own columns are not to be read without them. */
const nameCount = (holder) => (holder.matches(".overview, .budget, .measures, .metric-card") ? 1 : 2);

/** Puts a copy in groups of columns beside a table that is too wide. */
function splitTable(holder) {
  const [table] = holder.children;
  const names = nameCount(holder), widthsOf = () => [...table.rows[0].cells].map((cell) => cell.getBoundingClientRect().width);
  const nameWidth = total(widthsOf().slice(0, names));
  holder.classList.toggle("long", nameWidth > sheetWidth / 2); // names are not broken unless they take the others' room
  const widths = widthsOf();
  if (total(widths) <= sheetWidth) return;
  const groups = columnGroups(widths, names, sheetWidth).map((group) => groupTable(table, names, group));
  holder.after(make("div", { class: `${holder.className} groups` }, groups));
  holder.classList.add("split");
}

function preparePrint() {
  document.documentElement.classList.add("printing");
  redraw();
  makeAll();
  for (const details of document.querySelectorAll("details:not([open])")) Object.assign(details, { open: true, className: "closed" });
  for (const holder of document.querySelectorAll(".wide")) splitTable(holder);
}

function endPrint() {
  for (const copy of document.querySelectorAll(".groups")) copy.remove();
  for (const holder of document.querySelectorAll(".split")) holder.classList.remove("split");
  for (const details of document.querySelectorAll("details.closed")) Object.assign(details, { open: false, className: "" });
  document.documentElement.classList.remove("printing");
  redraw();
}

addEventListener("beforeprint", preparePrint);
addEventListener("afterprint", endPrint);
