// SPDX-License-Identifier: GPL-3.0-or-later
// The viewer's buttons, sliders, colour bar and read-out, each with a name that a screen reader says.

const views = [
  { what: "picture", title: "method", key: "1" },
  { what: "reference", title: "reference", key: "2" },
  { what: "error", title: "error", key: "3" },
  { what: "difference", title: "difference", key: "4" },
  { what: "flip", title: "FLIP", key: "5" },
];

const signed = (x) => (x < 0 ? `−${scientific(-x)}` : `+${scientific(x)}`);
const channelNames = ["red", "green", "blue", "largest"];

function slider(label, { min, max, step, value }, text, act) {
  const output = make("output", {}, text(value));
  const input = make("input", { type: "range", min, max, step, value, "aria-label": label, "aria-valuetext": text(value) });
  input.oninput = () => {
    output.textContent = text(Number(input.value));
    input.setAttribute("aria-valuetext", output.textContent);
    act(Number(input.value));
  };
  return make("label", {}, label, input, output);
}

/** The controls that change how values become colours; `act` is called after each change. */
function rangeControls(settings, act) {
  const set = (name) => (value) => {
    settings[name] = value;
    act();
  };
  const range = (of, decade) =>
    slider("Range", { min: -7, max: 0, step: 0.25, value: decade }, (x) => `up to ${scientific(10 ** x)}`, (x) => {
      settings.range[of] = 10 ** x;
      act();
    });
  const channel = make("select", { "aria-label": "Channel of the difference" },
    channelNames.map((name, i) => make("option", { value: i, selected: i === settings.channel && "" }, name)));
  channel.onchange = () => set("channel")(Number(channel.value));
  return {
    picture: make("div", { class: "ranges" },
      slider("Exposure", { min: -8, max: 16, step: 0.5, value: 0 }, (x) => `${x} stops`, set("exposure")),
      slider("Black", { min: 0, max: 1, step: 0.01, value: 0 }, String, set("black"))),
    error: make("div", { class: "ranges" }, range("error", 0)),
    difference: make("div", { class: "ranges" }, range("difference", -1), make("label", {}, "Channel", channel)),
  };
}

/** The bar of colours of what is seen; null for pictures. */
function colorBar(what, { range, channel }) {
  const { colors } = data.error_scale;
  if (what === "error") return logarithmicScale({ min: range.error / 1000, max: range.error, colors }, "largest error of red, green and blue");
  if (what === "flip") return colorScale(colors, [[0, "0"], [0.5, "0.5"], [1, "1"]], "FLIP");
  if (what !== "difference") return null;
  const ends = [[0, signed(-range.difference)], [0.5, "0"], [1, signed(range.difference)]];
  return colorScale(signedStops, ends, `method minus reference, ${channelNames[channel]}`);
}

/** How the values came here. */
function precisionText() {
  const { mantissa_bits } = data.pixels;
  if (mantissa_bits === 23) return "values: the EXR's floats";
  return mantissa_bits > 0 ? `values: floats rounded to ${mantissa_bits + 1} bits` : "values: 8 bits, from the PNG";
}

const digits = (x) => (data.pixels.mantissa_bits > 0 ? Number(x.toPrecision(data.pixels.mantissa_bits === 23 ? 7 : 4)) : Number(x.toPrecision(3)));

/** Column, row, the values of both pictures, their difference, and layers where they are at hand. */
function readOut([column, row], { width, height }, { floats, reference, layers, referenceLayers }) {
  if (column < 0 || row < 0 || column >= width || row >= height) return "";
  const i = row * width + column, size = width * height;
  const values = (of) => [0, 1, 2].map((c) => digits(of[c * size + i])).join(" ");
  const parts = [`x ${column}, y ${row}`, `colour ${values(floats)}`, `reference ${values(reference)}`,
                 `error ${scientific(Math.abs(differenceAt(floats, reference, i, 3)))}`];
  if (layers) parts.push(`layers ${layers[i]}`);
  if (referenceLayers) parts.push(`layers of the reference ${referenceLayers[i]}`);
  return parts.join(" · ");
}
