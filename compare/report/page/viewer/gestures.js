// SPDX-License-Identifier: GPL-3.0-or-later
// What a wheel, a mouse and fingers do on the stage, in device pixels: zoom(factor, x, y), move(dx, dy), point(x, y).

function gesturesOn(canvas, { zoom, move, point }) {
  const pointers = new Map();
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [(event.clientX - box.left) * devicePixelRatio, (event.clientY - box.top) * devicePixelRatio];
  };
  const middle = () => {
    const places = [...pointers.values()];
    return [0, 1].map((k) => places.reduce((sum, p) => sum + p[k], 0) / places.length);
  };
  const span = () => {
    const [a, b] = [...pointers.values()];
    return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaMode === 1 ? 16 * event.deltaY : event.deltaY;
    zoom(2 ** (-pixels / 200), ...at(event));
  }, { passive: false });
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    point(...at(event));
    if (!pointers.has(event.pointerId)) return;
    const [before, spanBefore] = [middle(), span()];
    pointers.set(event.pointerId, at(event));
    const after = middle();
    move(after[0] - before[0], after[1] - before[1]);
    if (spanBefore > 0) zoom(span() / spanBefore, ...after);
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
}
