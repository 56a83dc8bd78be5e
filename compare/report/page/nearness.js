// SPDX-License-Identifier: GPL-3.0-or-later
// What is far from the window waits: pictures and plots are made when they come near, or before the page is printed.

const waiting = new Map(); // of each element what makes it
const nearby = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) if (isIntersecting) makeNow(target);
}, { rootMargin: "100% 0px" });

/** Calls `act` once, when the element is less than a window's height from what is seen. */
function whenNear(element, act) {
  waiting.set(element, act);
  nearby.unobserve(element); // of one that is observed already nothing more would be said
  nearby.observe(element);
}

function makeNow(element) {
  const act = waiting.get(element);
  waiting.delete(element);
  nearby.unobserve(element);
  act?.();
}

function makeAll() {
  for (const element of [...waiting.keys()]) makeNow(element);
}

/** A picture that is read when it comes near. */
function distantImage(source, attributes) {
  const image = make("img", { ...attributes, draggable: "false" });
  whenNear(image, () => { image.src = source; });
  return image;
}

function changeSource(image, source) {
  const act = () => { image.src = source; };
  if (waiting.has(image)) waiting.set(image, act);
  else act();
}
