// SPDX-License-Identifier: GPL-3.0-or-later
// The scene as the page shows it: a camera that turns, two methods, and what of them is on the stage.

const liveModes = [
  { what: "first", title: "first", key: "1" }, { what: "second", title: "second", key: "2" },
  { what: "beside", title: "side by side", key: "3" }, { what: "split", title: "split", key: "4" },
  { what: "difference", title: "difference", key: "5" }, { what: "error", title: "error", key: "6" },
];

/** A second method that takes longer, in milliseconds of a frame in movement, waits until the scene rests. */
const slowPair = 250;

class Live {
  constructor() {
    this.canvas = document.getElementById("canvas");
    this.stage = new Stage(this.canvas);
    this.divider = document.getElementById("divider");
    this.settings = { exposure: 0, black: 0, range: { error: 1, difference: 0.1 }, channel: 3, size: "window" };
    this.first = { name: data.methods[0].name, values: {} };
    this.second = { name: "", values: {} };
    this.objects = data.objects.map(() => ({}));
    this.camera = data.camera;
    this.what = "first";
    this.progress = new Progression({
      size: () => this.size(), request: (...of) => this.request(...of), show: (...of) => this.show(...of), fail: (error) => this.fail(error),
    });
    this.fillModes();
    this.fillRanges();
    handsOn(this);
    this.stage.resize();
    this.change();
  }

  fillModes() {
    this.buttons = liveModes.map(({ what, title, key }) => make("button", { type: "button", title: `key ${key}`, onclick: () => this.set(what) }, title));
    document.getElementById("modes").append(...this.buttons);
    document.getElementById("controls").append(methodGroup("first method", this.first, false, () => this.change()),
      methodGroup("second method", this.second, true, () => this.chooseSecond()), ...data.objects.map((object, i) => objectGroup(object, this.objects[i], () => this.change())),
      cameraGroup({ fit: (side) => this.fit(side), reset: () => this.look(data.camera), save: () => this.save(), print: () => this.print(), add: () => this.add() }),
      group("picture", sizeGroup(this.settings, () => this.change())));
    this.showModes();
  }

  fillRanges() {
    this.ranges = rangeControls(this.settings, () => this.paint());
    document.getElementById("ranges").append(...Object.values(this.ranges));
  }

  /** A second method that has just been chosen is seen at once. */
  chooseSecond() {
    this.pairIsSlow = false;
    if (this.second.name && this.what === "first") this.what = "split";
    if (!this.second.name) this.what = "first";
    this.change();
  }

  /** Whether both methods are on the stage. */
  needsBoth() { return this.second.name !== "" && this.what !== "first" && this.what !== "second"; }

  methods(moving) {
    const alone = moving && (this.what === "first" || (this.pairIsSlow && this.what !== "second"));
    if (!this.second.name || alone) return [this.first];
    return moving && this.what === "second" ? [this.second] : [this.first, this.second];
  }

  /** The largest picture of the scene's shape that the stage, or half of it, holds; the scene's own at most. */
  size() {
    const [width, height] = data.size, across = this.what === "beside" ? 2 : 1;
    const scale = this.settings.size === "scene" ? 1 : Math.min(1, this.canvas.width / width / across, this.canvas.height / height);
    return [width, height].map((side) => Math.max(1, Math.round(side * scale)));
  }

  state(size, samples) { return { camera: this.camera, size, samples, objects: this.objects }; }

  request(size, samples, moving) {
    const methods = this.methods(moving);
    this.asked = methods;
    return { ...this.state(size, samples), methods: methods.map(callOf), metrics: moving || methods.length < 2 ? [] : data.metrics.map(({ name }) => name) };
  }

  change(moving = false) {
    this.showModes();
    document.getElementById("error").hidden = true;
    this.progress.change(moving);
  }

  look(camera, moving = false) {
    this.camera = camera;
    this.stage.cursor = null;
    this.change(moving);
  }

  show(frame, moving) {
    if (this.frame && String(this.frame.size) !== String(frame.size) && !moving) this.stage.cursor = null;
    this.frame = frame;
    if (moving && this.asked.length === 2) this.pairIsSlow = this.progress.milliseconds > slowPair;
    this.frame.of = this.asked.map((method) => (method === this.first ? "first" : "second"));
    this.paint();
    this.describe(moving);
  }

  picture(which) { return this.frame.pictures[Math.max(0, this.frame.of.indexOf(which))]; }

  /** The frame's values as colours, without asking anew. */
  paint() {
    if (!this.frame) return;
    const both = this.frame.pictures.length === 2, what = both || this.what === "second" ? this.what : "first";
    const first = this.picture("first").floats, second = this.picture("second").floats;
    const shown = {
      first: () => exposedBytes(first, this.settings), second: () => exposedBytes(second, this.settings),
      beside: () => exposedBytes(first, this.settings), split: () => exposedBytes(second, this.settings),
      difference: () => differenceBytes(second, first, this.settings), error: () => errorBytes(first, second, this.settings.range.error),
    }[what]();
    this.shown = what;
    const [width, height] = this.frame.size;
    this.seen = what === "beside" ? sideBySide(asCanvas(shown, width, height), asCanvas(exposedBytes(second, this.settings), width, height)) : asCanvas(shown, width, height);
    this.other = what === "split" ? asCanvas(exposedBytes(first, this.settings), width, height) : null;
    this.draw();
  }

  draw() {
    if (!this.seen) return;
    this.stage.split = this.shown === "split" ? Number(this.divider.value) : null;
    this.stage.place.fit(this.canvas, this.seen);
    this.stage.draw(this.seen, this.other);
  }

  describe(moving) {
    const { size, samples, pictures, metrics } = this.frame;
    const shown = data.metrics.filter(({ name }) => metrics[name] != null).map(({ name, symbol }) => `${symbol} ${name === "ssim" ? similarity(metrics[name]) : scientific(metrics[name])}`);
    const drawn = pictures.map(({ method, seconds }) => `${method} ${milliseconds(seconds)} ms`);
    const lines = [`${size[0]} × ${size[1]}, ${counted(samples * samples, "sample")}`, ...drawn, ...shown];
    const element = document.getElementById("numbers");
    element.setAttribute("aria-live", moving ? "off" : "polite");
    element.textContent = lines.join(" · ");
  }

  showModes() {
    this.buttons.forEach((button, i) => {
      button.setAttribute("aria-pressed", liveModes[i].what === this.what);
      button.disabled = liveModes[i].what !== "first" && !this.second.name;
    });
    this.divider.hidden = this.what !== "split";
    this.ranges && Object.entries(this.ranges).forEach(([of, element]) => { element.hidden = (of === "picture") === (this.what === "error" || this.what === "difference") || (of !== "picture" && of !== this.what); });
    document.getElementById("legend").replaceChildren(...[colorBar(this.what, this.settings)].filter(Boolean));
    this.canvas.setAttribute("aria-label", `${data.name}, ${this.what}; arrow keys turn the scene`);
  }

  set(what) {
    if (what !== "first" && !this.second.name) return;
    this.what = what;
    this.change();
  }

  fail(error) {
    const element = document.getElementById("error");
    element.textContent = error.message;
    element.hidden = false;
  }

  /** What `act` returns; of a failure its message. */
  async told(act) {
    try {
      return await act();
    } catch (error) {
      if (!error.replaced) this.fail(error);
      return error.replaced ? "" : error.message;
    }
  }

  fit(side) {
    return this.told(async () => this.look((await askJson("camera", { ...this.state(this.size(), 1), view: side })).camera));
  }

  save() { return this.told(async () => `saved to ${(await askJson("save", { camera: this.camera })).saved}`); }

  add() {
    return this.told(async () => {
      const { study, views } = await askJson("study", { camera: this.camera });
      return `view ${views} of ${study}`;
    });
  }

  print() { return this.told(async () => `--camera ${(await askJson("print", { camera: this.camera })).text}`); }

  /** The column and row of the whole picture below a place of the stage. */
  pixelAt(x, y) {
    const [width, height] = this.frame.size;
    const [column, row] = this.stage.place.pixelAt(x, y), inside = this.shown === "beside" ? column % (width + besideGap) : column;
    return column < 0 || row < 0 || row >= height || inside >= width ? null : [inside, row];
  }

  async probe(pixel) {
    if (!pixel || !this.frame) return;
    this.stage.cursor = pixel;
    this.draw();
    const method = callOf(this.second.name ? this.second : this.first);
    const body = { ...this.state(this.frame.size), pixel, method, page: `${page}-probe` };
    delete body.samples;
    await this.told(async () => {
      const panel = document.getElementById("probe");
      panel.replaceChildren(...probePanel(await askJson("probe", body), method).filter(Boolean));
      panel.hidden = false;
    });
  }

  moveCursor(dx, dy) {
    const [width, height] = this.frame.size, within = (x, end) => Math.min(end - 1, Math.max(0, x));
    const [x, y] = this.stage.cursor ?? [Math.floor(width / 2) - dx, Math.floor(height / 2) - dy];
    this.stage.cursor = [within(x + dx, width), within(y + dy, height)];
    this.draw();
    document.getElementById("numbers").textContent = `pixel ${this.stage.cursor.join(", ")}: Enter probes it`;
  }
}

const besideGap = 4; // pixels

function asCanvas(bytes, width, height) {
  const canvas = make("canvas", { width, height });
  canvas.getContext("2d").putImageData(new ImageData(bytes, width, height), 0, 0);
  return canvas;
}

function sideBySide(left, right) {
  const canvas = make("canvas", { width: 2 * left.width + besideGap, height: left.height });
  const context = canvas.getContext("2d");
  context.drawImage(left, 0, 0);
  context.drawImage(right, left.width + besideGap, 0);
  return canvas;
}
