// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras that have moved. A camera is as a scene file has it; angles are in degrees.

const minus = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, by = 1) => a.map((x, i) => x + by * b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));
/** To a millionth of `distance`, from the eye to what it sees, which is more than an eye sees, and can be read; far from the origin, too. */
function rounded(a, distance) {
  const decimals = Math.min(100, Math.max(0, 6 - Math.floor(Math.log10(distance))));
  return a.map((x) => Number(x.toFixed(decimals)));
}

const distanceOf = ({ eye, target }) => Math.hypot(...minus(eye, target));

/** Rodrigues' rotation of v about the unit axis. */
function rotated(v, axis, degrees) {
  const angle = (degrees * Math.PI) / 180;
  const along = dot(axis, v) * (1 - Math.cos(angle));
  return plus(plus(v.map((x) => x * Math.cos(angle)), cross(axis, v), Math.sin(angle)), axis, along);
}

/** Closer than this to its up direction a camera does not turn: there is no frame. */
const nearestToPole = 1;

/** Goes around the target: about up, and towards it. */
function turned(camera, around, upward) {
  const up = unit(camera.up);
  let arm = rotated(minus(camera.eye, camera.target), up, -around);
  const right = unit(cross(up, arm));
  const now = (Math.acos(Math.max(-1, Math.min(1, dot(unit(arm), up)))) * 180) / Math.PI;
  const then = Math.min(180 - nearestToPole, Math.max(nearestToPole, now - upward));
  arm = rotated(arm, right, then - now);
  return { ...camera, eye: rounded(plus(camera.target, arm), distanceOf(camera)) };
}

/** Moves eye and target by shares of the picture's height, to the right and up. */
function panned(camera, right, up) {
  const forward = minus(camera.target, camera.eye);
  const height = camera.height ?? 2 * Math.tan((camera.fov * Math.PI) / 360) * Math.hypot(...forward);
  const x = unit(cross(forward, camera.up)), y = unit(cross(x, forward));
  const by = plus(x.map((c) => c * right * height), y, up * height);
  const distance = distanceOf(camera);
  return { ...camera, eye: rounded(plus(camera.eye, by), distance), target: rounded(plus(camera.target, by), distance) };
}

/** The target looks `factor` times as large. */
function approached(camera, factor) {
  if (camera.height) return { ...camera, height: Number((camera.height / factor).toPrecision(6)) };
  const distance = distanceOf(camera) / factor;
  return { ...camera, eye: rounded(plus(camera.target, minus(camera.eye, camera.target), 1 / factor), distance) };
}
