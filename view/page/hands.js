// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse, fingers and keys do to the scene.

const degreesPerStage = 180; // of a drag across the stage's smaller side
const keyStep = 5;           // degrees
const keyFactor = 1.1;       // by which a key comes nearer
const clickReach = 4;        // device pixels that a click may move

/** Lets them act on `live`. */
function handsOn(live) {
  const { canvas } = live;
  let moved = 0, moves = false, pointer = null;
  canvas.addEventListener("pointerdown", (event) => {
    moved = 0;
    moves = event.shiftKey || event.button === 2;
    const box = canvas.getBoundingClientRect();
    pointer = [(event.clientX - box.left) * devicePixelRatio, (event.clientY - box.top) * devicePixelRatio];
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  gesturesOn(canvas, {
    zoom: (factor) => live.look(approached(live.camera, factor), true),
    move: (dx, dy) => {
      moved += Math.hypot(dx, dy);
      if (moved > clickReach) drag(live, dx, dy, moves);
    },
    point: () => {},
  });
  canvas.addEventListener("click", () => {
    if (moved <= clickReach && live.frame) live.probe(live.pixelAt(...pointer));
  });
  live.divider.oninput = () => live.draw();
  canvas.addEventListener("keydown", (event) => press(live, event));
  new ResizeObserver(() => live.stage.resize() && live.change()).observe(canvas);
}

function drag(live, dx, dy, moves) {
  const side = Math.min(live.canvas.width, live.canvas.height);
  const by = degreesPerStage / side;
  live.look(moves ? panned(live.camera, -dx / side, dy / side) : turned(live.camera, dx * by, dy * by), true);
}

function press(live, event) {
  if (event.ctrlKey || event.metaKey || event.altKey || !live.frame) return;
  const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
  const turn = (dx, dy) => live.look(turned(live.camera, keyStep * dx, keyStep * dy), true);
  const approach = (factor) => () => live.look(approached(live.camera, factor), true);
  const acts = {
    "+": approach(keyFactor), "=": approach(keyFactor), "-": approach(1 / keyFactor), r: () => live.look(data.camera),
    Enter: () => live.probe(live.stage.cursor), ...Object.fromEntries(liveModes.map(({ what, key }) => [key, () => live.set(what)])),
  };
  const act = arrow ? () => (event.shiftKey ? live.moveCursor(...arrow) : turn(...arrow)) : acts[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!act) return;
  event.preventDefault();
  act();
}
