// SPDX-License-Identifier: GPL-3.0-or-later
// Values of two pictures as the bytes of a canvas. Floats lie as all red ones, then green, then blue.

const byteOf = (x) => (x > 0 ? Math.min(255, Math.floor(Math.min(x, 1) * 255 + 0.5)) : 0);
const hexColor = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));

/** 256 colours of a list of stops, evenly spread. */
function ramp(stops) {
  const colors = stops.map(hexColor);
  return Array.from({ length: 256 }, (_, i) => {
    const at = (i / 255) * (colors.length - 1), low = Math.min(Math.floor(at), colors.length - 2);
    return colors[low].map((c, k) => c + (at - low) * (colors[low + 1][k] - c));
  });
}
const signedStops = ["#2166ac", "#67a9cf", "#d1e5f0", "#f7f7f7", "#fddbc7", "#ef8a62", "#b2182b"];

const differenceAt = (a, b, i, channel) => {
  const size = a.length / 3;
  if (channel < 3) return a[channel * size + i] - b[channel * size + i];
  let largest = 0;
  for (let c = 0; c < 3; c++) {
    const d = a[c * size + i] - b[c * size + i];
    if (!(Math.abs(d) <= Math.abs(largest))) largest = d;
  }
  return largest;
};

/** The bytes of `count` pixels, the colour of each put in by `color(i, out, 4 i)`. */
function shaded(count, color) {
  const bytes = new Uint8ClampedArray(4 * count);
  for (let i = 0; i < count; i++) {
    color(i, bytes, 4 * i);
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

/** A picture, less `black`, times 2 to the `exposure`. */
function exposedBytes(floats, { exposure, black }) {
  const size = floats.length / 3, gain = 2 ** exposure;
  return shaded(size, (i, out, at) => {
    for (let c = 0; c < 3; c++) out[at + c] = byteOf((floats[c * size + i] - black) * gain);
  });
}

function rampBytes(size, stops, share) {
  const colors = ramp(stops);
  return shaded(size, (i, out, at) => {
    const color = colors[Math.round(255 * Math.min(1, Math.max(0, share(i))))];
    for (let c = 0; c < 3; c++) out[at + c] = color[c];
  });
}

/** The largest error of a pixel, logarithmic from a thousandth of the range to the range. */
const errorBytes = (a, b, range) => rampBytes(a.length / 3, data.error_scale.colors,
  (i) => 1 + Math.log10(Math.abs(differenceAt(a, b, i, 3)) / range) / 3);

/** Method minus reference, blue below and red above. */
const differenceBytes = (a, b, { range, channel }) => rampBytes(a.length / 3, signedStops,
  (i) => 0.5 + differenceAt(a, b, i, channel) / (2 * range.difference));
