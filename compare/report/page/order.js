// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of which some are not known. To JavaScript null is 0 in every comparison and sum; here it is no number.

const isKnown = (x) => x != null && !Number.isNaN(x);

/** Orders numbers by size and names by the alphabet, downwards where the direction is -1; what is not known comes last either way. */
function compareKnown(a, b, direction = 1) {
  if (!isKnown(a) || !isKnown(b)) return isKnown(b) - isKnown(a);
  return direction * (typeof a === "string" ? a.localeCompare(b) : a - b);
}

/** Whether a number is known and at most the bound. */
const isWithin = (x, bound) => isKnown(x) && x <= bound;

/** Those whose number is known, from the smallest on, or downwards where the direction is -1. */
const ranked = (items, value, direction = 1) =>
  items.filter((item) => isKnown(value(item))).sort((a, b) => compareKnown(value(a), value(b), direction));
