// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows the table shows: words of their names, and bounds on their numbers, "rmse<0.01 time<=5".

const comparisons = { "<": (a, b) => a < b, "<=": (a, b) => a <= b, ">": (a, b) => a > b, ">=": (a, b) => a >= b, "=": (a, b) => a === b };

/** The column that a word names, by its name, title or unit without spaces: "ms", "rmse_covered", "psnr". */
function columnCalled(word) {
  const plain = (text) => text.toLowerCase().replace(/[\s,]+/g, "");
  return columns.find((column) => [column.name, column.title, column.unit].some((name) => name && plain(name) === plain(word)));
}

/** A function of a row: whether a number is within the bound, in the unit that the head of the column has. Null where the word is no bound. */
function boundOf(word) {
  const [, name, sign, number] = word.match(/^([^<>=]+)(<=|>=|<|>|=)([-+\d.e]+)$/) ?? [];
  const column = name && columnCalled(name);
  if (!column || Number.isNaN(Number(number))) return null;
  return (row) => !row.error && isKnown(column.shown(row)) && comparisons[sign](column.shown(row), Number(number));
}

/** A function of a row: whether all words hold, which a name has, or which bound a number. */
function filterOf(text) {
  const tests = text.toLowerCase().split(/\s+/).filter(Boolean).map((word) =>
    boundOf(word) ?? ((row) => nameColumns.some((column) => column.text(row).toLowerCase().includes(word))));
  return (row) => tests.every((test) => test(row));
}
