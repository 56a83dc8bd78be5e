// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as large as the window. Zoom and place stay while methods, reference and maps are flipped; keys do all of it.

class Viewer {
  constructor(dialog) {
    this.dialog = dialog;
    this.settings = { exposure: 0, black: 0, range: { error: 1, difference: 0.1 }, channel: 3 };
    this.store = new PixelStore();
    this.canvas = make("canvas", { tabindex: 0, role: "img" });
    this.stage = new Stage(this.canvas);
    this.title = make("strong");
    this.numbers = make("span");
    this.live = make("output", { class: "readout", "aria-live": "polite" });
    this.legend = make("div", { class: "legend" });
    this.ranges = rangeControls(this.settings, () => this.show());
    this.divider = this.dividerSlider();
    dialog.append(this.bar(), make("div", { class: "stage" }, this.canvas, this.divider),
                  make("div", { class: "bar foot" }, this.live, Object.values(this.ranges), this.legend));
    dialog.addEventListener("keydown", (event) => this.key(event));
    gesturesOn(this.canvas, {
      zoom: (...at) => this.zoom(...at),
      move: (...by) => { this.stage.place.move(...by); this.draw(); },
      point: (x, y) => this.read(this.stage.place.pixelAt(x, y)),
    });
    new ResizeObserver(() => dialog.open && this.stage.resize() && this.draw()).observe(this.canvas);
  }

  bar() {
    const button = (text, label, act) => make("button", { type: "button", "aria-label": label, onclick: act }, text);
    this.buttons = views.map(({ what, title, key }) => make("button", { type: "button", title: `key ${key}`, onclick: () => this.set(what) }, title));
    return make("div", { class: "bar", role: "toolbar", "aria-label": "What is shown" },
      make("div", { class: "heading" }, this.title, this.numbers), this.buttons,
      button("split", "Split between reference and method", () => this.toggleSplit()),
      button("‹", "Previous method", () => this.step(-1)), button("›", "Next method", () => this.step(1)),
      button("−", "Zoom out", () => this.zoom(0.5)), button("+", "Zoom in", () => this.zoom(2)),
      button("1:1", "Actual size", () => this.actual()), button("fit", "Fit the window", () => this.fit()),
      button("save PNG", "Download what is seen", () => this.download()), button("close", "Close", () => this.dialog.close()),
      make("span", { class: "keys" }, "1–5 what is shown · Space reference · ← → methods · + − O fit: 0 · S split · Shift+arrows read a pixel · D download · Esc"));
  }

  dividerSlider() {
    const input = make("input", { type: "range", class: "divider", min: 0, max: 1, step: 0.005, value: 0.5, hidden: "", "aria-label": "Dividing line, reference on its left" });
    input.oninput = () => {
      this.stage.split = Number(input.value);
      this.draw();
    };
    return input;
  }

  open(rows, row, what = "picture") {
    const scene = data.scenes.find(({ name }) => name === row.scene);
    const fresh = this.scene !== scene;
    Object.assign(this, { rows, scene, what, at: rows.indexOf(row) });
    if (!this.dialog.open) this.dialog.showModal();
    this.stage.resize();
    if (fresh) this.stage.place.fit(this.canvas, scene);
    this.canvas.focus();
    return this.show();
  }

  /** Only the last call's picture is shown, in whatever order the values arrive. */
  async show() {
    const call = (this.call = Symbol("call"));
    const row = this.rows[this.at], first = this.rows[0];
    const floats = this.store.floats(row, first, this.scene), reference = this.store.floats(first, first, this.scene);
    const layers = this.store.layers(row), referenceLayers = this.store.layers(first);
    try {
      const values = { floats: await floats, reference: await reference, layers: await layers, referenceLayers: await referenceLayers };
      const seen = await this.seen(row, values);
      if (call !== this.call) return;
      Object.assign(this, { values, picture: seen, other: this.asCanvas(exposedBytes(values.reference, this.settings)) });
      this.describe(row);
      this.draw();
      if (this.stage.cursor) this.read(this.stage.cursor);
    } catch (error) {
      this.live.textContent = `This picture cannot be shown: ${error.message}.`;
    }
  }

  async seen(row, { floats, reference }) {
    if (this.what === "flip" && row.flip_map) return mapImage(`flip-${row.place}`, row.flip_map);
    if (this.what === "error") return this.asCanvas(errorBytes(floats, reference, this.settings.range.error));
    if (this.what === "difference") return this.asCanvas(differenceBytes(floats, reference, this.settings));
    return this.asCanvas(exposedBytes(this.what === "reference" ? reference : floats, this.settings));
  }

  asCanvas(bytes) {
    const { width, height } = this.scene;
    const canvas = make("canvas", { width, height });
    canvas.getContext("2d").putImageData(new ImageData(bytes, width, height), 0, 0);
    return canvas;
  }

  describe(row) {
    const first = this.rows[0], { title } = views.find(({ what }) => what === this.what);
    const name = { picture: row.name, reference: first.name }[this.what] ?? `${title} of ${row.name}`;
    this.title.textContent = [row.scene, name, viewText(row)].filter(Boolean).join(" · ");
    this.numbers.textContent = row.reference || this.what === "reference" ? "reference" : this.meansText(row) + numbersLine(qualityColumns(), row);
    this.canvas.setAttribute("aria-label", `${this.title.textContent}; ${this.numbers.textContent}`);
    this.live.textContent = `${this.title.textContent} · ${precisionText()}`;
    this.buttons.forEach((button, i) => button.setAttribute("aria-pressed", views[i].what === this.what));
    this.ranges.error.hidden = this.what !== "error";
    this.ranges.difference.hidden = this.what !== "difference";
    this.ranges.picture.hidden = this.what !== "picture" && this.what !== "reference";
    this.legend.replaceChildren(...[colorBar(this.what, this.settings)].filter(Boolean));
  }

  /** The numbers are not of the picture that is seen where there are several views. */
  meansText(row) { return viewCount(row) > 1 ? `means over ${viewCount(row)} views: ` : ""; }

  draw() {
    if (this.picture) this.stage.draw(this.picture, this.other);
  }

  read(pixel) {
    const text = this.values && readOut(pixel, this.scene, this.values);
    if (text) this.live.textContent = `${text} · ${precisionText()}`;
  }

  set(what) {
    this.what = what;
    this.show();
  }

  step(by) {
    this.at = (this.at + by + this.rows.length) % this.rows.length;
    this.show();
  }

  zoom(factor, x = this.canvas.width / 2, y = this.canvas.height / 2) {
    this.stage.place.zoomAt(factor, x, y);
    this.draw();
  }

  fit() {
    this.stage.place.fit(this.canvas, this.scene);
    this.draw();
  }

  actual() {
    this.stage.place.actual(this.canvas, this.scene);
    this.draw();
  }

  toggleSplit() {
    this.stage.split = this.stage.split == null ? Number(this.divider.value) : null;
    this.divider.hidden = this.stage.split == null;
    this.draw();
  }

  /** The pixel that keys read out begins in the middle of the picture. */
  moveCursor(dx, dy) {
    const { width, height } = this.scene, within = (x, end) => Math.min(end - 1, Math.max(0, x));
    const [x, y] = this.stage.cursor ?? [Math.floor(width / 2) - dx, Math.floor(height / 2) - dy];
    this.stage.cursor = [within(x + dx, width), within(y + dy, height)];
    this.stage.place.reveal(this.stage.cursor, this.canvas);
    this.draw();
    this.read(this.stage.cursor);
  }

  download() {
    const name = this.title.textContent.replace(/[^\w.=-]+/g, "-");
    this.canvas.toBlob((blob) => saveFile(`${name}.png`, blob));
  }

  acts() {
    const shown = Object.fromEntries(views.map(({ what, key }) => [key, () => this.set(what)]));
    return {
      ...shown,
      " ": () => this.set(this.what === "reference" ? "picture" : "reference"),
      e: () => this.set(this.what === "error" ? "picture" : "error"),
      v: () => this.set(this.what === "flip" ? "picture" : "flip"),
      s: () => this.toggleSplit(), d: () => this.download(),
      "+": () => this.zoom(2), "=": () => this.zoom(2), "-": () => this.zoom(0.5), 0: () => this.fit(), o: () => this.actual(),
      ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1),
    };
  }

  key(event) {
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const typing = event.target.matches("input, select") || (event.target.matches("button") && event.key === " ");
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = event.shiftKey && arrows[event.key];
    const act = arrow ? () => this.moveCursor(...arrow) : this.acts()[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }
}
