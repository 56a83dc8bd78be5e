// SPDX-License-Identifier: GPL-3.0-or-later
// Where a picture lies on the stage: zoom in device pixels per pixel, and the stage's place of its corner.

class Place {
  constructor() { Object.assign(this, { zoom: 1, x: 0, y: 0 }); }

  /** The whole picture in the middle of the stage. */
  fit(stage, picture) {
    this.zoom = Math.min(stage.width / picture.width, stage.height / picture.height);
    this.centre(stage, picture);
  }

  actual(stage, picture) {
    this.zoomAt(1 / this.zoom, stage.width / 2, stage.height / 2);
    if (picture.width <= stage.width && picture.height <= stage.height) this.centre(stage, picture);
  }

  centre(stage, picture) {
    this.x = (stage.width - this.zoom * picture.width) / 2;
    this.y = (stage.height - this.zoom * picture.height) / 2;
  }

  /** The pixel below (x, y) stays there. */
  zoomAt(factor, x, y) {
    const zoom = Math.min(64, Math.max(1 / 16, this.zoom * factor));
    this.x = x - (x - this.x) * (zoom / this.zoom);
    this.y = y - (y - this.y) * (zoom / this.zoom);
    this.zoom = zoom;
  }

  move(dx, dy) {
    this.x += dx;
    this.y += dy;
  }

  /** The column and row below a place of the stage. */
  pixelAt(x, y) { return [Math.floor((x - this.x) / this.zoom), Math.floor((y - this.y) / this.zoom)]; }

  /** Moves the picture so far that a pixel is on the stage. */
  reveal([column, row], stage) {
    const into = (at, extent) => (at < 0 ? -at : at + this.zoom > extent ? extent - at - this.zoom : 0);
    this.x += into(this.x + column * this.zoom, stage.width);
    this.y += into(this.y + row * this.zoom, stage.height);
  }
}
