// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for people, and elements without markup in strings.

/** make("dt", {class: "x", onclick: f}, "text", child, …) */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element[name] = value;
    else if (value !== false && value != null) element.setAttribute(name, value);
  }
  element.append(...children.flat(Infinity).filter((child) => child != null && child !== false));
  return element;
}

const superscript = (text) => [...text].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");

/** A number as results.json has it: JSON holds no infinity, which is a text there; null is not known. */
function numberOf(x) {
  if (x === "-inf") return -Infinity;
  return x === "inf" ? Infinity : x ?? null;
}

/** Three digits; small numbers as 1.23·10⁻⁴. */
function scientific(x) {
  if (x == null) return "–";
  if (x === 0) return "0";
  if (Math.abs(x) >= 1e-3 && Math.abs(x) < 1e4) return x.toPrecision(3);
  const [digits, power] = x.toExponential(2).split("e");
  return `${digits}·10${superscript(String(Number(power)))}`;
}

/** At least `decimals`, and one more digit where the number is small. */
function fixed(x, decimals) {
  if (x == null) return "–";
  return x !== 0 && Math.abs(x) < 10 ** (1 - decimals) ? x.toPrecision(2) : x.toFixed(decimals);
}

/** What is not known is not 0. */
const milliseconds = (seconds) => (seconds == null ? "–" : fixed(seconds * 1e3, 1));
const megabytes = (bytes) => (bytes == null ? "–" : fixed(bytes / 1e6, 1));
const similarity = (x) => (x == null ? "–" : x === 1 ? "1" : x > 0.99995 ? ">0.9999" : x.toFixed(4));
/** The PSNR of equal pictures is infinite. */
const decibels = (x) => (x == null ? "–" : x === Infinity ? "∞" : x.toFixed(1));
const count = (n) => (n == null ? "–" : n.toLocaleString("en").replaceAll(",", "\u202f"));
const percent = (share) => (share === 0 ? "0 %" : `${(100 * share).toPrecision(2)} %`);

/** The first three of what is said, and how many more there are. */
const shortened = (words, separator = "; ") => (words.length > 3 ? [...words.slice(0, 3), `${words.length - 3} more`] : words).join(separator);

/** "bands=5,clamp=1" as "bands = 5, clamp = 1". */
const spaced = (parameters) => parameters.replaceAll("=", " = ").replaceAll(",", ", ");
