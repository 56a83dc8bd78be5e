// SPDX-License-Identifier: GPL-3.0-or-later
// The values of a row's picture: the floats that the report carries, or the 8 bits of its PNG file.

const waitingTexts = new Map();
/** The files of a folder's report call this with what they hold. */
globalThis.pellucidText = (key, text) => waitingTexts.get(key)?.(text);

/** The text of a key: from the page itself, or from its file beside the page. */
function textOf(key) {
  const element = document.getElementById(key);
  if (element) return Promise.resolve(element.textContent);
  if (!data.pixels.in_folder) return Promise.reject(new Error(`the report has no ${key}`));
  return new Promise((resolve, reject) => {
    waitingTexts.set(key, resolve);
    const script = make("script", { src: `report/${key}.js` });
    script.onerror = () => reject(new Error(`report/${key}.js is missing`));
    document.head.append(script);
  });
}

async function inflated(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The inverse of packed_words() in packed_words.h. */
function unpackedWords(planes, predicted) {
  const count = planes.length / 4;
  const words = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    const rest = (planes[i] << 24) | (planes[count + i] << 16) | (planes[2 * count + i] << 8) | planes[3 * count + i];
    words[i] = rest + (predicted ? predicted[i] : i > 0 ? words[i - 1] : 0);
  }
  return words;
}

/** The values of the PNG file, all red ones, then green, then blue. */
async function bytesAsFloats(source, width, height) {
  const image = new Image();
  image.src = source;
  await image.decode();
  const canvas = make("canvas", { width, height });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  const bytes = context.getImageData(0, 0, width, height).data;
  const floats = new Float32Array(3 * width * height);
  for (let i = 0; i < width * height; i++)
    for (let c = 0; c < 3; c++) floats[c * width * height + i] = bytes[4 * i + c] / 255;
  return floats;
}

/** PixelStore keeps the pictures that were looked at last: a megapixel takes 12 MB. */
class PixelStore {
  constructor(most = 8) {
    this.most = most;
    this.kept = new Map();
  }

  /** A promise of the floats of a row's picture. */
  floats(row, reference, scene) {
    return this.keep(`pixels-${row.place}`, () =>
      data.pixels.mantissa_bits > 0 ? this.words(row, reference).then((words) => new Float32Array(words.buffer))
                                    : bytesAsFloats(row.picture, scene.width, scene.height));
  }

  /** A promise of a row's numbers of layers; of null where they are not at hand. */
  layers(row) {
    if (!row.has_layers || data.pixels.mantissa_bits === 0) return Promise.resolve(null);
    const key = `layers-${row.place}`;
    return this.keep(key, async () => unpackedWords(await inflated(await textOf(key))));
  }

  async words(row, reference) {
    const predicted = row === reference ? null : new Uint32Array((await this.floats(reference, reference)).buffer);
    return unpackedWords(await inflated(await textOf(`pixels-${row.place}`)), predicted);
  }

  keep(key, load) {
    const found = this.kept.get(key) ?? load();
    this.kept.delete(key);
    this.kept.set(key, found);
    if (this.kept.size > 2 * this.most) this.kept.delete(this.kept.keys().next().value);
    return found;
  }
}

/** A promise of a map as an image that a canvas may hand out again: not from a file beside the page. */
async function mapImage(key, source) {
  const image = new Image();
  image.src = data.pixels.in_folder ? await textOf(key) : source;
  await image.decode();
  return image;
}
