// SPDX-License-Identifier: GPL-3.0-or-later
// What a pixel's ray crosses, as `render --probe` says it, and the sums along it.

const svg = (tag, attributes, ...children) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
};

const plot = { width: 420, height: 200, left: 46, right: 10, top: 10, bottom: 34 };

/** A curve over d in [0, 1]; `most` is the largest value of the axis. */
function path(d, values, most, name) {
  const x = (t) => plot.left + t * (plot.width - plot.left - plot.right);
  const y = (v) => plot.height - plot.bottom - (v / most) * (plot.height - plot.top - plot.bottom);
  return svg("path", { class: name, d: values.map((v, i) => `${i ? "L" : "M"}${x(d[i]).toFixed(1)} ${y(v).toFixed(1)}`).join("") });
}

function curvePlot(d, { title, symbol, exact, method }, call) {
  const most = Math.max(1e-12, ...exact, ...(method ?? []));
  const text = (x, y, anchor, words) => svg("text", { x, y, "text-anchor": anchor }, words);
  const { width, height, left, right, top, bottom } = plot;
  const what = method ? `${symbol}: exact, and dashed as ${call} has it` : `${symbol}: exact; ${call} has no such function`;
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `${what}; at the end of the ray ${scientific(exact.at(-1))}${method ? ` and ${scientific(method.at(-1))}` : ""}` },
    svg("path", { class: "axis", d: `M${left} ${top}V${height - bottom}H${width - right}` }),
    text(left - 4, top + 8, "end", scientific(most)), text(left - 4, height - bottom, "end", "0"),
    text(left, height - bottom + 14, "middle", "0"), text(width - right, height - bottom + 14, "middle", "1"),
    text((left + width) / 2, height - 6, "middle", "d"), path(d, exact, most, "exact"), ...(method ? [path(d, method, most, "method")] : []));
  return make("figure", { class: "card" }, picture, make("figcaption", { class: "note" }, `Sum of the ${title}. ${what}.`));
}

const layerColumns = [
  ["d", (l) => l.d.toPrecision(5)], ["depth", (l) => l.depth.toPrecision(5)],
  ["opacity", (l) => fixed(l.opacity, 3)], ["transmittance before", (l) => l.transmittance.toPrecision(4)],
  ["τ", (l) => (l.optical_depth == null ? "∞" : scientific(l.optical_depth))], ["G", (l) => scientific(l.importance_sum)],
];

function layerRow(layer, i, names) {
  const swatch = make("span", { class: "swatch" });
  swatch.style.background = `rgb(${layer.color.map(byteOf).join(" ")})`;
  return make("tr", {}, make("td", {}, i + 1), make("td", {}, swatch, `${names[layer.object]}, ${layer.primitive}`), layerColumns.map(([, text]) => make("td", {}, text(layer))));
}

function layerTable(layers, names) {
  const heads = ["", "object, primitive", ...layerColumns.map(([head]) => head)];
  return make("div", { class: "wide" }, make("table", {}, make("caption", { class: "note" }, "Crossings from the eye on"),
    make("thead", {}, make("tr", {}, heads.map((head) => make("th", { scope: "col" }, head)))), make("tbody", {}, layers.map((layer, i) => layerRow(layer, i, names)))));
}

/** The whole panel of a probe's answer. */
function probePanel({ exact, names, d, curves }, call) {
  const [pixel] = exact.pixels;
  const lead = `${counted(pixel.layers.length, "crossing")}; colour ${pixel.color.map((c) => c.toPrecision(6)).join(" ")}; transmittance ${pixel.transmittance.toPrecision(6)}.`;
  return [make("h2", { tabindex: -1 }, `Pixel ${pixel.x}, ${pixel.y}`), make("p", { class: "lead" }, lead),
          make("div", { class: "curves" }, curves.map((curve) => curvePlot(d, curve, call))), pixel.layers.length > 0 && layerTable(pixel.layers, names)];
}

const counted = (n, noun) => `${n} ${noun}${n === 1 ? "" : "s"}`;
