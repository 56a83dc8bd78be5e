// SPDX-License-Identifier: GPL-3.0-or-later
// One picture as large as the window, to be flipped with the reference and walked through by keys.

class Viewer {
  constructor(dialog) {
    this.dialog = dialog;
    this.image = make("img", { alt: "" });
    this.title = make("strong");
    this.numbers = make("span");
    const button = (text, act) => make("button", { type: "button", onclick: act }, text);
    dialog.append(
      make("div", { class: "bar" }, this.title, this.numbers,
           button("reference", () => this.flip()), button("error", () => this.set("error")), button("FLIP", () => this.set("flip")),
           button("‹", () => this.step(-1)), button("›", () => this.step(1)), button("close", () => dialog.close()),
           make("span", { class: "keys" }, "Space: reference · E: error · V: FLIP · ← →: methods · Esc")),
      make("div", { class: "stage", onclick: () => this.flip() }, this.image));
    dialog.addEventListener("keydown", (event) => this.key(event));
  }

  open(rows, row, what = "picture") {
    this.rows = rows;
    this.at = rows.indexOf(row);
    this.what = what;
    this.show();
    this.dialog.showModal();
  }

  show() {
    const row = this.rows[this.at];
    const reference = this.rows[0];
    const shown = this.what === "reference" ? reference : row;
    const map = errorMaps[this.what]?.source(row) && errorMaps[this.what];
    this.image.src = map ? map.source(row) : shown.picture;
    this.title.textContent = `${row.scene} · ${map ? `${map.title} of ${row.name}` : shown.name}`;
    this.numbers.textContent = shown.reference ? "reference" : numbersLine(qualityColumns(), row);
  }

  set(what) {
    this.what = this.what === what ? "picture" : what;
    this.show();
  }
  flip() { this.set("reference"); }
  step(by) {
    this.at = (this.at + by + this.rows.length) % this.rows.length;
    this.show();
  }

  key(event) {
    const acts = {
      " ": () => this.flip(),
      e: () => this.set("error"),
      v: () => this.set("flip"),
      ArrowLeft: () => this.step(-1),
      ArrowRight: () => this.step(1),
    };
    const act = acts[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }
}
