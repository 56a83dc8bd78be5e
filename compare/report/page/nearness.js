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

const unread = new Map(); // of each picture where it is read from

/** A picture that showImages() shows. */
function distantImage(source, attributes) {
  const image = make("img", { ...attributes, draggable: "false" });
  unread.set(image, source);
  return image;
}

function showImages(element) {
  for (const image of element.querySelectorAll("img")) {
    if (unread.has(image)) image.src = unread.get(image);
    unread.delete(image);
  }
}

function changeSource(image, source) {
  if (unread.has(image)) unread.set(image, source);
  else image.src = source;
}
