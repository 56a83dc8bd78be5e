// SPDX-License-Identifier: GPL-3.0-or-later
// What the page asks the program for.

/** What the program has said of the scene; start.js fills it before anything is drawn. */
const data = {};
/** Newer work of a page takes the place of its older work. */
const page = crypto.getRandomValues(new Uint32Array(2)).join("-");

/** An error that the program tells in one line, or that it is gone. Replaced: nobody wants the answer any more. */
class Refusal extends Error {
  constructor(message, replaced = false) {
    super(message);
    this.replaced = replaced;
  }
}

/** `read` takes the answer's body, which may be cut short as well as its head. */
async function ask(name, body, signal, read) {
  let response;
  try {
    response = await fetch(name, body && { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body), signal });
    if (response.ok) return await read(response);
  } catch (error) {
    if (error.name === "AbortError") throw new Refusal("aborted", true);
    throw new Refusal("The program has ended: start pellucid view again, and open the address that it prints.");
  }
  throw new Refusal((await response.json()).error, response.status === 409);
}

const askJson = (name, body, signal) => ask(name, body, signal, (response) => response.json());

/** Pictures as Painter::frame packs them: {size, samples, metrics, pictures: [{method, seconds, floats}]}. */
async function askFrame(body, signal) {
  const bytes = await ask("frame", { ...body, page }, signal, (response) => response.arrayBuffer());
  const length = new DataView(bytes).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  const count = 3 * header.size[0] * header.size[1];
  header.pictures.forEach((picture, i) => { picture.floats = new Float32Array(bytes, 4 + length + 4 * count * i, count); });
  return header;
}
