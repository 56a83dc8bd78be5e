// SPDX-License-Identifier: GPL-3.0-or-later
// Axes over numbers that may be equal, or have no logarithm.

/** Ends around numbers, with `margin`, a share of the axis, beyond either; around a single number `least` of its unit. */
function around(numbers, margin, least) {
  const low = Math.min(...numbers), high = Math.max(...numbers);
  const missing = Math.max(0, least - (high - low)) / 2;
  const beyond = (margin * (high - low)) / (1 - 2 * margin);
  return [low - Math.max(missing, beyond), high + Math.max(missing, beyond)];
}

/** Numbers around which a linear axis has a width, 0 among them if that is asked for. */
function linearDomain(numbers, zero) {
  const all = zero ? [0, ...numbers] : numbers;
  if (all.length === 0) return [0, 1];
  const low = Math.min(...all), high = Math.max(...all);
  if (low < high) return [low, high];
  return low === 0 ? [0, 1] : around(all, 0, 0.2 * Math.abs(low));
}

/** Numbers above 0 around which a logarithmic axis has at least half a decade. */
function logarithmicDomain(numbers, margin = 0) {
  const logs = numbers.filter((x) => x > 0).map(Math.log10);
  return (logs.length === 0 ? [-1, 0] : around(logs, margin, 0.5)).map((power) => 10 ** power);
}

/** What of an axis, in pixels, is kept for numbers without a place on its scale. */
const railWidth = 26;

/** An axis of `length` pixels for numbers above `least`, on a logarithmic scale; those up to it have a rail of their own where the axis begins. */
function railedAxis(numbers, least, length) {
  const above = numbers.filter((x) => x > least);
  const rail = above.length < numbers.length ? railWidth : 0;
  const domain = logarithmicDomain(above, Math.min(0.3, 24 / (length - rail)));
  const [low, high] = domain.map(Math.log10);
  const at = (x) => (x > least ? rail + ((length - rail) * (Math.log10(x) - low)) / (high - low) : rail / 2);
  return { domain, rail, at };
}
