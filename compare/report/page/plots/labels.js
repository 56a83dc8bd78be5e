// SPDX-License-Identifier: GPL-3.0-or-later
// Names beside points, each so that it is plainly its own point's; and text below a plot.

const fontSize = 11;
const labelHeight = 13;
const ownReach = 7;    // pixels from a point to its label
const otherReach = 13; // that no other point comes nearer to it

const textWidth = (() => {
  const context = document.createElement("canvas").getContext("2d");
  return (text) => {
    context.font = `${fontSize}px ${getComputedStyle(document.body).fontFamily}`;
    return context.measureText(text).width;
  };
})();

/** Boxes around a point in which its label may stand, the best places first: [left, top, right, bottom]. */
function labelBoxes({ x, y }, width) {
  const box = (left, top) => [left, top, left + width, top + labelHeight];
  const middle = y - labelHeight / 2, right = x + ownReach, left = x - ownReach - width;
  const above = y - ownReach - labelHeight, below = y + ownReach;
  const near = [box(right, middle), box(x - width / 2, above), box(x - width / 2, below), box(left, middle)];
  return [...near, box(x + 4, above), box(x + 4, below), box(x - 4 - width, above), box(x - 4 - width, below)];
}

const areDisjoint = (a, b) => a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1];
const distanceTo = ([left, top, right, bottom], { x, y }) => Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));

/** The labels {text, x, y} of the named points that have a place, and the points that have none. Labels stand in the plot, over nothing of
    `taken`, which are boxes, and far from all points but their own. */
function placeLabels(named, points, size, taken) {
  const boxes = [...taken], labels = [], homeless = [];
  for (const point of named) {
    const isPlain = (box) => box[0] >= 0 && box[1] >= 0 && box[2] <= size.width && box[3] <= size.height &&
      boxes.every((other) => areDisjoint(box, other)) && points.every((other) => other === point || distanceTo(box, other) > otherReach);
    const box = labelBoxes(point, textWidth(point.name)).find(isPlain);
    if (!box) {
      homeless.push(point);
      continue;
    }
    boxes.push(box);
    labels.push({ text: point.name, x: box[0], y: box[1] + labelHeight / 2 });
  }
  return { labels, homeless };
}

/** Words in lines of at most so many pixels. */
function wrapped(text, width) {
  const lines = [""];
  for (const word of text.split(" ")) {
    const longer = `${lines.at(-1)} ${word}`.trim();
    if (textWidth(longer) <= width || lines.at(-1) === "") lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/** What a plot says below itself, as Vega's title. */
const notesBelow = (notes, width, { soft }, offset = 6) => ({
  text: notes.flatMap((note) => wrapped(note, width)), orient: "bottom", anchor: "start", frame: "bounds", offset,
  color: soft, fontSize, fontWeight: 400, lineHeight: 14, font: getComputedStyle(document.body).fontFamily,
});
