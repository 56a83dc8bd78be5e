// SPDX-License-Identifier: GPL-3.0-or-later
// The stage draws what is seen: one picture, or two beside a dividing line, at one place, and the pixel that is read out.

/** From this zoom on pixels are squares. */
const unfilteredFrom = 2;

class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.place = new Place();
    this.split = null; // share of the stage's width left of which the second picture is
    this.cursor = null;
  }

  /** Takes the size of its element; returns whether that has changed. */
  resize() {
    const width = Math.max(1, Math.round(this.canvas.clientWidth * devicePixelRatio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * devicePixelRatio));
    if (width === this.canvas.width && height === this.canvas.height) return false;
    Object.assign(this.canvas, { width, height });
    return true;
  }

  /** `other` is shown left of the dividing line. */
  draw(picture, other) {
    const context = this.canvas.getContext("2d");
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.imageSmoothingEnabled = this.place.zoom < unfilteredFrom;
    context.imageSmoothingQuality = "high";
    this.drawPicture(context, picture, 0, this.canvas.width);
    if (other && this.split != null) this.drawSplit(context, other);
    if (this.cursor) this.drawCursor(context);
  }

  drawPicture(context, picture, left, width) {
    const { x, y, zoom } = this.place;
    context.save();
    context.beginPath();
    context.rect(left, 0, width, this.canvas.height);
    context.clip();
    context.drawImage(picture, x, y, zoom * picture.width, zoom * picture.height);
    context.restore();
  }

  drawSplit(context, other) {
    const at = Math.round(this.split * this.canvas.width);
    context.clearRect(0, 0, at, this.canvas.height);
    this.drawPicture(context, other, 0, at);
    if (at > 0 && at < this.canvas.width) this.drawDivider(context, at);
  }

  drawDivider(context, at) {
    for (const [color, width] of [["#fff", 3], ["#000", 1]]) {
      context.fillStyle = color;
      context.fillRect(at - (width - 1) / 2, 0, width, this.canvas.height);
    }
  }

  drawCursor(context) {
    const { x, y, zoom } = this.place;
    const box = [x + this.cursor[0] * zoom - 1.5, y + this.cursor[1] * zoom - 1.5, Math.max(zoom, 3) + 3, Math.max(zoom, 3) + 3];
    for (const [color, width] of [["#fff", 3], ["#000", 1]]) {
      Object.assign(context, { strokeStyle: color, lineWidth: width });
      context.strokeRect(...box);
    }
  }
}
