// SPDX-License-Identifier: GPL-3.0-or-later
// The columns as the program's one table has them: what they are called, how they are written, where they appear.

/** How a number of each style is written, and the axis that it takes. */
const styles = () => ({
  scientific: { write: scientific, axis: { logarithmic: true } },
  similarity: { write: similarity, axis: { zero: false } },
  decibels: { write: decibels, axis: { zero: false } },
  milliseconds: { write: milliseconds, axis: {} },
  plain_milliseconds: { write: (ms) => fixed(ms, 1), axis: {} },
  megabytes: { write: megabytes, axis: {} },
  count: { write: count, axis: {} },
});
/** Upwards or downwards to the best. */
const directions = { lower: 1, higher: -1 };

/** The 95 % interval of a row's number, [low, high]; undefined where it has none. */
const intervalOf = (column, row) => row.intervals?.[column.name];
const intervalText = (interval, write) => (interval ? ` (${write(interval[0])}–${write(interval[1])})` : "");
const overlap = (a, b) => a[0] <= b[1] && b[0] <= a[1];

/** Why times without an interval decide nothing. */
const tooFewTimes = "fewer than five timed pictures";

/** Where a row's number lies: its interval, or itself; undefined for a time without one. */
const placeOf = (column, row) => intervalOf(column, row) ?? (column.timed ? undefined : [column.value(row), column.value(row)]);

/** Whether two rows' numbers are "apart" or "tied"; "undecided" where one of two times has no interval. */
function verdictOf(column, a, b) {
  const one = placeOf(column, a), other = placeOf(column, b);
  if (!one || !other) return "undecided";
  return overlap(one, other) ? "tied" : "apart";
}

/** A column with functions of a row: its value, that in the unit for people, and its text. */
function columnOf(column) {
  const { write, axis } = styles()[column.style];
  const value = (row) => numberOf(row.values?.[column.name]);
  return {
    ...column, axis, value,
    shown: (row) => (value(row) == null ? null : value(row) * column.factor),
    text: (row) => write(value(row)),
    textWithInterval: (row) => write(value(row)) + intervalText(intervalOf(column, row), write),
    direction: directions[column.better],
  };
}

/** A short name: "ms" says enough of a time. */
const labelOf = ({ unit, title }) => unit || title;

const costColumns = () => columns.filter(({ role }) => role === "cost");
const errorColumn = () => columns.find(({ role }) => role === "error");
/** Those below each picture, without the costs. */
const qualityColumns = () => columns.filter(({ card, role }) => card && role !== "cost");

/** "RMSE 1.2·10⁻², SSIM 0.98" */
const numbersLine = (chosen, row) => chosen.map((column) => `${labelOf(column)} ${column.text(row)}`).join(", ");
